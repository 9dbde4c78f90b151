// SPDX-License-Identifier: MIT
#include "shell/panels/controller/curve_editor.h"

#include <algorithm>
#include <cmath>

#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kPlotHeight = 148.0f;

/// A trajectory on the stage, and its figure.
struct Shown {
  Ui& ui;
  Session& session;
  const Controller& controller;
  const Skeleton& bones;
  const Ports& ports;
  CurveShape shape{controller.rules, ports.Count()};
  KnotTimes times{controller.rules, controller.senses};

  [[nodiscard]] const std::array<float, 2>& RangeOf(int joint) const {
    return ports.actuator_range[static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] float Angle(int knot, int joint) const {
    return Decode(controller.genes[shape.Angle(knot, joint)], RangeOf(joint)[0], RangeOf(joint)[1]);
  }
  /// The edit stops a running search, whose result may have fewer knots.
  void SetAngle(int knot, int joint, float angle_rad) const {
    session.Timeline().ChangeController([&](Controller& c) {
      if (c.kind != ControllerKind::kTrajectory || knot >= c.rules) return;
      c.genes[shape.Angle(knot, joint)] = Encode(angle_rad, RangeOf(joint)[0], RangeOf(joint)[1]);
    });
  }
  [[nodiscard]] float SecondsOf(int knot) const { return static_cast<float>(times.TimeOf(knot)) * kStep; }
};

/// The plot's area, with time to the right over one period, and each joint's range from bottom to top.
struct Axes {
  const Shown& of;
  ImRect rect;

  [[nodiscard]] float X(double time_steps) const {
    return rect.Min.x + static_cast<float>(time_steps / of.controller.senses.period_steps) * rect.GetWidth();
  }
  [[nodiscard]] float Y(float share) const { return rect.Max.y - share * rect.GetHeight(); }
  [[nodiscard]] ImVec2 Knot(int knot, int joint) const {
    const float share = static_cast<float>(of.controller.genes[of.shape.Angle(knot, joint)]) / kGeneMax;
    return {X(of.times.TimeOf(knot)), Y(share)};
  }
  [[nodiscard]] std::vector<ImVec2> Curve(int joint) const {
    constexpr int kPoints = 96;
    std::vector<ImVec2> points;
    points.reserve(kPoints + 1);
    for (int i = 0; i <= kPoints; ++i) {
      const double t = i * (of.controller.senses.period_steps - 1e-6) / kPoints;
      const KnotTimes::Mix mix = of.times.ValueAt(t);
      double share = 0.0;
      for (std::size_t k = 0; k < mix.knot.size(); ++k) {
        const Gene gene = of.controller.genes[of.shape.Angle(static_cast<int>(mix.knot[k]), joint)];
        share += mix.weight[k] * gene / kGeneMax;
      }
      points.emplace_back(X(t), Y(static_cast<float>(share)));
    }
    return points;
  }
};

void Choose(const Axes& axes, ImVec2 pointer, CurveEditorState& state) {
  float nearest = 1e9f;
  for (int joint = 0; joint < axes.of.shape.joints; ++joint) {
    for (int knot = 0; knot < axes.of.shape.knots; ++knot) {
      const ImVec2 at = axes.Knot(knot, joint);
      // Knots of the chosen joint are preferred, since only they are drawn.
      const float away =
          std::hypot(at.x - pointer.x, at.y - pointer.y) - (joint == state.joint ? 12.0f : 0.0f);
      if (away >= nearest) continue;
      nearest = away;
      state.knot = knot;
      state.joint = joint;
    }
  }
}

void DrawLines(const Axes& axes, const CurveEditorState& state) {
  const Shown& of = axes.of;
  Ui& ui = of.ui;
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  list->AddLine({axes.X(of.times.TimeOf(state.knot)), axes.rect.Min.y},
                {axes.X(of.times.TimeOf(state.knot)), axes.rect.Max.y}, p.line, 1.0f);
  for (const bool chosen : {false, true}) {
    for (int joint = 0; joint < of.shape.joints; ++joint) {
      if ((joint == state.joint) != chosen) continue;
      const std::vector<ImVec2> curve = axes.Curve(joint);
      const ImU32 colour = ui.Look().Rule(joint);
      list->AddPolyline(curve.data(), static_cast<int>(curve.size()), chosen ? colour : Fade(colour, 0.45f),
                        ImDrawFlags_None, chosen ? 2.5f : 1.2f);
      if (!chosen) continue;
      for (int knot = 0; knot < of.shape.knots; ++knot) {
        const bool open = knot == state.knot;
        list->AddCircleFilled(axes.Knot(knot, joint), open ? 6.0f : 4.0f, open ? p.ink : colour);
        list->AddCircle(axes.Knot(knot, joint), open ? 6.0f : 4.0f, p.paper, 0, 1.2f);
      }
    }
  }
  const Motion::Frame& now = of.session.Player().Shown().At(of.session.Player().Frame());
  const int clip = of.session.Timeline().Selected();
  if (now.clip != clip) return;
  const int steps =
      of.session.Player().Frame() - of.session.Doc().timeline[static_cast<std::size_t>(clip)].start_step;
  const int period = of.controller.senses.period_steps;
  const int phase = of.controller.senses.at_end == CurveEnd::kRest ? std::min(steps, period) : steps % period;
  list->AddLine({axes.X(phase), axes.rect.Min.y}, {axes.X(phase), axes.rect.Max.y}, p.ink, 1.5f);
}

void DrawCurvePlot(const Shown& of, CurveEditorState& state) {
  Ui& ui = of.ui;
  const ImRect row = ui.Row(kPlotHeight);
  const Axes axes{of, {{row.Min.x + 10.0f, row.Min.y + 10.0f}, {row.Max.x - 10.0f, row.Max.y - 10.0f}}};
  const Touch touch =
      ui.Area("curves/plot", row, Grab::kDrag,
              {.label = of.ports.muscles ? Tr("Curves of all muscles: drag a point")
                                         : Tr("Curves of all joints: drag a point"),
               .role = "img",
               .value = Tr(of.ports.muscles ? "knot {1}, length {2}: {3}" : "knot {1}, angle {2}: {3}",
                           state.knot + 1, state.joint + 1,
                           QuantityWords(of.ports.muscles ? SenseQuantity::kLength : SenseQuantity::kAngle,
                                         of.Angle(state.knot, state.joint)))});
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (touch.began) Choose(axes, ImGui::GetIO().MouseClickedPos[0], state);
  if (touch.steps != 0) {
    const int knots = of.shape.knots;
    state.knot = (state.knot + touch.steps % knots + knots) % knots;
  }
  // A press alone only chooses.
  const bool moved = touch.held && !touch.began && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f);
  if (moved) {
    const float share = std::clamp((axes.rect.Max.y - pointer.y) / axes.rect.GetHeight(), 0.0f, 1.0f);
    const auto [least, most] = of.RangeOf(state.joint);
    const float angle = least + share * (most - least);
    if (std::abs(angle - of.Angle(state.knot, state.joint)) > 1e-4f)
      of.SetAngle(state.knot, state.joint, angle);
  }
  if (!touch.visible) return;
  ui.Frame(row, ui.Ink().paper, ui.Ink().line, 9.0f);
  DrawLines(axes, state);
  ui.DrawFocus(touch, row, 9.0f);
}

void DrawKnot(const Shown& of, CurveEditorState& state) {
  std::vector<float> pose, present;
  std::vector<ImU32> colours;
  const Playback& player = of.session.Player();
  const bool plays = player.Shown().At(player.Frame()).clip == of.session.Timeline().Selected();
  for (int joint = 0; joint < of.shape.joints; ++joint) {
    pose.push_back(of.Angle(state.knot, joint));
    colours.push_back(of.ui.Look().Rule(joint));
    if (plays) present.push_back(player.Shown().AngleRad(player.Frame(), joint));
  }
  std::optional<PoseEdit> edit;
  if (!of.ports.muscles) {
    edit = DrawPoseBoard(of.ui, "curves/pose", Tr("Pose of knot {1}: drag a limb", state.knot + 1),
                         of.ui.Ink().ink, of.bones, pose, present, state.drag);
    of.ui.Gap(8.0f);
  }
  if (const auto slid = DrawAngleSliders(of.ui, "curves/angle", of.ports, pose, colours)) edit = slid;
  if (!edit) return;
  state.joint = edit->joint;
  of.SetAngle(state.knot, edit->joint, edit->angle_rad);
}

}  // namespace

void DrawCurveEditor(Ui& ui, Session& session, const Controller& controller, CurveEditorState& state) {
  // Copies, since an edit replaces the motion while the rest is being drawn.
  const Skeleton bones = session.Player().Shown().Bones();
  const Ports ports = session.Player().Shown().Connections();
  const Shown of{ui, session, controller, bones, ports};
  if (of.shape.joints == 0) return;
  state.knot = std::clamp(state.knot, 0, of.shape.knots - 1);
  state.joint = std::clamp(state.joint, 0, of.shape.joints - 1);
  const PartScope part = ui.Part("curves", "group", Tr("Curves"));
  ui.Paragraph(ports.muscles
                   ? Tr("A line for each muscle, over one period. Drag a point.")
                   : Tr("A line for each joint, over one period. Drag a point, or a limb of the pose below."),
               Type::kNote);
  ui.Gap(6.0f);
  DrawCurvePlot(of, state);
  ui.Gap(8.0f);
  double knot = state.knot + 1.0;
  if (of.shape.knots > 1 && ui.Slider("curves/knot", Tr("Knot"), knot,
                                      {.low = 1.0, .high = static_cast<double>(of.shape.knots), .step = 1.0},
                                      Tr("{1} of {2}, at {3} s", state.knot + 1, of.shape.knots,
                                         Fixed(of.SecondsOf(state.knot), 2))))
    state.knot = static_cast<int>(std::lround(knot)) - 1;
  DrawKnot(of, state);
  ui.Gap(12.0f);
}

}  // namespace gaitsmith::shell
