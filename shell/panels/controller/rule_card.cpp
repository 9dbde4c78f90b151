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

std::string CaresWords(const Controller& controller, int rule, const PortCount& ports) {
  std::string words;
  for (int sense = 0; sense < SenseCount(controller.senses.kind, ports); ++sense) {
    if (!StimulusOf(controller, ports, rule, sense).cares) continue;
    words += (words.empty() ? "" : ", ") + TrSentence(SenseName(controller.senses.kind, ports, sense));
  }
  return words.empty() ? Tr("uses no sense") : Tr("uses {1}", words);
}

/// The pose that a rule pulls a figure to. Where the nodes of a figure of springs would come to rest is not
/// known, so there its drawn pose has muscles as thick as they would be.
void DrawPose(Ui& ui, const Figure& figure, const std::vector<float>& targets, float reach_m,
              const ImRect& rect, ImU32 colour) {
  FigureLook look = LookOf(figure);
  std::size_t muscle = 0;
  for (FigureLook::Limb& limb : look.limbs) {
    if (limb.drawn_m > 0.0f) limb.drawn_m /= targets[muscle++];
  }
  const std::vector<ImVec2> pose = figure.HasSprings() ? PoseOf(figure) : PoseOf(Skeleton(figure), targets);
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
  DrawBody(ui.Canvas(), look, points, scale,
           {.body = colour, .far = Mix(behind, colour, kFarShare), .eye = behind});
}

}  // namespace

std::vector<float> TargetPose(const Controller& controller, const Ports& ports, int rule) {
  std::vector<float> targets;
  targets.reserve(ports.actuator_range.size());
  for (int actuator = 0; actuator < ports.Actuators(); ++actuator) {
    const auto [least, most] = ports.actuator_range[static_cast<std::size_t>(actuator)];
    targets.push_back(TargetOf(controller, ports.Count(), rule, actuator, least, most));
  }
  return targets;
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
  const Ports& ports = motion.Connections();
  const int frame = session.Player().Frame();
  const bool in_charge = motion.At(frame).clip == session.Timeline().Selected();
  const bool active = in_charge && motion.At(frame).rule == rule;
  const float tau = TauOf(controller, ports.Count(), rule);
  const std::string tau_words = Fixed(tau, 2) + " s";
  const std::string name = std::to_string(rule + 1);
  const Touch touch = ui.Area("controller/rule/" + name, rect, Grab::kPress,
                              {.label = Tr("Rule {1}", name),
                               .role = "button",
                               .value = "τ " + tau_words + ", " + CaresWords(controller, rule, ports.Count()),
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
  DrawPose(ui, session.Doc().figure, TargetPose(controller, ports, rule), session.Player().ReachM(), figure,
           active ? colour : Mix(p.panel, p.ink, 0.82f));

  // "3  ◔ 0.29 s"
  const float left = rect.Min.x + 8.0f + kFigureWidth;
  const float right = rect.Max.x - 10.0f;
  const float title_y = rect.Min.y + 15.0f;
  letters.Draw(list, Type::kStrong, {left, title_y}, p.ink, name);
  DrawClock(ui, {left + 28.0f, title_y}, 5.5f, tau, active ? colour : Mix(p.panel, p.ink, 0.55f));
  letters.DrawElided(list, Type::kNote, {left + 38.0f, title_y}, right - left - 37.0f,
                     active ? p.ink : p.second_ink, tau_words);

  std::vector<StimulusBar> bars;
  const int senses = SenseCount(controller.senses.kind, ports.Count());
  for (int sense = 0; sense < senses; ++sense) {
    const Stimulus stimulus = StimulusOf(controller, ports.Count(), rule, sense);
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
