// SPDX-License-Identifier: MIT
// Widgets to choose one of several: segmented toggle, combo box, tabs.
#include <algorithm>

#include "shell/widgets/widgets.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

namespace {

constexpr float kChevronRoom = 18.0f;  // of a menu's arrow

}  // namespace

bool Ui::Segmented(std::string_view id, const ImRect& rect, std::string_view label,
                   std::span<const char* const> options, int& selected, std::string_view why_not) {
  const PartScope part_of = Part(id, "radiogroup", label);
  const Palette& p = Ink();
  ImDrawList* list = Canvas();
  list->AddRectFilled(rect.Min, rect.Max, p.soft, 8.0f);
  const float width = (rect.GetWidth() - 6.0f) / static_cast<float>(options.size());
  bool changed = false;
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const char* option = Tr(options[static_cast<std::size_t>(i)]);
    const ImRect part({rect.Min.x + 3.0f + width * static_cast<float>(i), rect.Min.y + 3.0f},
                      {rect.Min.x + 3.0f + width * static_cast<float>(i + 1), rect.Max.y - 3.0f});
    const bool on = i == selected;
    const bool free = on || why_not.empty();
    const Touch touch = Area(std::string(id) + "/" + std::to_string(i), part, Grab::kPress,
                             {.label = option,
                              .role = "radio",
                              .why_not = free ? "" : std::string(why_not),
                              .state = {.checked = on}},
                             free);
    if (touch.pressed && !on) {
      selected = i;
      changed = true;
    }
    if (on) {
      list->AddRectFilled({part.Min.x, part.Min.y + 1.0f}, {part.Max.x, part.Max.y + 1.5f},
                          IM_COL32(0, 0, 0, 26), 6.5f);
      list->AddRectFilled(part.Min, part.Max, p.panel, 6.0f);
    }
    Letters().Draw(list, on ? Type::kStrong : Type::kBody, part.GetCenter(),
                   !free                 ? Mix(p.soft, p.second_ink, 0.6f)
                   : on || touch.hovered ? p.ink
                                         : p.second_ink,
                   option, Align::kCentre);
    DrawFocus(touch, part, 6.0f);
  }
  return changed;
}

bool Ui::Combo(std::string_view id, std::string_view label, std::span<const std::string> options,
               int& selected, std::string_view other) {
  const Palette& p = Ink();
  const ImRect row = ControlRow();
  const float label_width = label.empty() ? 0.0f : Letters().Width(Type::kBody, label) + 12.0f;
  const float width = std::min(row.GetWidth() - label_width, label.empty() ? row.GetWidth() : 190.0f);
  const ImRect box({row.Max.x - width, row.Min.y}, row.Max);
  const std::string popup(id);
  const std::string shown = selected >= 0 && selected < static_cast<int>(options.size())
                                ? options[static_cast<std::size_t>(selected)]
                                : std::string(other);
  const bool open = ImGui::IsPopupOpen(popup.c_str());
  const Touch touch = Area(id, box, Grab::kPress,
                           {.label = label.empty() ? Tr("Choose") : std::string(label),
                            .role = "combobox",
                            .value = shown,
                            .state = {.expanded = open}});
  if (touch.pressed) ImGui::OpenPopup(popup.c_str());
  if (touch.visible) {
    ImDrawList* list = Canvas();
    if (!label.empty()) Letters().Draw(list, Type::kBody, {row.Min.x, row.GetCenter().y}, p.ink, label);
    Frame(box, Mix(p.panel, p.ink, touch.hovered ? 0.04f : 0.0f), p.line);
    Letters().DrawElided(list, Type::kBody, {box.Min.x + 10.0f, box.GetCenter().y}, box.GetWidth() - 36.0f,
                         p.ink, shown);
    DrawIcon(list, Icon::kChevronDown, {box.Max.x - 15.0f, box.GetCenter().y}, 12.0f, p.second_ink);
    DrawFocus(touch, box);
  }

  const int picked = PickFrom(popup, box, label.empty() ? Tr("Choose") : label, options, selected);
  const bool changed = picked >= 0 && picked != selected;
  if (changed) selected = picked;
  return changed;
}

int Ui::Menu(std::string_view id, const ImRect& rect, std::string_view label,
             std::span<const std::string> actions) {
  const std::string popup(id);
  const bool open = ImGui::IsPopupOpen(popup.c_str());
  const Touch touch = Area(id, rect, Grab::kPress,
                           {.label = std::string(label), .role = "button", .state = {.expanded = open}});
  if (touch.pressed) ImGui::OpenPopup(popup.c_str());
  if (touch.visible) {
    const ImU32 ink = ButtonInk(ButtonLook::kOutlined, rect, touch, true);
    const float across = Letters().Width(Type::kBody, label);
    const float left = rect.GetCenter().x - 0.5f * (across + kChevronRoom);
    Letters().Draw(Canvas(), Type::kBody, {left, rect.GetCenter().y}, ink, label);
    DrawIcon(Canvas(), Icon::kChevronUp, {left + across + 12.0f, rect.GetCenter().y}, 12.0f, ink);
    DrawFocus(touch, rect);
  }
  float width = rect.GetWidth();
  for (const std::string& action : actions)
    width = std::max(width, Letters().Width(Type::kBody, action) + 44.0f);
  return PickFrom(popup, {{rect.Max.x - width, rect.Min.y}, rect.Max}, label, actions, -1);
}

int Ui::PickFrom(const std::string& popup, const ImRect& box, std::string_view label,
                 std::span<const std::string> options, int selected) {
  int picked = -1;
  const float height = theme_.ControlHeight() * static_cast<float>(options.size()) + 10.0f;
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const bool below = box.Max.y + 4.0f + height < room.y;
  ImGui::SetNextWindowPos(
      {std::max(4.0f, box.Min.x), below ? box.Max.y + 4.0f : std::max(4.0f, box.Min.y - 4.0f - height)});
  ImGui::SetNextWindowSize({box.GetWidth(), height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {5.0f, 5.0f});
  if (ImGui::BeginPopup(popup.c_str(), ImGuiWindowFlags_NoMove)) {
    const PartScope part = Part(popup + "/list", "listbox", label);
    for (int i = 0; i < static_cast<int>(options.size()); ++i) {
      const std::string& option = options[static_cast<std::size_t>(i)];
      const ImRect line = ControlRow();
      const Touch pick = Area(popup + "/" + std::to_string(i), line, Grab::kPress,
                              {.label = option, .role = "option", .state = {.selected = i == selected}});
      ImDrawList* list = Canvas();
      if (pick.hovered || pick.focused) list->AddRectFilled(line.Min, line.Max, Ink().soft, 6.0f);
      Letters().DrawElided(list, i == selected ? Type::kStrong : Type::kBody,
                           {line.Min.x + 8.0f, line.GetCenter().y}, line.GetWidth() - 34.0f, Ink().ink,
                           option);
      if (i == selected)
        DrawIcon(list, Icon::kCheck, {line.Max.x - 14.0f, line.GetCenter().y}, 12.0f, Ink().accent);
      if (pick.pressed) {
        picked = i;
        ImGui::CloseCurrentPopup();
      }
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  return picked;
}

bool Ui::Tabs(std::string_view id, const ImRect& rect, std::string_view label,
              std::span<const char* const> names, int& selected) {
  const PartScope part_of = Part(id, "tablist", label);
  const Palette& p = Ink();
  ImDrawList* list = Canvas();
  HorizontalLine(rect.Min.x, rect.Max.x, rect.Max.y - 1.0f);
  float x = rect.Min.x + 8.0f;
  // On narrow phones the gaps between names are smaller.
  float letters = 0.0f;
  for (const char* name : names) letters += Letters().Width(Type::kStrong, Tr(name));
  const float spare = (rect.GetWidth() - 16.0f - letters) / static_cast<float>(names.size());
  const float padding = std::clamp(spare, 4.0f, theme_.touch ? 16.0f : 15.0f);
  bool pressed = false;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const char* name = Tr(names[static_cast<std::size_t>(i)]);
    const bool on = i == selected;
    const float width = Letters().Width(on ? Type::kStrong : Type::kBody, name) + padding;
    const ImRect part({x, rect.Min.y}, {x + width, rect.Max.y});
    const Touch touch = Area(std::string(id) + "/" + std::to_string(i), part, Grab::kPress,
                             {.label = name, .role = "tab", .state = {.selected = on}});
    if (touch.pressed) {
      selected = i;
      pressed = true;
    }
    Letters().Draw(list, on ? Type::kStrong : Type::kBody, part.GetCenter(),
                   on || touch.hovered ? p.ink : p.second_ink, name, Align::kCentre);
    if (on) list->AddRectFilled({part.Min.x, part.Max.y - 2.0f}, part.Max, p.accent);
    ImRect ring = part;
    ring.Expand({-2.0f, -6.0f});
    DrawFocus(touch, ring, 5.0f);
    x += width;
  }
  return pressed;
}

}  // namespace gaitsmith::shell
