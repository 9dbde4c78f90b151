// SPDX-License-Identifier: MIT
#include "shell/panels/controller/rule_card.h"

#include <algorithm>
#include <cmath>

#include "core/control/rule_edit.h"
#include "core/numeric/scalar_math.h"
#include "shell/stage/figure_drawing.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr std::size_t kBarsShown = 4;
constexpr float kFigureWidth = 60.0f;

std::string CaresWords(const Controller& controller, int rule, int rods) {
  std::string words;
  for (int sense = 0; sense < SenseCount(controller.senses.kind, rods); ++sense) {
    if (!StimulusOf(controller, rods, rule, sense).cares) continue;
    words += (words.empty() ? "" : ", ") + TrSentence(SenseName(controller.senses.kind, rods, sense));
  }
  return words.empty() ? Tr("uses no sense") : Tr("uses {1}", words);
}

void DrawPose(Ui& ui, const Skeleton& bones, const FigureLook& look, const std::vector<float>& angles,
              float reach_m, const ImRect& rect, ImU32 colour) {
  const std::vector<ImVec2> pose = PoseOf(bones, angles);
  ImRect extent(pose[0], pose[0]);
  for (const ImVec2& point : pose) extent.Add(point);
  const float scale = rect.GetWidth() / std::max({extent.GetWidth(), extent.GetHeight(), reach_m});
  std::vector<ImVec2> points;
  points.reserve(pose.size());
  for (const ImVec2& point : pose) {
    points.emplace_back(rect.GetCenter().x + (point.x - extent.GetCenter().x) * scale,
                        rect.GetCenter().y - (point.y - extent.GetCenter().y) * scale);
  }
  const ImU32 behind = ui.Ink().panel;
  DrawBody(ui.Canvas(), bones, look, points, scale,
           {.body = colour, .far = Mix(behind, colour, kFarShare), .eye = behind});
}

}  // namespace

std::vector<float> TargetPose(const Controller& controller, const Skeleton& bones, int rule) {
  std::vector<float> angles;
  for (int joint = 0; joint < bones.joints; ++joint) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    angles.push_back(TargetOf(controller, bones.rods, rule, joint, limb.min_rad, limb.max_rad));
  }
  return angles;
}

float ShareOnBar(const SenseSpec& spec, float sense) {
  const auto [low, high] = EdgesOf(spec.kind);
  return std::clamp((sense - low) / (high - low), 0.0f, 1.0f);
}

void DrawStimulusBar(Ui& ui, const ImRect& rect, const StimulusBar& bar, ImU32 colour) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const float radius = 0.5f * rect.GetHeight();
  const auto x_of = [&](float share) { return rect.Min.x + share * rect.GetWidth(); };
  list->AddRectFilled(rect.Min, rect.Max, Mix(p.soft, p.line, 0.5f), radius);
  // Full colour while the interval contains the present value.
  list->AddRectFilled({x_of(bar.low), rect.Min.y},
                      {std::max(x_of(bar.high), x_of(bar.low) + 3.0f), rect.Max.y},
                      Mix(p.panel, colour, bar.Holds() ? 0.95f : 0.42f), radius);
  if (bar.value < 0.0f) return;
  const float x = ui.Look().Snap(std::clamp(x_of(bar.value), rect.Min.x + 1.0f, rect.Max.x - 1.0f));
  list->AddRectFilled({x - 1.0f, rect.Min.y - 2.0f}, {x + 1.0f, rect.Max.y + 2.0f}, p.ink);
}

void DrawClock(Ui& ui, ImVec2 centre, float radius, float seconds, ImU32 colour) {
  ImDrawList* list = ui.Canvas();
  const float turn = std::clamp(seconds, 0.02f, 1.0f) * 2.0f * static_cast<float>(kPi);
  const float top = -0.5f * static_cast<float>(kPi);
  list->AddCircle(centre, radius, Mix(ui.Ink().panel, colour, 0.3f), 0, 2.0f);
  list->PathArcTo(centre, radius, top, top + turn, 24);
  list->PathStroke(colour, 0, 2.5f);
}

Touch DrawRuleCard(Ui& ui, const Session& session, const Controller& controller, int rule, bool open,
                   const ImRect& rect) {
  const Motion& motion = session.Player().Shown();
  const Skeleton& bones = motion.Bones();
  const int frame = session.Player().Frame();
  const bool in_charge = motion.At(frame).clip == session.Timeline().Selected();
  const bool active = in_charge && motion.At(frame).rule == rule;
  const float tau = TauOf(controller, bones.rods, rule);
  const std::string tau_words = Fixed(tau, 2) + " s";
  const std::string name = std::to_string(rule + 1);
  const Touch touch = ui.Area("controller/rule/" + name, rect, Grab::kPress,
                              {.label = Tr("Rule {1}", name),
                               .role = "button",
                               .value = "τ " + tau_words + ", " + CaresWords(controller, rule, bones.rods),
                               .state = {.selected = active, .expanded = open}});
  if (!touch.visible) return touch;

  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  const ImU32 colour = ui.Look().Rule(rule);
  ImDrawList* list = ui.Canvas();
  if (active) {
    ImRect halo = rect;
    halo.Expand(2.5f);
    list->AddRectFilled(halo.Min, halo.Max, Mix(p.panel, colour, 0.28f), 11.5f);
  }
  const ImU32 fill = Mix(p.panel, active ? colour : p.ink, active ? 0.07f : touch.hovered ? 0.03f : 0.0f);
  ui.Frame(rect, fill, active ? colour : open || touch.hovered ? Mix(p.line, p.ink, 0.45f) : p.line, 9.0f);

  const ImRect figure({rect.Min.x + 8.0f, rect.Min.y + 10.0f},
                      {rect.Min.x + 8.0f + kFigureWidth - 8.0f, rect.Max.y - 10.0f});
  DrawPose(ui, bones, LookOf(session.Doc().figure.name, bones), TargetPose(controller, bones, rule),
           session.Player().ReachM(), figure, active ? colour : Mix(p.panel, p.ink, 0.82f));

  // "3  ◔ 0.29 s"
  const float left = rect.Min.x + 8.0f + kFigureWidth;
  const float right = rect.Max.x - 10.0f;
  const float title_y = rect.Min.y + 15.0f;
  letters.Draw(list, Type::kStrong, {left, title_y}, p.ink, name);
  DrawClock(ui, {left + 28.0f, title_y}, 5.5f, tau, active ? colour : Mix(p.panel, p.ink, 0.55f));
  letters.DrawElided(list, Type::kNote, {left + 38.0f, title_y}, right - left - 37.0f,
                     active ? p.ink : p.second_ink, tau_words);

  std::vector<StimulusBar> bars;
  const int senses = SenseCount(controller.senses.kind, bones.rods);
  for (int sense = 0; sense < senses; ++sense) {
    const Stimulus stimulus = StimulusOf(controller, bones.rods, rule, sense);
    if (!stimulus.cares) continue;
    const float felt =
        in_charge && frame > 0 ? ShareOnBar(controller.senses, motion.Sense(frame, sense)) : -1.0f;
    bars.push_back(
        {ShareOnBar(controller.senses, stimulus.low), ShareOnBar(controller.senses, stimulus.high), felt});
  }
  // Ignored senses have no bar. The card counts them, and the bars that do not fit.
  const int ignored = senses - static_cast<int>(bars.size());
  std::string rest;
  if (bars.size() > kBarsShown) rest = Tr("+{1} more", std::to_string(bars.size() - kBarsShown));
  if (bars.empty()) {
    rest = Tr("always matches");
  } else if (rest.empty() && ignored > 0) {
    rest = Tr("{1} unused", ignored);
  }
  float y = rect.Min.y + 30.0f;
  for (std::size_t i = 0; i < std::min(bars.size(), kBarsShown); ++i, y += 9.5f) {
    DrawStimulusBar(ui, {{left, y}, {right, y + 5.0f}}, bars[i], colour);
  }
  letters.DrawElided(list, Type::kNote, {left, rect.Max.y - 12.0f}, right - left + 2.0f, p.second_ink, rest);
  ui.DrawFocus(touch, rect, 9.0f);
  return touch;
}

}  // namespace gaitsmith::shell
