// SPDX-License-Identifier: MIT
// What is on the canvas right now, for tests, scripts and assistive tools: every visible widget with
// identity, role, value, state and rectangle. Rectangles come from Dear ImGui's test-engine hooks, meaning
// from our widgets.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "shell/widgets/widget_request.h"

namespace gaitsmith::shell {

struct WidgetState {
  bool focused = false;
  bool disabled = false;
  std::optional<bool> pressed = {};   // toggles
  std::optional<bool> selected = {};  // tabs, options, cards
  std::optional<bool> checked = {};   // switches
  std::optional<bool> expanded = {};  // comboboxes
};

/// The numbers that a slider or a field can stand at.
struct WidgetRange {
  double low = 0.0;
  double high = 0.0;
  double step = 0.0;  // 0: of no fixed size
  double now = 0.0;
};

struct Widget {
  std::string id = {};     // stable and unique, e.g. "search/start"
  std::string label = {};  // as a person reads it
  std::string role =
      {};  // an ARIA role: button, radio, slider, switch, tab, combobox, option, spinbutton, img...
  std::string value = {};  // as shown, e.g. "0.80 s"
  WidgetState state = {};
  std::optional<WidgetRange> range = {};
  ImRect rect = {};      // the visible part, in points of the canvas; else the nearest edge to it
  bool in_sight = true;  // false: scrolled away
  int part = -1;         // of WidgetRegistry::Parts
};

/// A named part of the canvas, maybe within another: a panel, a group of options.
struct WidgetPart {
  std::string id = {};
  std::string label = {};
  std::string role = {};  // an ARIA role: region, group, tablist, tabpanel, radiogroup, listbox
  int parent = -1;
};

class WidgetRegistry {
 public:
  /// Makes Dear ImGui's current context report to this registry.
  void Attach();

  /// CSS pixels for a point of the canvas.
  void SetScale(float scale) { scale_ = scale; }

  void BeginFrame();
  /// From the hooks: an item was laid out.
  void OnItem(ImGuiID, const ImRect&);
  /// From our widgets, after the item: what it is.
  void Describe(ImGuiID, Widget);
  /// Text that stands on the canvas: a "heading" or a "paragraph".
  void DescribeText(std::string_view role, std::string_view text, const ImRect&);
  /// What is described until LeavePart belongs together.
  void EnterPart(WidgetPart);
  void LeavePart();
  void EndFrame();

  /// In the order of drawing, which is the order of the Tab key; with those that are scrolled out of sight.
  [[nodiscard]] const std::vector<Widget>& Widgets() const { return widgets_; }
  [[nodiscard]] const std::vector<WidgetPart>& Parts() const { return parts_; }
  /// Null: it was not drawn in the last frame.
  [[nodiscard]] const Widget* Find(std::string_view id) const;
  /// Whether the Tab key has somewhere to go from the focused widget, scrolled out of sight or not.
  [[nodiscard]] bool StopsBeyondFocus(bool back) const;

  /// The widgets in sight, without texts. Rectangles in CSS pixels.
  [[nodiscard]] std::string Json() const;
  /// Everything, for the page's mirror of the canvas: {keyboard, waiting, parts, widgets}.
  [[nodiscard]] std::string MirrorJson() const;

  [[nodiscard]] WidgetRequests& Requests() { return requests_; }
  [[nodiscard]] const WidgetRequests& Requests() const { return requests_; }

 private:
  std::unordered_map<ImGuiID, ImRect> rects_;
  std::vector<Widget> widgets_;
  float scale_ = 1.0f;
  std::vector<ImGuiID> ids_;  // of widgets_; 0: of a text
  std::vector<WidgetPart> parts_;
  int part_ = -1;          // that is being drawn
  int texts_ = 0;          // so far
  bool keyboard_ = false;  // what has the keyboard shows it
  WidgetRequests requests_;
};

/// A part of the canvas for as long as it lives.
class PartScope {
 public:
  PartScope(WidgetRegistry& registry, WidgetPart part) : registry_(registry) {
    registry_.EnterPart(std::move(part));
  }
  ~PartScope() { registry_.LeavePart(); }
  PartScope(const PartScope&) = delete;
  PartScope& operator=(const PartScope&) = delete;

 private:
  WidgetRegistry& registry_;
};

}  // namespace gaitsmith::shell
