// SPDX-License-Identifier: MIT
// The registry as JSON: visible widgets for scripts, all widgets for the page's mirror.
#include <cstdio>

#include "core/document/json_value.h"
#include "shell/widgets/widget_registry.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

void AppendFlag(std::string& json, const char* name, std::optional<bool> flag) {
  if (!flag) return;
  if (json.back() != '{') json += ',';
  json += '"';
  json += name;
  json += *flag ? "\":true" : "\":false";
}

// Without the closing brace, so that the caller can append members.
std::string WidgetMembers(const Widget& widget, float scale) {
  std::string json = "{\"id\":" + QuoteJson(widget.id) + ",\"label\":" + QuoteJson(widget.label) +
                     ",\"role\":" + QuoteJson(widget.role) + ",\"value\":" + QuoteJson(widget.value) +
                     ",\"state\":{";
  AppendFlag(json, "focused", widget.state.focused);
  AppendFlag(json, "disabled", widget.state.disabled);
  AppendFlag(json, "pressed", widget.state.pressed);
  AppendFlag(json, "selected", widget.state.selected);
  AppendFlag(json, "checked", widget.state.checked);
  AppendFlag(json, "expanded", widget.state.expanded);
  char rect[128];
  std::snprintf(rect, sizeof rect, "},\"rect\":{\"x\":%.1f,\"y\":%.1f,\"width\":%.1f,\"height\":%.1f}",
                static_cast<double>(widget.rect.Min.x * scale),
                static_cast<double>(widget.rect.Min.y * scale),
                static_cast<double>(widget.rect.GetWidth() * scale),
                static_cast<double>(widget.rect.GetHeight() * scale));
  return json + rect;
}

std::string RangeMember(const WidgetRange& range) {
  char json[160];
  std::snprintf(json, sizeof json, ",\"range\":{\"low\":%.10g,\"high\":%.10g,\"step\":%.10g,\"now\":%.10g}",
                range.low, range.high, range.step, range.now);
  return json;
}

bool IsText(const Widget& widget) { return widget.role == "heading" || widget.role == "paragraph"; }

}  // namespace

std::string WidgetRegistry::Json() const {
  std::string json = "[";
  for (const Widget& widget : widgets_) {
    if (!widget.in_sight || IsText(widget)) continue;
    if (json.size() > 1) json += ",\n";
    json += WidgetMembers(widget, scale_) + "}";
  }
  return json + "]";
}

std::string WidgetRegistry::MirrorJson() const {
  std::string json = std::string("{\"keyboard\":") + (keyboard_ ? "true" : "false") +
                     ",\"waiting\":" + (requests_.Waiting() ? "true" : "false") + ",\"parts\":[";
  for (const WidgetPart& part : parts_) {
    if (json.back() == '}') json += ",\n";
    json += "{\"id\":" + QuoteJson(part.id) + ",\"label\":" + QuoteJson(part.label) +
            ",\"role\":" + QuoteJson(part.role) + ",\"parent\":" + std::to_string(part.parent) + "}";
  }
  json += "],\"widgets\":[";
  for (const Widget& widget : widgets_) {
    if (widget.role == "tooltip") continue;  // the widget has its words
    if (json.back() == '}') json += ",\n";
    json += WidgetMembers(widget, scale_);
    if (widget.range) json += RangeMember(*widget.range);
    if (const std::string hint = HintFor(widget); !hint.empty())
      json += ",\"hint\":" + QuoteJson(Fill(hint, {widget.label, widget.value}));
    json += ",\"part\":" + std::to_string(widget.part) + "}";
  }
  return json + "]}";
}

}  // namespace gaitsmith::shell
