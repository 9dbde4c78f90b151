// SPDX-License-Identifier: MIT
#include "shell/panels/keyframes/keyframes_panel.h"

#include <algorithm>
#include <cmath>

#include "shell/widgets/fold.h"
#include "shell/words/language.h"
#include "shell/words/plan_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

void DrawNews(Ui& ui, Session& session, KeyframesPanelState& state) {
  const PlanRun& planning = session.Planning();
  const bool bad = planning.Now() == PlanRun::State::kRefused ||
                   planning.Now() == PlanRun::State::kImpossible || planning.Now() == PlanRun::State::kFailed;
  ui.Paragraph(planning.Words(), bad ? ui.Ink().accent : ui.Ink().second_ink, Type::kNote);
  if (const PlanMiss* culprit = planning.Culprit(); culprit != nullptr) {
    const bool stands =
        culprit->part.kind == PlanPart::Kind::kStanceX || culprit->part.kind == PlanPart::Kind::kStanceY;
    if (ui.Button("keyframes/culprit", ui.ControlRow(), Tr("Show what is in the way"))) {
      if (stands)
        state.bars.stance = culprit->part.index;
      else
        session.Keyframes().Choose(culprit->part.index);
      if (!stands) state.bars.stance = -1;
    }
  }
  ui.Gap(6.0f);
}

void DrawStance(Ui& ui, Session& session, StanceBarsState& state) {
  const auto& stances = session.Keyframes().Shown().stances;
  if (state.stance >= static_cast<int>(stances.size())) state.stance = -1;
  if (state.stance < 0) return;
  const Stance& stance = stances[static_cast<std::size_t>(state.stance)];
  ui.Paragraph(
      Tr("{1} stands from {2} to {3} s.", PointWords(stance.endpoint),
         Fixed(stance.first_step * kSecondsPerStep, 2), Fixed(stance.last_step * kSecondsPerStep, 2)),
      Type::kNote);
  if (!ui.Button("keyframes/stance-remove", ui.ControlRow(), Tr("Remove this time of standing"))) return;
  session.Keyframes().RemoveStance(state.stance);
  state.stance = -1;
}

void DrawView(Ui& ui, Session& session, KeyframesPanelState& state) {
  static constexpr std::array<const char*, 2> kViews = {TrLater("Standing"), TrLater("Angles")};
  ui.Segmented("keyframes/view", ui.ControlRow(), Tr("What is shown over time"), kViews, state.view);
  ui.Gap(6.0f);
  if (state.view == 1) {
    DrawAngleCurves(ui, session, state.joint);
    ui.Gap(6.0f);
    return;
  }
  DrawStanceBars(ui, session, state.bars);
  ui.Gap(6.0f);
  DrawStance(ui, session, state.bars);
}

void DrawAdding(Ui& ui, Session& session, KeyframesPanelState& state) {
  const ImRect row = ui.ControlRow();
  const float middle = row.GetCenter().x;
  if (ui.Button("keyframes/add", {row.Min, {middle - 4.0f, row.Max.y}}, Tr("Keyframe here"))) {
    if (session.Keyframes().AddKeyframe()) state.bars = {};
  }
  if (ui.Button("keyframes/take", {{middle + 4.0f, row.Min.y}, row.Max}, Tr("Take feet from motion")))
    session.Keyframes().TakeStances();
  ui.Gap(6.0f);
  std::vector<std::string> points;
  const int endpoints = session.Player().Shown().Bones().endpoints;
  points.reserve(static_cast<std::size_t>(endpoints));
  for (int k = 0; k < endpoints; ++k) points.push_back(Tr("Endpoint {1}", k + 1));
  state.endpoint = std::clamp(state.endpoint, 0, endpoints - 1);
  ui.Combo("keyframes/stance-of", Tr("Standing"), points, state.endpoint);
  if (ui.Button("keyframes/stance", ui.ControlRow(), Tr("Let it stand from here")))
    session.Keyframes().AddStance(state.endpoint);
}

void DrawWhole(Ui& ui, Session& session) {
  const Plan& plan = session.Keyframes().Shown();
  double seconds = plan.steps * kSecondsPerStep;
  if (ui.Slider("keyframes/length", Tr("Length"), seconds, {.low = 0.2, .high = 10.0, .step = 0.05},
                Fixed(seconds, 2) + " s"))
    session.Keyframes().SetLength(static_cast<int>(std::lround(seconds / kSecondsPerStep)));
  double smooth = static_cast<double>(session.Keyframes().Shown().smoothness);
  if (ui.Slider("keyframes/smoothness", Tr("Smoothness"), smooth,
                {.low = 0.001, .high = 10.0, .step = 0.001, .logarithmic = true},
                Fixed(smooth, smooth < 0.1 ? 3 : 2)))
    session.Keyframes().Change([&](Plan& p) { p.smoothness = static_cast<float>(smooth); });
  const Ghost& other = session.Comparison().Other();
  bool beside = other.Source() == Ghost::Kind::kPlanned && other.Beside();
  if (!session.Keyframes().Shown().solved.unknowns.empty() &&
      ui.Switch("keyframes/beside", Tr("Planned and played side by side"), beside)) {
    session.Comparison().ShowPlanned(session.Doc());
    session.Comparison().ShowBeside(beside);
  }
  const bool solved = !session.Keyframes().Shown().solved.unknowns.empty();
  ui.Gap(6.0f);
  if (ui.Button("keyframes/track", ui.ControlRow(), Tr("Track it by rules"), ButtonLook::kOutlined,
                solved && !session.Planning().Working()))
    session.TrackKeyframes();
  const ImRect row = ui.ControlRow();
  const float middle = row.GetCenter().x;
  if (ui.Button("keyframes/again", {row.Min, {middle - 4.0f, row.Max.y}}, Tr("Plan again"),
                ButtonLook::kOutlined, !session.Planning().Working()))
    session.Planning().Again();
  if (ui.Button("keyframes/clear", {{middle + 4.0f, row.Min.y}, row.Max}, Tr("Remove keyframes")))
    session.Keyframes().Clear();
}

}  // namespace

void DrawKeyframesPanel(Ui& ui, Session& session, KeyframesPanelState& state) {
  ui.Paragraph(Tr("Place the figure at some moments, and choose what stands when. The motion between "
                  "follows from the laws of motion, with as little effort as possible."),
               Type::kNote);
  ui.Gap(6.0f);
  if (!session.Keyframes().Open()) {
    const std::string why_not = session.Keyframes().WhyNot();
    if (!why_not.empty()) return ui.Paragraph(why_not);
    if (ui.Button("keyframes/begin", ui.ControlRow(), Tr("Begin with a jump"), ButtonLook::kPrimary))
      session.OpenKeyframes();
    return;
  }
  DrawNews(ui, session, state);
  DrawView(ui, session, state);
  DrawAdding(ui, session, state);
  ui.Gap(8.0f);
  DrawKeyframeForm(ui, session, state.form);
  ui.Heading(Tr("The whole motion"));
  DrawWhole(ui, session);
}

}  // namespace gaitsmith::shell
