// SPDX-License-Identifier: MIT
// The registry's bookkeeping, its JSON, and the functions Dear ImGui calls when built with
// IMGUI_ENABLE_TEST_ENGINE.
#include "shell/widget_registry.h"

#include <cstdio>

#include "core/document/json_value.h"

namespace gaitsmith::shell {
namespace {

void AppendFlag(std::string& json, const char* name, std::optional<bool> flag) {
  if (!flag) return;
  if (json.back() != '{') json += ',';
  json += '"';
  json += name;
  json += *flag ? "\":true" : "\":false";
}

}  // namespace

void WidgetRegistry::Attach() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.TestEngine = this;
  context.TestEngineHookItems = true;
}

void WidgetRegistry::BeginFrame() {
  rects_.clear();
  widgets_.clear();
  stops_before_focus_ = stops_after_focus_ = 0;
  focus_seen_ = false;
}

void WidgetRegistry::OnItem(ImGuiID id, const ImRect& rect) { rects_[id] = rect; }

void WidgetRegistry::Describe(ImGuiID id, Widget widget) {
  const auto found = rects_.find(id);
  if (found == rects_.end()) return;
  // Scroll bars and notes are there to be seen; the Tab key passes over them.
  const bool stops = !widget.state.disabled && widget.role != "scrollbar" && widget.role != "note";
  if (widget.state.focused) {
    focus_seen_ = true;
  } else if (stops) {
    ++(focus_seen_ ? stops_after_focus_ : stops_before_focus_);
  }
  widget.rect = found->second;
  widget.rect.ClipWithFull(ImGui::GetCurrentWindowRead()->ClipRect);
  if (widget.rect.GetWidth() < 1.0f || widget.rect.GetHeight() < 1.0f) return;
  widgets_.push_back(std::move(widget));
}

bool WidgetRegistry::StopsBeyondFocus(bool back) const {
  return (back ? stops_before_focus_ : stops_after_focus_) > 0;
}

std::string WidgetRegistry::Json() const {
  std::string json = "[";
  for (const Widget& widget : widgets_) {
    if (json.size() > 1) json += ",\n";
    json += "{\"id\":" + QuoteJson(widget.id) + ",\"label\":" + QuoteJson(widget.label) +
            ",\"role\":" + QuoteJson(widget.role) + ",\"value\":" + QuoteJson(widget.value) + ",\"state\":{";
    AppendFlag(json, "focused", widget.state.focused);
    AppendFlag(json, "disabled", widget.state.disabled);
    AppendFlag(json, "pressed", widget.state.pressed);
    AppendFlag(json, "selected", widget.state.selected);
    AppendFlag(json, "checked", widget.state.checked);
    AppendFlag(json, "expanded", widget.state.expanded);
    char rect[128];
    std::snprintf(rect, sizeof rect, "},\"rect\":{\"x\":%.1f,\"y\":%.1f,\"width\":%.1f,\"height\":%.1f}}",
                  static_cast<double>(widget.rect.Min.x * scale_),
                  static_cast<double>(widget.rect.Min.y * scale_),
                  static_cast<double>(widget.rect.GetWidth() * scale_),
                  static_cast<double>(widget.rect.GetHeight() * scale_));
    json += rect;
  }
  return json + "]";
}

}  // namespace gaitsmith::shell

void ImGuiTestEngineHook_ItemAdd(ImGuiContext* context, ImGuiID id, const ImRect& box,
                                 const ImGuiLastItemData*) {
  if (context->TestEngine == nullptr) return;
  static_cast<gaitsmith::shell::WidgetRegistry*>(context->TestEngine)->OnItem(id, box);
}

// Names, states and log lines come from our own widgets, which know more than Dear ImGui does.
void ImGuiTestEngineHook_ItemInfo(ImGuiContext*, ImGuiID, const char*, ImGuiItemStatusFlags) {}
void ImGuiTestEngineHook_Log(ImGuiContext*, const char*, ...) {}
const char* ImGuiTestEngine_FindItemDebugLabel(ImGuiContext*, ImGuiID) { return nullptr; }
