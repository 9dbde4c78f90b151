// SPDX-License-Identifier: MIT
// Widgets for a whole number, and for yes or no.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "shell/widgets/widgets.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

namespace {

/// Dear ImGui's text field in place of a number. The value follows the text whenever it is a whole number;
/// one that is too long becomes the largest there is.
void TypeNumber(const ImRect& field, ImGuiID id, const std::string& name, int& value) {
  std::array<char, 16> text{};
  std::to_chars(text.data(), text.data() + text.size() - 1, value);
  if (!ImGui::TempInputText(field, id, name.c_str(), text.data(), static_cast<int>(text.size()),
                            ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CharsDecimal))
    return;
  std::string_view typed(text.data());
  typed.remove_prefix(std::min(typed.find_first_not_of(" +"), typed.size()));
  const auto [end, fault] = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  if (fault == std::errc::result_out_of_range)
    value = typed.starts_with('-') ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
}

}  // namespace

bool Ui::Number(std::string_view id, std::string_view label, int& value, int low, int high, int step) {
  const Palette& p = Ink();
  const ImRect row = ControlRow();
  const float size = row.GetHeight();
  const ImRect plus({row.Max.x - size, row.Min.y}, row.Max);
  const ImRect field({plus.Min.x - 92.0f, row.Min.y}, {plus.Min.x, row.Max.y});
  const ImRect minus({field.Min.x - size, row.Min.y}, {field.Min.x, row.Max.y});
  const int before = value;
  Letters().Draw(Canvas(), Type::kBody, {row.Min.x, row.GetCenter().y}, p.ink, label);
  Frame({minus.Min, plus.Max}, p.panel, p.line);

  const std::string name(id);
  const std::string words(label);
  const WidgetRange range{static_cast<double>(low), static_cast<double>(high), static_cast<double>(step),
                          static_cast<double>(value)};
  if (IconButton(name + "/less", minus, Icon::kMinus, Tr("Less: {1}", words), ButtonLook::kPlain,
                 value > low)) {
    value -= step;
  }

  // A click or Enter on the number opens Dear ImGui's text field in its place.
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const ImGuiID field_id = window->GetID(id.data(), id.data() + id.size());
  if (ImGui::TempInputIsActive(field_id)) {
    ImGui::ItemAdd(field, field_id, nullptr, ImGuiItemFlags_Inputable);
    registry_.Describe(field_id, {.id = name,
                                  .label = words,
                                  .role = "textbox",
                                  .value = std::to_string(value),
                                  .state = {.focused = true},
                                  .range = range});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {10.0f, 0.5f * (field.GetHeight() - ImGui::GetFontSize())});
    ImGui::PushClipRect(field.Min, field.Max,
                        true);  // hides the label that Dear ImGui draws after a field
    TypeNumber(field, field_id, name, value);
    ImGui::PopClipRect();
    ImGui::PopStyleVar();
    Canvas()->AddRect(field.Min, field.Max, p.accent, 3.0f, 0, 2.0f);
  } else {
    const Touch touch =
        Area(id, field, Grab::kArrows,
             {.label = words, .role = "spinbutton", .value = std::to_string(value), .range = range});
    value += touch.steps * step;
    if (touch.wanted) value = static_cast<int>(std::lround(std::clamp(*touch.wanted, range.low, range.high)));
    if (touch.hovered) Canvas()->AddRectFilled(field.Min, field.Max, Mix(p.panel, p.ink, 0.05f));
    VerticalLine(field.Min.x, field.Min.y + 1.0f, field.Max.y - 1.0f);
    VerticalLine(field.Max.x - 1.0f, field.Min.y + 1.0f, field.Max.y - 1.0f);
    Letters().Draw(Canvas(), Type::kBody, field.GetCenter(), p.ink, std::to_string(value), Align::kCentre);
    DrawFocus(touch, field, 3.0f);
    if (touch.pressed && touch.steps == 0) {
      ImGui::PushClipRect(field.Min, field.Max, true);
      TypeNumber(field, field_id, name, value);
      ImGui::PopClipRect();
    }
  }
  if (IconButton(name + "/more", plus, Icon::kPlus, Tr("More: {1}", words), ButtonLook::kPlain,
                 value < high)) {
    value += step;
  }
  value = std::clamp(value, low, high);
  return value != before;
}

bool Ui::Switch(std::string_view id, std::string_view label, bool& on) {
  const Palette& p = Ink();
  const ImRect row = ControlRow();
  const Touch touch = Area(id, row, Grab::kPress,
                           {.label = std::string(label),
                            .role = "switch",
                            .value = Tr(on ? "on" : "off"),
                            .state = {.checked = on}});
  if (touch.pressed) on = !on;
  if (!touch.visible) return touch.pressed;
  ImDrawList* list = Canvas();
  const float y = row.GetCenter().y;
  Letters().Draw(list, Type::kBody, {row.Min.x, y}, p.ink, label);
  const ImRect track({row.Max.x - 34.0f, y - 9.0f}, {row.Max.x, y + 9.0f});
  list->AddRectFilled(track.Min, track.Max,
                      on ? p.accent : Mix(p.line, p.second_ink, touch.hovered ? 0.35f : 0.2f), 9.0f);
  list->AddCircleFilled({on ? track.Max.x - 9.0f : track.Min.x + 9.0f, y}, 7.0f, p.panel);
  DrawFocus(touch, track, 9.0f);
  return touch.pressed;
}

}  // namespace gaitsmith::shell
