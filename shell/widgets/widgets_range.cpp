// SPDX-License-Identifier: MIT
// A slider for an interval, with two ends.
#include <algorithm>

#include "shell/widgets/widgets.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kKeyStep = 0.01f;  // as a share of the track

// The knob's position during a drag. Its offset from the pointer is constant, so that it does not jump at
// first.
float HeldAt(const Touch& touch, float knob_x) {
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const float pointer = ImGui::GetIO().MousePos.x;
  if (touch.began) storage->SetFloat(touch.id, knob_x - pointer);
  return pointer + storage->GetFloat(touch.id);
}

}  // namespace

void Ui::DrawKnob(ImVec2 centre, const Touch& touch, ImU32 colour) const {
  ImDrawList* list = Canvas();
  const float radius = touch.held ? kKnobRadius + 1.0f : kKnobRadius;
  if (touch.hovered || touch.focused) list->AddCircleFilled(centre, radius + 5.0f, Fade(colour, 0.18f));
  list->AddCircleFilled(centre, radius, colour);
  list->AddCircleFilled(centre, radius - 2.0f, Ink().panel);
  if (touch.focused) list->AddCircle(centre, radius + 5.0f, Ink().accent, 0, 2.0f);
}

bool Ui::IntervalSlider(std::string_view id, std::string_view label, SliderInterval& interval, ImU32 colour) {
  const Palette& p = Ink();
  ImDrawList* list = Canvas();
  const ImRect row = Row(theme_.touch ? 36.0f : 26.0f);
  const float y = row.GetCenter().y;
  const float left = row.Min.x + kKnobRadius;
  const float right = row.Max.x - kKnobRadius;
  const auto x_of = [&](float share) { return left + share * (right - left); };

  // Each end reacts on its outer side, so that both can be dragged even if they coincide.
  const float reach = theme_.touch ? 22.0f : 13.0f;
  const float low_x = x_of(interval.low), high_x = x_of(interval.high);
  const float between = 0.5f * (low_x + high_x);
  const ImRect low_area({low_x - reach, row.Min.y}, {std::min(low_x + reach, between), row.Max.y});
  const ImRect high_area({std::max(high_x - reach, between), row.Min.y}, {high_x + reach, row.Max.y});
  const std::string name(id), words(label);
  const auto range_of = [](float share) {
    return WidgetRange{0.0, 1.0, static_cast<double>(kKeyStep), static_cast<double>(share)};
  };
  const Touch low = Area(name + "/low", low_area, Grab::kArrows,
                         {.label = Tr("{1} from", words),
                          .role = "slider",
                          .value = interval.low_text,
                          .range = range_of(interval.low)});
  const Touch high = Area(name + "/high", high_area, Grab::kArrows,
                          {.label = Tr("{1} to", words),
                           .role = "slider",
                           .value = interval.high_text,
                           .range = range_of(interval.high)});
  const float low_before = interval.low, high_before = interval.high;
  const auto moved = [&](const Touch& touch, float share, float least, float most) {
    if (!touch.held && touch.steps == 0 && !touch.wanted) return share;
    if (touch.wanted) share = static_cast<float>(*touch.wanted);
    if (touch.held) share = (HeldAt(touch, x_of(share)) - left) / (right - left);
    return std::clamp(share + kKeyStep * static_cast<float>(touch.steps), least, most);
  };
  interval.low = moved(low, interval.low, 0.0f, std::max(interval.high, interval.low));
  interval.high = moved(high, interval.high, interval.low, 1.0f);

  list->AddRectFilled({row.Min.x, y - 3.0f}, {row.Max.x, y + 3.0f}, Mix(p.soft, p.line, 0.5f), 3.0f);
  const bool holds = interval.mark >= interval.low && interval.mark <= interval.high;
  list->AddRectFilled({x_of(interval.low), y - 3.0f}, {x_of(interval.high), y + 3.0f},
                      Mix(p.panel, colour, holds ? 0.95f : 0.45f));
  DrawKnob({x_of(interval.low), y}, low, colour);
  DrawKnob({x_of(interval.high), y}, high, colour);
  if (interval.mark >= 0.0f) {
    const float x = theme_.Snap(x_of(std::min(interval.mark, 1.0f)));
    list->AddRectFilled({x - 1.0f, y - 7.0f}, {x + 1.0f, y + 7.0f}, p.ink);
  }
  return interval.low != low_before || interval.high != high_before;
}

}  // namespace gaitsmith::shell
