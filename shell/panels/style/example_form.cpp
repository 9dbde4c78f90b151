// SPDX-License-Identifier: MIT
#include "shell/panels/style/example_form.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/widgets/fold.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr double kDegree = kPi / 180.0;

double SecondsOf(int step) { return static_cast<double>(step) * static_cast<double>(kStep); }

/// The tool's button, and beside it one that forgets what was shown.
void DrawTool(Ui& ui, Session& session, const char* id, const char* forget_id, Teacher::Tool tool,
              const char* take, bool shown, void (Teacher::*forget)()) {
  const ImRect row = ui.ControlRow();
  const float split = shown ? row.Min.x + 0.62f * row.GetWidth() : row.Max.x;
  const bool in_hand = session.Teaching().InHand() == tool;
  if (ui.Button(id, {row.Min, {split - (shown ? 8.0f : 0.0f), row.Max.y}}, in_hand ? Tr("Put it away") : take,
                in_hand ? ButtonLook::kPrimary : ButtonLook::kOutlined))
    session.Teaching().Take(in_hand ? Teacher::Tool::kNone : tool);
  if (shown && ui.Button(forget_id, {{split, row.Min.y}, row.Max}, Tr("Forget it"), ButtonLook::kOutlined,
                         true, tool == Teacher::Tool::kWay ? Tr("Forget the way") : Tr("Forget the pose")))
    (session.Teaching().*forget)();
  ui.Gap(6.0f);
}

void DrawWay(Ui& ui, Session& session, ExampleFormState& state) {
  const std::vector<WayPoint>& way = session.Teaching().Shown().way;
  DrawTool(ui, session, "example/way", "example/way/forget", Teacher::Tool::kWay,
           way.empty() ? Tr("Draw a way on the stage") : Tr("Draw another way"), !way.empty(),
           &Teacher::ForgetWay);
  if (!way.empty()) {
    const auto count = static_cast<int>(way.size());
    state.point = std::clamp(state.point, 1, count);
    const auto index = static_cast<std::size_t>(state.point) - 1;
    WayPoint point = way[index];
    double seconds = SecondsOf(point.step), x_m = static_cast<double>(point.x_m),
           y_m = static_cast<double>(point.y_m);
    ui.Number("example/point", Tr("Point of the way"), state.point, 1, count);
    bool moved = ui.Slider("example/when", Tr("When"), seconds, {.low = 0.0, .high = 30.0, .step = 0.05},
                           Fixed(static_cast<float>(seconds), 2) + " s");
    moved |= ui.Slider("example/along", Tr("Along the ground"), x_m,
                       {.low = -40.0, .high = 40.0, .step = 0.1}, Fixed(point.x_m, 1) + " m");
    moved |= ui.Slider("example/above", Tr("Height of the centre"), y_m,
                       {.low = 0.0, .high = 10.0, .step = 0.05}, Fixed(point.y_m, 2) + " m");
    if (moved) {
      point = {static_cast<int>(std::lround(seconds / static_cast<double>(kStep))), static_cast<float>(x_m),
               static_cast<float>(y_m)};
      session.Teaching().MovePoint(index, point);
    }
    ui.Gap(4.0f);
    if (ui.Button("example/remove", ui.ControlRow(), Tr("Remove this point")))
      session.Teaching().RemovePoint(index);
    ui.Gap(6.0f);
  }
  if (ui.Button("example/here", ui.ControlRow(), Tr("Add where the centre is now")))
    session.Teaching().AddPlaceNow();
}

void DrawPose(Ui& ui, Session& session, ExampleFormState& state) {
  if (session.Doc().figure.HasSprings()) return;  // muscles do not say where the nodes are
  const Demonstration& shown = session.Teaching().Shown();
  DrawTool(ui, session, "example/pose", "example/pose/forget", Teacher::Tool::kPose,
           shown.pose_rad.empty() ? Tr("Pose it at this moment") : Tr("Change the pose"),
           !shown.pose_rad.empty(), &Teacher::ForgetPose);
  if (shown.pose_rad.empty()) return;
  ui.Fact(Tr("When"), Fixed(static_cast<float>(SecondsOf(shown.pose_step)), 2) + " s");
  double turn = static_cast<double>(shown.pose_turn_rad) / kDegree;
  if (ui.Slider("example/turn", Tr("Direction of the body"), turn,
                {.low = -180.0, .high = 180.0, .step = 1.0}, Fixed(static_cast<float>(turn), 0) + "°"))
    session.Teaching().TurnWhole(static_cast<float>(turn * kDegree));
  const auto joints = static_cast<int>(shown.pose_rad.size());
  state.joint = std::clamp(state.joint, 1, joints);
  ui.Number("example/joint", Tr("Joint"), state.joint, 1, joints);
  const auto joint = static_cast<std::size_t>(state.joint) - 1;
  const Rod& rod = session.Doc().figure.rods[joint + 1];
  double angle = static_cast<double>(shown.pose_rad[joint]) / kDegree;
  if (ui.Slider("example/angle", Tr("Its angle"), angle,
                {.low = static_cast<double>(rod.min_rad) / kDegree,
                 .high = static_cast<double>(rod.max_rad) / kDegree,
                 .step = 1.0},
                Fixed(static_cast<float>(angle), 0) + "°"))
    session.Teaching().TurnJoint(joint, static_cast<float>(angle * kDegree));
}

}  // namespace

void DrawExampleForm(Ui& ui, Session& session, ExampleFormState& state) {
  const Demonstration& shown = session.Teaching().Shown();
  const std::string note = shown.way.empty() && shown.pose_rad.empty() ? ""
                           : shown.pose_rad.empty()                    ? Tr("a way")
                           : shown.way.empty()                         ? Tr("a pose")
                                                                       : Tr("a way and a pose");
  if (!DrawFold(ui, "style/example", Tr("Teach by example"), note, state.open)) return;
  ui.Paragraph(session.Doc().figure.HasSprings()
                   ? Tr("Show where its centre should go. The next search comes as close as it can.")
                   : Tr("Show where its centre should go, or a pose at a moment. The next search comes as "
                        "close as it can."),
               Type::kNote);
  ui.Gap(6.0f);
  DrawWay(ui, session, state);
  ui.Gap(12.0f);
  DrawPose(ui, session, state);
  ui.Gap(8.0f);
}

}  // namespace gaitsmith::shell
