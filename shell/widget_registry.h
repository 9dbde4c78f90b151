// SPDX-License-Identifier: MIT
// What is on the canvas right now, for tests, scripts and assistive tools: every visible widget with
// identity, role, value, state and rectangle. Rectangles come from Dear ImGui's test-engine hooks, meaning
// from our widgets.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gaitsmith::shell {

struct WidgetState {
  bool focused = false;
  bool disabled = false;
  std::optional<bool> pressed = {};   // toggles
  std::optional<bool> selected = {};  // tabs, options, cards
  std::optional<bool> checked = {};   // switches
  std::optional<bool> expanded = {};  // comboboxes
};

struct Widget {
  std::string id = {};     // stable and unique, e.g. "search/start"
  std::string label = {};  // as a person reads it
  std::string role =
      {};  // an ARIA role: button, radio, slider, switch, tab, combobox, option, spinbutton, img...
  std::string value = {};  // as shown, e.g. "0.80 s"
  WidgetState state = {};
  ImRect rect = {};  // the visible part, in points of the canvas
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
  /// From our widgets, after the item: what it is. Widgets whose visible part is empty are left out.
  void Describe(ImGuiID, Widget);

  /// In the order of drawing, which is the order of the Tab key.
  [[nodiscard]] const std::vector<Widget>& Widgets() const { return widgets_; }
  /// Whether the Tab key has somewhere to go from the focused widget, scrolled out of sight or not.
  [[nodiscard]] bool StopsBeyondFocus(bool back) const;
  /// Rectangles in CSS pixels.
  [[nodiscard]] std::string Json() const;

 private:
  std::unordered_map<ImGuiID, ImRect> rects_;
  std::vector<Widget> widgets_;
  float scale_ = 1.0f;
  int stops_before_focus_ = 0;
  int stops_after_focus_ = 0;
  bool focus_seen_ = false;
};

}  // namespace gaitsmith::shell
