// SPDX-License-Identifier: MIT
// Areas, layout and buttons. Sliders, fields and choices are in widgets_slider.cpp, widgets_range.cpp,
// widgets_value.cpp and widgets_choice.cpp.
#include "shell/widgets/widgets.h"

#include <algorithm>
#include <cmath>

#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

// Key in a window's storage for a touch that may become a drag or a scroll.
constexpr ImGuiID kFingerKey = 0x66696e67;
constexpr int kFingerWaits = 1;

}  // namespace

ImDrawList* Ui::Canvas() const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->_FringeScale = 1.0f / theme_.density;
  return list;
}

ImRect Ui::Row(float height) const {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  const ImVec2 size(window->Size.x - 2.0f * window->WindowPadding.x, height);
  ImGui::ItemSize(size);
  return {at, {at.x + size.x, at.y + size.y}};
}

void Ui::Gap(float height) const { ImGui::ItemSize(ImVec2(0.0f, height)); }

void Ui::Heading(std::string_view text) const {
  const ImRect row = Row(Fonts::LineHeight(Type::kStrong) + 4.0f);
  registry_.DescribeText("heading", text, row);
  Letters().Draw(Canvas(), Type::kStrong, {row.Min.x, row.GetCenter().y}, Ink().ink, text);
}

void Ui::LockNote() const {
  Paragraph(Tr("Locked here: read only."), Type::kNote);
  Gap(8.0f);
}

void Ui::Paragraph(std::string_view text, Type type) const { Paragraph(text, Ink().second_ink, type); }

void Ui::Paragraph(std::string_view text, ImU32 colour, Type type) const {
  const std::string_view whole = text;
  ImRect rows(ImGui::GetCursorScreenPos(), ImGui::GetCursorScreenPos());
  while (!text.empty()) {
    const ImRect row = Row(Fonts::LineHeight(type));
    rows.Add(row);
    const std::size_t length = std::max<std::size_t>(1, Letters().FitLine(type, text, row.GetWidth()));
    Letters().Draw(Canvas(), type, {row.Min.x, row.GetCenter().y}, colour, text.substr(0, length));
    text.remove_prefix(length);
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  }
  DescribeText(whole, rows);
}

void Ui::DescribeText(std::string_view text, const ImRect& rect) const {
  registry_.DescribeText("paragraph", text, rect);
}

void Ui::Fact(std::string_view label, std::string_view value) const {
  const ImRect row = Row(Fonts::LineHeight(Type::kBody) + 4.0f);
  DescribeText(std::string(label) + ": " + std::string(value), row);
  const float y = row.GetCenter().y;
  const float value_width = Letters().Width(Type::kBody, value);
  Letters().DrawElided(Canvas(), Type::kBody, {row.Min.x, y}, row.GetWidth() - value_width - 10.0f, Ink().ink,
                       label);
  Letters().Draw(Canvas(), Type::kBody, {row.Max.x, y}, Ink().second_ink, value, Align::kRight);
}

Touch Ui::Area(std::string_view id, const ImRect& rect, Grab grab, Widget description, bool enabled) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const bool unfolds = description.role == "button" && description.state.expanded;
  if (locked_ && !unfolds) {
    enabled = false;
    description.why_not = Tr("Locked here: read only.");
  }
  Touch touch;
  touch.id = window->GetID(id.data(), id.data() + id.size());
  const WidgetRequest* asked = registry_.Requests().DueFor(id);
  // Focus first: Dear ImGui draws the focused widget even if it is scrolled out of view. But a request must
  // not take away a press: leaving a text field of the page by a click requests its number, too.
  const bool pressing = g.ActiveId != 0 && g.ActiveId != touch.id && g.IO.MouseDown[0];
  if (asked != nullptr && !pressing) TakeKeyboard(rect, touch.id, asked->ring);
  // A disabled widget can have the focus, to learn why it is disabled.
  touch.visible = ImGui::ItemAdd(rect, touch.id);
  if (touch.visible && enabled && grab != Grab::kNothing) {
    const ImGuiButtonFlags flags =
        grab == Grab::kPress ? ImGuiButtonFlags_PressedOnClickRelease : ImGuiButtonFlags_PressedOnClick;
    const bool was_held = g.ActiveId == touch.id;
    touch.pressed = ImGui::ButtonBehavior(rect, touch.id, &touch.hovered, &touch.held, flags);
    touch.held = touch.held && g.ActiveIdSource == ImGuiInputSource_Mouse;
    touch.began = touch.held && !was_held;
    if (grab == Grab::kArrows && g.IO.MouseSource == ImGuiMouseSource_TouchScreen)
      AwaitFinger(touch, was_held);
    if (grab != Grab::kDrag && touch.hovered && !theme_.touch) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }

  // While focused, left and right change the value instead of moving the focus.
  if (grab == Grab::kArrows && enabled && g.NavId == touch.id && g.NavMoveSubmitted &&
      (g.NavMoveDir == ImGuiDir_Left || g.NavMoveDir == ImGuiDir_Right)) {
    touch.steps = (g.NavMoveDir == ImGuiDir_Left ? -1 : 1) * (g.IO.KeyShift ? 10 : 1);
    ImGui::NavMoveRequestCancel();
    g.NavDisableHighlight = false;
  }
  touch.focused = g.NavId == touch.id && !g.NavDisableHighlight;
  if (asked != nullptr && enabled && grab != Grab::kNothing) {
    touch.pressed |= asked->kind == WidgetRequest::Kind::kPress;
    if (asked->kind == WidgetRequest::Kind::kStep && grab == Grab::kArrows)
      touch.steps = static_cast<int>(asked->number);
    if (asked->kind == WidgetRequest::Kind::kSet && grab == Grab::kArrows) touch.wanted = asked->number;
  }

  description.id = id;
  description.state.focused = g.NavId == touch.id;
  description.state.disabled = !enabled;
  registry_.Describe(touch.id, std::move(description));
  return touch;
}

void Ui::AwaitFinger(Touch& touch, bool was_held) const {
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = touch.id + kFingerKey;
  if (touch.began) storage->SetInt(key, kFingerWaits);
  if (storage->GetInt(key) != kFingerWaits) return;
  if (!touch.held && !was_held) return storage->SetInt(key, 0);  // the touch became a scroll
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  const bool sideways = touch.held && std::abs(moved.x) >= 6.0f && std::abs(moved.x) >= std::abs(moved.y);
  const bool lifted = !touch.held && was_held;
  if (sideways || lifted) storage->SetInt(key, 0);
  touch.held = touch.began = sideways || lifted;
  touch.pressed = lifted;
}

void Ui::TakeKeyboard(const ImRect& rect, ImGuiID id, bool ring) const {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (g.ActiveId != 0 && g.ActiveId != id) ImGui::ClearActiveID();  // ends typing in a field
  if (g.NavWindow != window) ImGui::FocusWindow(window);            // closes a list over it
  ImGui::SetFocusID(id, window);
  window->NavRectRel[ImGuiNavLayer_Main] = ImGui::WindowRectAbsToRel(window, rect);
  g.NavDisableHighlight = !ring;
  if (ring) g.NavDisableMouseHover = true;  // ignore a pointer that does not move
  if ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0)
    ImGui::ScrollToRectEx(window, rect, ImGuiScrollFlags_KeepVisibleEdgeY | ImGuiScrollFlags_NoScrollParent);
}

void Ui::ScrollByTouch() const {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  if (g.IO.MouseSource != ImGuiMouseSource_TouchScreen || !g.IO.MouseDown[0]) return;
  if (!window->InnerRect.Contains(g.IO.MouseClickedPos[0]) || g.OpenPopupStack.Size > 0) return;
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  const bool mine = g.ActiveId == 0 || !g.ActiveIdHasBeenPressedBefore ||
                    ImGui::GetStateStorage()->GetInt(g.ActiveId + kFingerKey) == kFingerWaits;
  if (!mine || std::abs(moved.y) < 8.0f || std::abs(moved.y) < std::abs(moved.x)) return;
  if (g.ActiveId != 0) ImGui::ClearActiveID();
  ImGui::SetScrollY(window->Scroll.y - g.IO.MouseDelta.y);
}

void Ui::DrawFocus(const Touch& touch, const ImRect& rect, float radius) const {
  if (!touch.focused) return;
  ImDrawList* list = Canvas();
  ImRect ring = rect;
  ring.Expand(2.5f);
  // The ring may extend outside its row, but not outside the canvas.
  ImRect whole(ImGui::GetCurrentWindowRead()->ClipRect);
  ring.ClipWith(whole);
  list->AddRect(ring.Min, ring.Max, Ink().accent, radius + 2.5f, 0, 2.0f);
}

void Ui::Frame(const ImRect& rect, ImU32 fill, ImU32 border, float radius) const {
  ImDrawList* list = Canvas();
  list->AddRectFilled(rect.Min, rect.Max, fill, radius);
  list->AddRect(rect.Min, rect.Max, border, radius);
}

ImU32 Ui::CardFrame(const ImRect& rect, bool chosen, bool hovered) const {
  constexpr float kRadius = 9.0f;
  const Palette& p = Ink();
  const ImU32 fill = chosen ? Mix(p.panel, p.accent, 0.1f) : p.panel;
  Frame(rect, fill, chosen ? p.accent : hovered ? Mix(p.line, p.ink, 0.45f) : p.line, kRadius);
  if (chosen) Canvas()->AddRect(rect.Min, rect.Max, p.accent, kRadius, 0, 2.0f);
  return fill;
}

void Ui::HorizontalLine(float left, float right, float y) const {
  const float top = theme_.Snap(y);
  Canvas()->AddRectFilled(
      {left, top}, {right, top + std::max(1.0f, std::floor(theme_.density)) / theme_.density}, Ink().line);
}

void Ui::VerticalLine(float x, float top, float bottom) const {
  const float left = theme_.Snap(x);
  Canvas()->AddRectFilled(
      {left, top}, {left + std::max(1.0f, std::floor(theme_.density)) / theme_.density, bottom}, Ink().line);
}

// Draws a button's background and returns the colour of its label.
ImU32 Ui::ButtonInk(ButtonLook look, const ImRect& rect, const Touch& touch, bool enabled) const {
  const Palette& p = Ink();
  const float lift = touch.held ? 0.16f : touch.hovered ? 0.08f : 0.0f;
  ImDrawList* list = Canvas();
  if (look == ButtonLook::kPrimary) {
    const ImU32 fill = enabled ? Mix(p.accent, p.ink, lift) : Mix(p.soft, p.line, 0.4f);
    list->AddRectFilled(rect.Min, rect.Max, fill, kCornerRadius);
    return enabled ? p.accent_ink : p.second_ink;
  }
  if (look == ButtonLook::kOutlined) {
    Frame(rect, Mix(p.panel, p.ink, 0.5f * lift), Mix(p.line, p.ink, lift));
  } else if (lift > 0.0f) {
    list->AddRectFilled(rect.Min, rect.Max, Mix(p.panel, p.ink, 0.6f * lift), kCornerRadius);
  }
  return enabled ? p.ink : Mix(p.panel, p.second_ink, 0.6f);
}

bool Ui::Button(std::string_view id, const ImRect& rect, std::string_view label, ButtonLook look,
                bool enabled, std::string_view accessible_name) {
  const Touch touch = Area(
      id, rect, Grab::kPress,
      {.label = std::string(accessible_name.empty() ? label : accessible_name), .role = "button"}, enabled);
  if (!touch.visible) return touch.pressed;
  const ImU32 ink = ButtonInk(look, rect, touch, enabled);
  Letters().Draw(Canvas(), look == ButtonLook::kPrimary ? Type::kStrong : Type::kBody, rect.GetCenter(), ink,
                 label, Align::kCentre);
  DrawFocus(touch, rect);
  return touch.pressed;
}

bool Ui::IconButton(std::string_view id, const ImRect& rect, Icon icon, std::string_view label,
                    ButtonLook look, bool enabled) {
  const Touch touch = Area(id, rect, Grab::kPress, {.label = std::string(label), .role = "button"}, enabled);
  if (!touch.visible) return touch.pressed;
  const ImU32 ink = ButtonInk(look, rect, touch, enabled);
  DrawIcon(Canvas(), icon, rect.GetCenter(), 14.0f, ink);
  DrawFocus(touch, rect);
  return touch.pressed;
}

bool Ui::LargeButton(std::string_view id, const ImRect& rect, Icon icon, std::string_view label) {
  constexpr float kRadius = 14.0f, kIcon = 20.0f, kSpace = 14.0f;
  const Touch touch = Area(id, rect, Grab::kPress, {.label = std::string(label), .role = "button"});
  const Palette& p = Ink();
  const float lift = touch.held ? 0.16f : touch.hovered ? 0.08f : 0.0f;
  Canvas()->AddRectFilled(rect.Min, rect.Max, Mix(p.accent, p.ink, lift), kRadius);
  const float width = kIcon + kSpace + Letters().Width(Type::kLarge, label);
  const ImVec2 centre = rect.GetCenter();
  const float left = centre.x - 0.5f * width;
  DrawIcon(Canvas(), icon, {left + 0.5f * kIcon, centre.y}, kIcon, p.accent_ink);
  Letters().Draw(Canvas(), Type::kLarge, {left + kIcon + kSpace, centre.y}, p.accent_ink, label);
  DrawFocus(touch, rect, kRadius);
  return touch.pressed;
}

void Ui::ScrollBar(std::string_view id) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const float longer = window->ScrollMax.y;
  if (longer <= 0.0f) return;
  const ImRect inner = window->InnerRect;
  const float height = inner.GetHeight();
  const float thumb = std::max(28.0f, height * height / (height + longer));
  const float top = inner.Min.y + window->Scroll.y / longer * (height - thumb);
  const ImRect bar({inner.Max.x - 11.0f, top}, {inner.Max.x, top + thumb});
  ImGui::PushClipRect(inner.Min, inner.Max, false);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  const std::string share = std::to_string(static_cast<int>(100.0f * window->Scroll.y / longer)) + " %";
  const Touch touch =
      Area(id, bar, Grab::kDrag, {.label = Tr("Scroll"), .role = "scrollbar", .value = share});
  ImGui::PopItemFlag();
  if (touch.held)
    ImGui::SetScrollY(window->Scroll.y + ImGui::GetIO().MouseDelta.y * longer / (height - thumb));
  const float strength = touch.held ? 0.6f : touch.hovered ? 0.45f : 0.18f;
  Canvas()->AddRectFilled({bar.Max.x - 7.0f, bar.Min.y + 3.0f}, {bar.Max.x - 3.0f, bar.Max.y - 3.0f},
                          Mix(Ink().panel, Ink().second_ink, strength), 2.0f);
  ImGui::PopClipRect();
}

}  // namespace gaitsmith::shell
