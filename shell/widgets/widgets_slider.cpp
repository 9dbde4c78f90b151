// SPDX-License-Identifier: MIT
// Sliders for one value, in one or two rows, with a number that can be typed.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "shell/widgets/widgets.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

/// A number as it is typed on a keyboard, with the keyboard's minus.
std::string Typable(std::string text) {
  if (text.starts_with(kMinus)) text.replace(0, kMinus.size(), "-");
  return text;
}

// Parses a typed number: digits, a sign, a point or a comma. @return false: not a number yet
bool Parse(const char* text, double& number) {
  std::string plain = Typable(text);
  std::replace(plain.begin(), plain.end(), ',', '.');
  char* end = nullptr;
  const double read = std::strtod(plain.c_str(), &end);
  if (end == plain.c_str() || *end != '\0' || !std::isfinite(read)) return false;
  number = read;
  return true;
}

// The number of decimals of the slider's grid.
int DecimalsOf(const SliderRange& range) {
  int decimals = 0;
  for (double step = range.step; decimals < 6 && std::abs(step - std::round(step)) > 1e-9; step *= 10.0)
    ++decimals;
  return decimals;
}

// The value of a slider before typing, in the window's storage, which has no doubles.
constexpr ImGuiID kBeforeKey = 0x6265666f;
void StoreBefore(ImGuiID widget, double value) {
  const auto bits = std::bit_cast<std::array<int, 2>>(value);
  ImGui::GetStateStorage()->SetInt(widget + kBeforeKey, bits[0]);
  ImGui::GetStateStorage()->SetInt(widget + kBeforeKey + 1, bits[1]);
}
double ValueBefore(ImGuiID widget) {
  const ImGuiStorage& storage = *ImGui::GetStateStorage();
  return std::bit_cast<double>(
      std::array{storage.GetInt(widget + kBeforeKey), storage.GetInt(widget + kBeforeKey + 1)});
}

constexpr float kTrack = 4.0f;  // height of the track
constexpr float kFieldWidth = 84.0f;

}  // namespace

void Ui::TypedValue(std::string_view id, std::string_view label, const ImRect& field, double& value,
                    const SliderRange& range) {
  const std::string name(id);
  const ImGuiID widget = ImGui::GetID(name.c_str());
  char text[32];
  std::snprintf(text, sizeof text, "%s", Typable(Fixed(value, DecimalsOf(range))).c_str());
  ImGui::ItemAdd(field, widget, nullptr, ImGuiItemFlags_Inputable);
  registry_.Describe(widget, {.id = name,
                              .label = std::string(label),
                              .role = "textbox",
                              .value = text,
                              .state = {.focused = true},
                              .range = WidgetRange{range.low, range.high, 0.0, value}});
  if (!ImGui::TempInputIsActive(widget)) {  // opens the field, whatever requested it
    ImGuiContext& g = *ImGui::GetCurrentContext();
    StoreBefore(widget, value);
    g.NavActivateId = widget;
    g.NavActivateFlags |= ImGuiActivateFlags_PreferInput;
  }
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6.0f, 0.5f * (field.GetHeight() - ImGui::GetFontSize())});
  ImGui::PushClipRect(field.Min, field.Max,
                      true);  // hides the label that Dear ImGui draws after a field
  const bool edited =
      ImGui::TempInputText(field, widget, name.c_str(), text, sizeof text,
                           ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CharsDecimal);
  ImGui::PopClipRect();
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(cursor);
  Canvas()->AddRect(field.Min, field.Max, Ink().accent, 3.0f, 0, 2.0f);
  if (double number = 0.0; edited && Parse(text, number)) value = range.Nearest(number);
  // On Escape the field restores its own text, which is rounded. Restore the value from before typing.
  if (ImGui::IsKeyPressed(ImGuiKey_Escape, false)) value = ValueBefore(widget);
}

bool Ui::Slider(std::string_view id, std::string_view label, double& value, const SliderRange& range,
                std::string_view value_text) {
  const float label_height = Fonts::LineHeight(Type::kBody) + 4.0f;
  const ImRect row = Row(label_height + (theme_.touch ? 26.0f : 18.0f));
  const float label_bottom = row.Min.y + label_height;
  return Slide(id, label, value, range, value_text,
               {.row = row,
                .track = {{row.Min.x, label_bottom}, row.Max},
                .reach = {{row.Min.x, row.Min.y + 0.5f * label_height}, row.Max},
                .number = {{row.Max.x - kFieldWidth, row.Min.y}, {row.Max.x, label_bottom}},
                .colour = Ink().accent});
}

bool Ui::LineSlider(std::string_view id, std::string_view label, double& value, const SliderRange& range,
                    std::string_view value_text, ImU32 colour) {
  constexpr float kLabelWidth = 66.0f, kNumberWidth = 50.0f;
  const ImRect row = ControlRow();
  const ImRect track({row.Min.x + kLabelWidth, row.Min.y}, {row.Max.x - kNumberWidth, row.Max.y});
  return Slide(id, label, value, range, value_text,
               {.row = row,
                .track = track,
                .reach = track,
                .number = {{track.Max.x, row.Min.y}, row.Max},
                .colour = colour});
}

bool Ui::Slide(std::string_view id, std::string_view label, double& value, const SliderRange& range,
               std::string_view value_text, const SliderPlaces& at) {
  const double before = value;
  const bool typing =
      ImGui::TempInputIsActive(ImGui::GetCurrentWindow()->GetID(id.data(), id.data() + id.size()));
  Touch touch;
  if (!typing) {
    touch = Area(id, at.row, Grab::kArrows,
                 {.label = std::string(label),
                  .role = "slider",
                  .value = std::string(value_text),
                  .range = WidgetRange{range.low, range.high, range.logarithmic ? 0.0 : range.step, value}});
    if (!touch.visible) return false;
  }

  // The knob's centre stays inside the track's rounded ends.
  const float left = at.track.Min.x + kKnobRadius;
  const float right = at.track.Max.x - kKnobRadius;
  const ImVec2 down = ImGui::GetIO().MouseClickedPos[0];
  if (touch.held && at.reach.Contains(down) && !at.number.Contains(down)) {
    const float share = std::clamp((ImGui::GetIO().MousePos.x - left) / (right - left), 0.0f, 1.0f);
    value = range.ValueAt(static_cast<double>(share));
  }
  if (touch.steps != 0) value = range.Stepped(value, touch.steps);
  if (touch.wanted) value = range.Nearest(*touch.wanted);

  const auto x_of = [&](double v) { return left + static_cast<float>(range.ShareOf(v)) * (right - left); };
  const float y = at.track.GetCenter().y;
  ImDrawList* list = Canvas();
  Letters().Draw(list, Type::kBody, {at.row.Min.x, at.number.GetCenter().y}, Ink().ink, label);
  list->AddRectFilled({at.track.Min.x, y - 0.5f * kTrack}, {at.track.Max.x, y + 0.5f * kTrack}, Ink().soft,
                      2.0f);
  // A range across zero is filled from zero, so that the value 0 shows no fill.
  const float x = x_of(value), zero = range.low < 0.0 && range.high > 0.0 ? x_of(0.0) : at.track.Min.x;
  list->AddRectFilled({std::min(zero, x), y - 0.5f * kTrack}, {std::max(zero, x), y + 0.5f * kTrack},
                      at.colour, 2.0f);
  DrawKnob({x, y}, touch, at.colour);

  const bool opens = touch.pressed && touch.steps == 0 && !touch.wanted &&
                     (!touch.began || (at.number.Contains(down) && !theme_.touch));
  if (typing || opens) {
    TypedValue(id, label, at.number, value, range);
  } else {
    Letters().Draw(list, Type::kBody, {at.row.Max.x, at.number.GetCenter().y}, Ink().second_ink, value_text,
                   Align::kRight);
  }
  return value != before;
}

}  // namespace gaitsmith::shell
