// SPDX-License-Identifier: MIT
// The registry's bookkeeping, and the functions Dear ImGui calls when built with IMGUI_ENABLE_TEST_ENGINE.
#include "shell/widgets/widget_registry.h"

#include <algorithm>
#include <string>
#include <utility>

#include "shell/words/hints.h"

namespace gaitsmith::shell {
namespace {

// Scroll bars, notes and texts are not reached by the Tab key.
bool Stops(const Widget& widget) {
  return widget.role != "scrollbar" && widget.role != "note" && widget.role != "heading" &&
         widget.role != "paragraph" && widget.role != "tooltip";
}

// A widget that is scrolled out of sight gets a rectangle on the edge of the visible part.
void ClipToSight(Widget& widget, const ImRect& sight) {
  const ImRect whole = widget.rect;
  widget.rect.ClipWithFull(sight);
  if (widget.rect.GetWidth() >= 1.0f && widget.rect.GetHeight() >= 1.0f) return;
  widget.in_sight = false;
  widget.rect.Min = {std::clamp(whole.Min.x, sight.Min.x, std::max(sight.Min.x, sight.Max.x - 1.0f)),
                     std::clamp(whole.Min.y, sight.Min.y, std::max(sight.Min.y, sight.Max.y - 1.0f))};
  widget.rect.Max = {
      std::clamp(whole.Max.x, widget.rect.Min.x + 1.0f, std::max(widget.rect.Min.x + 1.0f, sight.Max.x)),
      widget.rect.Min.y + 1.0f};
}

}  // namespace

std::string HintFor(const Widget& widget) {
  return HintFor(widget.id, widget.state.disabled, widget.why_not);
}

void WidgetRegistry::Attach() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.TestEngine = this;
  context.TestEngineHookItems = true;
}

void WidgetRegistry::BeginFrame() {
  EndTypingByClick();
  rects_.clear();
  widgets_.clear();
  ids_.clear();
  parts_.clear();
  part_ = pointed_ = -1;
  texts_ = 0;
  requests_.BeginFrame();
}

void WidgetRegistry::EndTypingByClick() const {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  if (g.ActiveId == 0 || g.ActiveId != g.TempInputId || !g.IO.MouseClicked[0]) return;
  const auto field = std::ranges::find(widgets_, "textbox", &Widget::role);
  if (field == widgets_.end() || !field->rect.Contains(g.IO.MousePos)) ImGui::ClearActiveID();
}

void WidgetRegistry::EndFrame() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  keyboard_ = !g.NavDisableHighlight;
  // The focus may have moved while the frame was drawn, and only one widget has it.
  for (std::size_t i = 0; i < widgets_.size(); ++i) {
    if (ids_[i] != 0) widgets_[i].state.focused = ids_[i] == g.NavId;
  }
  requests_.EndFrame();
}

void WidgetRegistry::OnItem(ImGuiID id, const ImRect& rect) { rects_[id] = rect; }

void WidgetRegistry::Describe(ImGuiID id, Widget widget) {
  const auto found = rects_.find(id);
  if (found == rects_.end()) return;
  widget.rect = found->second;
  widget.part = part_;
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  ClipToSight(widget, window->ClipRect);
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const bool pointed = g.HoveredWindow == window && widget.in_sight && widget.rect.Contains(g.IO.MousePos);
  if (!ids_.empty() && ids_.back() == id) {  // the widget has changed within the frame
    widgets_.back() = std::move(widget);
    return;
  }
  if (pointed) pointed_ = static_cast<int>(widgets_.size());
  widgets_.push_back(std::move(widget));
  ids_.push_back(id);
}

void WidgetRegistry::DescribeText(std::string_view role, std::string_view text, const ImRect& rect) {
  if (text.empty()) return;
  // Counted in its part, so that a text that comes or goes renames no others.
  std::string id = "text/";
  if (part_ >= 0) {
    WidgetPart& part = parts_[static_cast<std::size_t>(part_)];
    id.append(part.id).append("/").append(std::to_string(++part.texts));
  } else {
    id += std::to_string(++texts_);
  }
  Widget widget{.id = std::move(id), .label = std::string(text), .role = std::string(role)};
  widget.rect = rect;
  widget.part = part_;
  ClipToSight(widget, ImGui::GetCurrentWindowRead()->ClipRect);
  widgets_.push_back(std::move(widget));
  ids_.push_back(0);
}

void WidgetRegistry::EnterPart(WidgetPart part) {
  part.parent = part_;
  part_ = static_cast<int>(parts_.size());
  parts_.push_back(std::move(part));
}

void WidgetRegistry::LeavePart() {
  if (part_ >= 0) part_ = parts_[static_cast<std::size_t>(part_)].parent;
}

const Widget* WidgetRegistry::Find(std::string_view id) const {
  const auto found = std::ranges::find(widgets_, id, &Widget::id);
  return found == widgets_.end() ? nullptr : &*found;
}

const Widget* WidgetRegistry::Focused() const {
  const auto found = std::ranges::find_if(widgets_, [](const Widget& w) { return w.state.focused; });
  return found == widgets_.end() ? nullptr : &*found;
}

bool WidgetRegistry::StopsBeyondFocus(bool back) const {
  const auto focused = std::ranges::find_if(widgets_, [](const Widget& w) { return w.state.focused; });
  return back ? std::any_of(widgets_.begin(), focused, Stops)
              : focused != widgets_.end() && std::any_of(focused + 1, widgets_.end(), Stops);
}

}  // namespace gaitsmith::shell

void ImGuiTestEngineHook_ItemAdd(ImGuiContext* context, ImGuiID id, const ImRect& box,
                                 const ImGuiLastItemData*) {
  if (context->TestEngine == nullptr) return;
  static_cast<gaitsmith::shell::WidgetRegistry*>(context->TestEngine)->OnItem(id, box);
}

// Names, states and log lines come from our own widgets, which have more information than Dear ImGui.
void ImGuiTestEngineHook_ItemInfo(ImGuiContext*, ImGuiID, const char*, ImGuiItemStatusFlags) {}
void ImGuiTestEngineHook_Log(ImGuiContext*, const char*, ...) {}
const char* ImGuiTestEngine_FindItemDebugLabel(ImGuiContext*, ImGuiID) { return nullptr; }
