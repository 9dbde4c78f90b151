// SPDX-License-Identifier: MIT
#include "shell/panels/keyframes/keyframe_form.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/words/language.h"
#include "shell/words/plan_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr double kDegree = kPi / 180.0;

/// The chosen keyframe. A copy, since edits replace the plan.
struct Chosen {
  Ui& ui;
  Session& session;
  int index;
  Keyframe keyframe;

  void Change(const std::function<void(Keyframe&)>& edit) const {
    session.Keyframes().Change([&](Plan& plan) {
      if (index < static_cast<int>(plan.keyframes.size()))
        edit(plan.keyframes[static_cast<std::size_t>(index)]);
    });
  }
};

void DrawPose(const Chosen& of, LimbDrag& drag) {
  const Skeleton bones = of.session.Player().Shown().Bones();
  bool posed = !of.keyframe.pose_rad.empty();
  if (of.ui.Switch("keyframes/posed", Tr("A pose"), posed)) {
    of.Change(
        [&](Keyframe& k) { k.pose_rad.assign(posed ? static_cast<std::size_t>(bones.joints) : 0, 0.0f); });
    return;
  }
  if (!posed) return;
  std::vector<ImU32> colours;
  colours.reserve(static_cast<std::size_t>(bones.joints));
  for (int joint = 0; joint < bones.joints; ++joint) colours.push_back(of.ui.Look().Rule(joint));
  auto edit = DrawPoseBoard(of.ui, "keyframes/pose", Tr("Pose of keyframe {1}: drag a limb", of.index + 1),
                            of.ui.Ink().ink, bones, of.keyframe.pose_rad, {}, drag);
  of.ui.Gap(8.0f);
  if (const auto slid =
          DrawAngleSliders(of.ui, "keyframes/angle", PortsOf(bones), of.keyframe.pose_rad, colours))
    edit = slid;
  if (edit)
    of.Change([&](Keyframe& k) { k.pose_rad[static_cast<std::size_t>(edit->joint)] = edit->angle_rad; });
}

void DrawTurn(const Chosen& of) {
  bool turned = of.keyframe.turned;
  if (of.ui.Switch("keyframes/turned", Tr("A turn of the body"), turned))
    of.Change([&](Keyframe& k) { k.turned = turned; });
  if (!turned) return;
  double degrees = static_cast<double>(of.keyframe.turn_rad) / kDegree;
  if (of.ui.Slider("keyframes/turn", Tr("Turned by"), degrees, {.low = -720.0, .high = 720.0, .step = 5.0},
                   Fixed(degrees, 0) + "°"))
    of.Change([&](Keyframe& k) { k.turn_rad = static_cast<float>(degrees * kDegree); });
}

void DrawMark(const Chosen& of, std::size_t mark) {
  const Mark now = of.keyframe.marks[mark];
  const std::string id = "keyframes/mark/" + std::to_string(mark);
  const auto change = [&](const std::function<void(Mark&)>& edit) {
    of.Change([&](Keyframe& k) {
      if (mark < k.marks.size()) edit(k.marks[mark]);
    });
  };
  of.ui.Gap(4.0f);
  of.ui.Paragraph(PointWords(now.endpoint), Type::kStrong);
  static constexpr std::array<const char*, 3> kAxes = {TrLater("Both"), TrLater("Along"), TrLater("Height")};
  int axes = static_cast<int>(now.axes);
  if (of.ui.Segmented(id + "/axes", of.ui.ControlRow(), Tr("Which of its place counts"), kAxes, axes, ""))
    change([&](Mark& m) { m.axes = static_cast<MarkAxes>(axes); });
  double x = static_cast<double>(now.x_m), y = static_cast<double>(now.y_m);
  if (now.axes != MarkAxes::kUp && of.ui.Slider(id + "/along", Tr("Along the ground"), x,
                                                {.low = -5.0, .high = 5.0, .step = 0.05}, Fixed(x, 2) + " m"))
    change([&](Mark& m) { m.x_m = static_cast<float>(x); });
  if (now.axes != MarkAxes::kAlong &&
      of.ui.Slider(id + "/up", Tr("Above the ground"), y, {.low = 0.0, .high = 5.0, .step = 0.05},
                   Fixed(y, 2) + " m"))
    change([&](Mark& m) { m.y_m = static_cast<float>(y); });
  if (of.ui.Button(id + "/remove", of.ui.ControlRow(), Tr("Remove this mark")))
    of.Change([&](Keyframe& k) { k.marks.erase(k.marks.begin() + static_cast<std::ptrdiff_t>(mark)); });
}

/// A new mark is where the point is in the shown motion.
Mark MarkHere(const Chosen& of, int endpoint) {
  const Motion& motion = of.session.Comparison().PlannedOrShown().Shown();
  const int frame = std::clamp(of.keyframe.step, 0, motion.Frames() - 1);
  double x = motion.At(frame).x_m, y = static_cast<double>(motion.At(frame).y_m);
  if (endpoint != kCentreOfMass) {
    x += static_cast<double>(motion.Endpoint(frame, endpoint).x);
    y += static_cast<double>(motion.Endpoint(frame, endpoint).y);
  }
  return {.endpoint = endpoint,
          .axes = MarkAxes::kAlong,
          .x_m = static_cast<float>(x),
          .y_m = static_cast<float>(y)};
}

void DrawMarks(const Chosen& of, KeyframeFormState& state) {
  for (std::size_t mark = 0; mark < of.keyframe.marks.size(); ++mark) DrawMark(of, mark);
  if (of.keyframe.marks.size() >= kMaxMarks) return;
  std::vector<std::string> points = {Tr("Centre of mass")};
  const int endpoints = of.session.Player().Shown().Bones().endpoints;
  for (int k = 0; k < endpoints; ++k) points.push_back(Tr("Endpoint {1}", k + 1));
  state.mark_endpoint = std::clamp(state.mark_endpoint, 0, endpoints);
  of.ui.Gap(6.0f);
  of.ui.Combo("keyframes/mark-of", Tr("Mark for"), points, state.mark_endpoint);
  if (of.ui.Button("keyframes/mark", of.ui.ControlRow(), Tr("Add a mark")))
    of.Change([&](Keyframe& k) { k.marks.push_back(MarkHere(of, state.mark_endpoint - 1)); });
}

}  // namespace

void DrawKeyframeForm(Ui& ui, Session& session, KeyframeFormState& state) {
  const int keyframe = session.Keyframes().Chosen();
  if (keyframe < 0) return;
  const Chosen of{ui, session, keyframe,
                  session.Keyframes().Shown().keyframes[static_cast<std::size_t>(keyframe)]};
  const PartScope part = ui.Part("keyframe", "group", Tr("Keyframe {1}", keyframe + 1));
  ui.Heading(Tr("Keyframe {1}", keyframe + 1));
  double seconds = of.keyframe.step * kSecondsPerStep;
  if (ui.Slider("keyframes/when", Tr("When"), seconds,
                {.low = kSecondsPerStep,
                 .high = session.Keyframes().Shown().steps * kSecondsPerStep,
                 .step = kSecondsPerStep},
                Fixed(seconds, 2) + " s")) {
    session.Keyframes().MoveKeyframe(keyframe, static_cast<int>(std::lround(seconds / kSecondsPerStep)));
    return;
  }
  DrawPose(of, state.drag);
  ui.Gap(4.0f);
  DrawTurn(of);
  bool still = of.keyframe.still;
  if (ui.Switch("keyframes/still", Tr("At rest"), still)) of.Change([&](Keyframe& k) { k.still = still; });
  DrawMarks(of, state);
  ui.Gap(6.0f);
  if (ui.Button("keyframes/remove", ui.ControlRow(), Tr("Remove this keyframe")))
    session.Keyframes().RemoveKeyframe(keyframe);
}

}  // namespace gaitsmith::shell
