// SPDX-License-Identifier: MIT
// All interactive widgets of the canvas. Each draws itself in our style, works by mouse, touch and keyboard,
// shows a focus ring, and describes itself to the WidgetRegistry. Callers provide rectangles for the layout.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shell/widgets/backdrop.h"
#include "shell/widgets/icons.h"
#include "shell/widgets/slider_range.h"
#include "shell/widgets/theme.h"
#include "shell/widgets/widget_registry.h"

namespace gaitsmith::shell {

enum class ButtonLook { kPlain, kOutlined, kPrimary };

/// The input that an interactive area accepts.
enum class Grab {
  kNothing,  // none: text that assistive tools read
  kPress,    // a click, Enter or the space bar
  kDrag,     // reports `held` as soon as the pointer goes down
  kArrows,   // kDrag, and the left and right arrow keys (10 steps with Shift)
};

/// The events of an interactive area in this frame.
struct Touch {
  ImGuiID id = 0;
  bool visible = false;
  bool hovered = false;
  bool held = false;
  bool began = false;                 // held now, but not in the previous frame
  bool pressed = false;               // clicked, or activated by key
  bool focused = false;               // has the focus, and the keyboard is in use
  int steps = 0;                      // arrow keys: left negative
  std::optional<double> wanted = {};  // a number requested by a script or a screen reader
};

/// An interval within [0, 1] on a slider's track.
struct SliderInterval {
  float low, high;
  std::string low_text, high_text;  // the ends, as text
  float mark = -1.0f;               // a value marked on the track; below 0: none
};

class Ui {
 public:
  Ui(const Theme& theme, WidgetRegistry& registry, Backdrop& backdrop)
      : theme_(theme), registry_(registry), backdrop_(backdrop) {}

  [[nodiscard]] const Theme& Look() const { return theme_; }
  [[nodiscard]] const Palette& Ink() const { return theme_.palette; }
  [[nodiscard]] const Fonts& Letters() const { return theme_.fonts; }
  /// The current window's draw list, set to anti-alias over one device pixel.
  [[nodiscard]] ImDrawList* Canvas() const;

  /// For large areas behind everything. The rest of the window has the panels' colour.
  [[nodiscard]] Backdrop& Behind() { return backdrop_; }

  /// While locked, widgets can be read and unfolded, but change nothing.
  void Lock(bool locked) { locked_ = locked; }
  /// Draws a note about the lock above the locked widgets.
  void LockNote() const;

  // Layout of a panel: rows from top to bottom, as wide as the panel.
  [[nodiscard]] ImRect Row(float height) const;
  [[nodiscard]] ImRect ControlRow() const { return Row(theme_.ControlHeight()); }
  void Gap(float height) const;
  void Heading(std::string_view text) const;
  void Paragraph(std::string_view text, Type type = Type::kBody) const;
  void Paragraph(std::string_view text, ImU32 colour, Type type = Type::kBody) const;
  /// Draws a caption at the left and a value at the right.
  void Fact(std::string_view label, std::string_view value) const;

  // Widgets. `id` is stable and unique. `label` is the visible text and the name for screen readers.
  /// @param accessible_name  the name for screen readers if the visible label is shortened; empty: the label
  bool Button(std::string_view id, const ImRect&, std::string_view label, ButtonLook = ButtonLook::kOutlined,
              bool enabled = true, std::string_view accessible_name = {});
  bool IconButton(std::string_view id, const ImRect&, Icon, std::string_view label,
                  ButtonLook = ButtonLook::kPlain, bool enabled = true);
  /// The button that a first visit begins with: primary, large, with an icon.
  bool LargeButton(std::string_view id, const ImRect&, Icon, std::string_view label);
  /// A few options side by side, which this function translates. The label is for screen readers.
  /// @param why_not  why the others cannot be chosen; empty: they can. @return true if `selected` changed
  bool Segmented(std::string_view id, const ImRect&, std::string_view label,
                 std::span<const char* const> options, int& selected, std::string_view why_not = {});
  /// Label and value above a thin track, on new rows. Click the value or press Enter to type it.
  /// @return true if `value` changed
  bool Slider(std::string_view id, std::string_view label, double& value, const SliderRange&,
              std::string_view value_text);
  /// As Slider, in one row.
  bool LineSlider(std::string_view id, std::string_view label, double& value, const SliderRange&,
                  std::string_view value_text, ImU32 colour);
  /// A slider with two ends that never cross, the widgets `id`/low and `id`/high, on a new row.
  /// @return true if an end changed
  bool IntervalSlider(std::string_view id, std::string_view label, SliderInterval&, ImU32 colour);
  /// A whole number with buttons for a step down and up. Click the number to type it.
  bool Number(std::string_view id, std::string_view label, int& value, int low, int high, int step = 1);
  bool Switch(std::string_view id, std::string_view label, bool& on);
  /// @param other text shown if no entry is selected (-1)
  bool Combo(std::string_view id, std::string_view label, std::span<const std::string> options, int& selected,
             std::string_view other = "");
  /// A button that opens a list of actions. @return the one that was pressed, or -1
  int Menu(std::string_view id, const ImRect&, std::string_view label, std::span<const std::string> actions);
  /// @param names  this function translates them. @return whether a tab was pressed, also the selected one
  bool Tabs(std::string_view id, const ImRect&, std::string_view label, std::span<const char* const> names,
            int& selected);

  /// A thin bar in the right padding of the current window, if its contents do not fit. Call it last.
  void ScrollBar(std::string_view id);

  /// Lets a finger scroll the current window, unless it drags a widget.
  void ScrollByTouch() const;

  /// Registers an area that the caller draws. Call DrawFocus afterwards.
  Touch Area(std::string_view id, const ImRect&, Grab, Widget description, bool enabled = true);
  void DrawFocus(const Touch&, const ImRect&, float radius = kCornerRadius) const;

  /// Registers text that the caller draws, for screen readers.
  void DescribeText(std::string_view text, const ImRect&) const;
  /// Groups everything drawn during the result's lifetime under this name. @param role as in WidgetPart
  [[nodiscard]] PartScope Part(std::string_view id, std::string_view role, std::string_view label) {
    return {registry_, {.id = std::string(id), .label = std::string(label), .role = std::string(role)}};
  }

  /// Fill and one-pixel border with rounded corners.
  void Frame(const ImRect&, ImU32 fill, ImU32 border, float radius = kCornerRadius) const;
  /// The frame of a card that can be chosen. @return its fill
  ImU32 CardFrame(const ImRect&, bool chosen, bool hovered) const;
  void HorizontalLine(float left, float right, float y) const;
  void VerticalLine(float x, float top, float bottom) const;

 private:
  void TakeKeyboard(const ImRect&, ImGuiID, bool ring) const;
  /// A touch on a slider may begin a scroll. It acts on the slider only when it moves sideways, or is lifted
  /// in place.
  void AwaitFinger(Touch&, bool was_held) const;
  /// The list of a combo box or a menu, if it is open. @param box  the list lies below or above it, as wide.
  /// @return the option that was pressed, or -1
  int PickFrom(const std::string& popup, const ImRect& box, std::string_view label,
               std::span<const std::string> options, int selected);
  ImU32 ButtonInk(ButtonLook, const ImRect&, const Touch&, bool enabled) const;
  void DrawKnob(ImVec2 centre, const Touch&, ImU32 colour) const;

  struct SliderPlaces {
    ImRect row;     // the whole row
    ImRect track;   // where the knob moves
    ImRect reach;   // the area that reacts to the pointer, without the number
    ImRect number;  // beside the label or the track
    ImU32 colour;
  };
  bool Slide(std::string_view id, std::string_view label, double& value, const SliderRange&,
             std::string_view value_text, const SliderPlaces&);
  /// Replaces a number by Dear ImGui's text field, from a request until Enter, Escape or a click elsewhere.
  /// The value follows the text whenever it is a valid number.
  void TypedValue(std::string_view id, std::string_view label, const ImRect& field, double& value,
                  const SliderRange&);

  const Theme& theme_;
  bool locked_ = false;
  WidgetRegistry& registry_;
  Backdrop& backdrop_;
};

}  // namespace gaitsmith::shell
