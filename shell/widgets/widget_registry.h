// SPDX-License-Identifier: MIT
// The widgets on the canvas, for tests, scripts and assistive tools: identity, role, value, state and
// rectangle of each. Rectangles come from Dear ImGui's test-engine hooks, everything else from our widgets.
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

/// The range of a slider or a number field.
struct WidgetRange {
  double low = 0.0;
  double high = 0.0;
  double step = 0.0;  // 0: no fixed step
  double now = 0.0;
};

struct Widget {
  std::string id = {};     // stable and unique, e.g. "search/start"
  std::string label = {};  // human-readable name
  std::string role =
      {};  // an ARIA role: button, radio, slider, switch, tab, combobox, option, spinbutton, img...
  std::string value = {};    // as shown, e.g. "0.80 s"
  std::string why_not = {};  // why it is disabled; empty: the table of hints may know
  WidgetState state = {};
  std::optional<WidgetRange> range = {};
  ImRect rect = {};      // the visible part, else the nearest edge of the visible area [points]
  bool in_sight = true;  // false: scrolled out of view
  int part = -1;         // index in WidgetRegistry::Parts; -1: none
};

/// What the widget does, and why it is disabled; empty: unknown.
[[nodiscard]] std::string HintFor(const Widget&);

/// A named part of the canvas, such as a panel or a group of options. Parts may be nested.
struct WidgetPart {
  std::string id = {};
  std::string label = {};
  std::string role = {};  // an ARIA role: region, group, tablist, tabpanel, radiogroup, listbox
  int parent = -1;
  int texts = 0;  // in it so far
};

class WidgetRegistry {
 public:
  /// Makes Dear ImGui's current context report to this registry.
  void Attach();

  /// @param scale CSS pixels per point of the canvas
  void SetScale(float scale) { scale_ = scale; }

  /// Call after ImGui::NewFrame, before any widget is drawn.
  void BeginFrame();
  /// Called by the hooks for each item that is laid out.
  void OnItem(ImGuiID, const ImRect&);
  /// Called by our widgets after the item, to describe it.
  void Describe(ImGuiID, Widget);
  /// Describes text on the canvas: a "heading", a "paragraph" or a "tooltip".
  void DescribeText(std::string_view role, std::string_view text, const ImRect&);
  /// Widgets described until LeavePart belong to this part.
  void EnterPart(WidgetPart);
  void LeavePart();
  void EndFrame();

  /// In drawing order, which is the order of the Tab key. Includes widgets scrolled out of view.
  [[nodiscard]] const std::vector<Widget>& Widgets() const { return widgets_; }
  [[nodiscard]] const std::vector<WidgetPart>& Parts() const { return parts_; }
  /// Null if the widget was not drawn in the last frame.
  [[nodiscard]] const Widget* Find(std::string_view id) const;
  /// The topmost widget under the pointer, or null. Disabled ones, too.
  [[nodiscard]] const Widget* Pointed() const { return At(pointed_); }
  /// The widget with the focus, or null.
  [[nodiscard]] const Widget* Focused() const;
  /// Whether the Tab key can move from the focused widget to another one, visible or not.
  [[nodiscard]] bool StopsBeyondFocus(bool back) const;

  /// The visible widgets, without texts. Rectangles are in CSS pixels.
  [[nodiscard]] std::string Json() const;
  /// Everything, for the page's mirror: {keyboard, waiting, parts, widgets}.
  [[nodiscard]] std::string MirrorJson() const;

  [[nodiscard]] WidgetRequests& Requests() { return requests_; }
  [[nodiscard]] const WidgetRequests& Requests() const { return requests_; }

 private:
  /// A click beside an open text field ends typing. The field itself would do so only when it is drawn, and
  /// widgets drawn before it would miss the click.
  void EndTypingByClick() const;

  [[nodiscard]] const Widget* At(int index) const {
    return index < 0 ? nullptr : &widgets_[static_cast<std::size_t>(index)];
  }

  std::unordered_map<ImGuiID, ImRect> rects_;
  std::vector<Widget> widgets_;
  float scale_ = 1.0f;
  std::vector<ImGuiID> ids_;  // of widgets_, in the same order; 0: a text
  std::vector<WidgetPart> parts_;
  int part_ = -1;          // the part being drawn
  int pointed_ = -1;       // index in widgets_
  int texts_ = 0;          // outside all parts in this frame
  bool keyboard_ = false;  // whether the focused widget shows its focus ring
  WidgetRequests requests_;
};

/// Marks a part of the canvas during the object's lifetime.
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
