// SPDX-License-Identifier: MIT
// Every interactive thing on the canvas. Each widget draws itself in our look, works by mouse, touch and
// keyboard, shows a focus ring, and tells the WidgetRegistry what it is. Callers say where: layout is plain
// rectangles.
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

/// What an interactive area takes besides a press.
enum class Grab {
  kNothing,  // only says what it is: text that tools read
  kPress,    // a click, Enter or the space bar
  kDrag,     // reports `held` from the moment the pointer goes down
  kArrows,   // kDrag, and the left and right arrow keys (10 steps with Shift)
};

/// What happened to an interactive area this frame.
struct Touch {
  ImGuiID id = 0;
  bool visible = false;
  bool hovered = false;
  bool held = false;
  bool began = false;                 // held, and was not before
  bool pressed = false;               // clicked or activated by key
  bool focused = false;               // has the keyboard, and the keyboard is in use
  int steps = 0;                      // arrow keys: left negative
  std::optional<double> wanted = {};  // a number asked for by other means than pointer and keys
};

/// An interval in [0, 1] of its track, drawn in its colour.
struct SliderInterval {
  float low, high;
  std::string low_text, high_text;  // the ends as a person reads them
  float mark = -1.0f;               // a value that moves in it; below 0: none
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

  /// For large areas that lie behind everything; the window itself has the colour of panels.
  [[nodiscard]] Backdrop& Behind() { return backdrop_; }

  /// From now on what is drawn can be read and unfolded, but changes nothing.
  void Lock(bool locked) { locked_ = locked; }
  /// Says so, above what is locked.
  void LockNote() const;

  // Layout in a panel: rows from the top down, as wide as the panel.
  [[nodiscard]] ImRect Row(float height) const;
  [[nodiscard]] ImRect ControlRow() const { return Row(theme_.ControlHeight()); }
  void Gap(float height) const;
  void Heading(std::string_view text) const;
  void Paragraph(std::string_view text, Type type = Type::kBody) const;
  void Paragraph(std::string_view text, ImU32 colour, Type type = Type::kBody) const;
  /// A caption left, a value right.
  void Fact(std::string_view label, std::string_view value) const;

  // Widgets. `id` is stable and unique; `label` is what a person reads or hears.
  /// @param heard  the label in full, where the place says the rest; empty: the label
  bool Button(std::string_view id, const ImRect&, std::string_view label, ButtonLook = ButtonLook::kOutlined,
              bool enabled = true, std::string_view heard = {});
  bool IconButton(std::string_view id, const ImRect&, Icon, std::string_view label,
                  ButtonLook = ButtonLook::kPlain, bool enabled = true);
  /// A few options side by side, translated here; the label is heard, not seen. @return true when `selected`
  /// changed
  bool Segmented(std::string_view id, const ImRect&, std::string_view label,
                 std::span<const char* const> options, int& selected);
  /// Label and value above a thin track; takes its own rows. A click on the value, or Enter, types it.
  /// @return true when `value` changed
  bool Slider(std::string_view id, std::string_view label, double& value, const SliderRange&,
              std::string_view value_text);
  /// The same in one row.
  bool LineSlider(std::string_view id, std::string_view label, double& value, const SliderRange&,
                  std::string_view value_text, ImU32 colour);
  /// Two ends that never cross, each by pointer and by key, as widgets `id`/low and `id`/high; a row of its
  /// own.
  /// @return true when an end changed
  bool IntervalSlider(std::string_view id, std::string_view label, SliderInterval&, ImU32 colour);
  /// A whole number with a step down and up; a click on the number types it.
  bool Number(std::string_view id, std::string_view label, int& value, int low, int high, int step = 1);
  bool Switch(std::string_view id, std::string_view label, bool& on);
  /// @param other shown when nothing of the list is selected (-1)
  bool Combo(std::string_view id, std::string_view label, std::span<const std::string> options, int& selected,
             std::string_view other = "");
  /// @param names translated here
  bool Tabs(std::string_view id, const ImRect&, std::string_view label, std::span<const char* const> names,
            int& selected);

  /// A thin bar in the right padding of the current window, when its contents are longer than it. Call it
  /// last.
  void ScrollBar(std::string_view id);

  /// A finger that moves up or down over the current window scrolls it, unless it holds something that is
  /// dragged itself.
  void ScrollByTouch() const;

  /// Anything else: registers an area, and the caller draws it. Call DrawFocus afterwards.
  Touch Area(std::string_view id, const ImRect&, Grab, Widget description, bool enabled = true);
  void DrawFocus(const Touch&, const ImRect&, float radius = kCornerRadius) const;

  /// Text that the caller draws itself, for whoever reads the canvas without seeing it.
  void Tell(std::string_view text, const ImRect&) const;
  /// What is drawn while the result lives belongs together, under this name. @param role as of WidgetPart
  [[nodiscard]] PartScope Part(std::string_view id, std::string_view role, std::string_view label) {
    return {registry_, {.id = std::string(id), .label = std::string(label), .role = std::string(role)}};
  }

  /// Fill and one-pixel border with rounded corners.
  void Frame(const ImRect&, ImU32 fill, ImU32 border, float radius = kCornerRadius) const;
  void HorizontalLine(float left, float right, float y) const;
  void VerticalLine(float x, float top, float bottom) const;

 private:
  void TakeKeyboard(const ImRect&, ImGuiID, bool ring) const;
  /// A finger that comes down on a slider may be about to scroll: it counts once it goes sideways, or when it
  /// is lifted where it came down.
  void AwaitFinger(Touch&, bool was_held) const;
  ImU32 ButtonInk(ButtonLook, const ImRect&, const Touch&, bool enabled) const;
  void DrawKnob(ImVec2 centre, const Touch&, ImU32 colour) const;

  struct SliderPlaces {
    ImRect row;     // all of it: takes the pointer
    ImRect track;   // of the knob
    ImRect reach;   // where that is had, but for the number
    ImRect number;  // beside the label or the track
    ImU32 colour;
  };
  bool Slide(std::string_view id, std::string_view label, double& value, const SliderRange&,
             std::string_view value_text, const SliderPlaces&);
  /// Dear ImGui's text field in the place of a number, from the frame on that asks for it until Enter, Escape
  /// or a click elsewhere; the value follows what is typed, where that is a number.
  void TypedValue(std::string_view id, std::string_view label, const ImRect& field, double& value,
                  const SliderRange&);

  const Theme& theme_;
  bool locked_ = false;
  WidgetRegistry& registry_;
  Backdrop& backdrop_;
};

}  // namespace gaitsmith::shell
