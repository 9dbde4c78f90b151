// SPDX-License-Identifier: MIT
#include "shell/stage/teach_gesture.h"

#include <algorithm>
#include <cmath>

#include "shell/body/figure_look.h"
#include "shell/stage/figure_drawing.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kPointGap = 6.0f;     // between two points of a way while it is drawn
constexpr float kWayEdge = 48.0f;     // where the view moves along
constexpr float kAlongPerS = 260.0f;  // how fast
constexpr float kRodGrip = 22.0f;
constexpr float kFingerGrip = 34.0f;

ImVec2 OnStage(const Scene& s, const WayPoint& point) {
  return s.camera.ToScreen(static_cast<double>(point.x_m), point.y_m);
}

/// The centre of mass of the shown motion at the pose's moment, raised as bodies are. It rests while the pose
/// is turned.
Camera::Place PoseCentre(const Scene& s, const TeachGesture& gesture) {
  if (gesture.grip.limb != LimbGrip::kNone) return gesture.centre;
  const Motion& motion = s.player.Shown();
  const Motion::Frame& frame =
      motion.At(std::min(s.session.Teaching().Shown().pose_step, motion.Frames() - 1));
  return {frame.x_m, frame.y_m + (s.rods_only ? 0.0f : LookOf(s.player.ShownFigure()).sole_m)};
}

std::vector<ImVec2> PoseOnStage(const Scene& s, const Demonstration& shown, ImVec2 centre) {
  const Skeleton& bones = s.player.Shown().Bones();
  // Clockwise on the canvas, whose y points down; the slope turns the ground.
  const float turn = shown.pose_turn_rad - bones.start_angle_rad + std::atan2(s.camera.sine, s.camera.cosine);
  const float cosine = std::cos(turn), sine = std::sin(turn);
  std::vector<ImVec2> points;
  for (const ImVec2& p : PoseOf(bones, shown.pose_rad))
    points.push_back({centre.x + s.camera.scale * (p.x * cosine - p.y * sine),
                      centre.y - s.camera.scale * (p.x * sine + p.y * cosine)});
  return points;
}

// A long way goes on past the edge of the stage.
void FollowPointer(const Scene& s, CameraSettings& gaze) {
  const float x = ImGui::GetIO().MousePos.x;
  const float over = x > s.rect.Max.x - kWayEdge ? 1.0f : x < s.rect.Min.x + kWayEdge ? -1.0f : 0.0f;
  gaze.pan_m += static_cast<double>(over * kAlongPerS * ImGui::GetIO().DeltaTime / s.camera.scale);
}

void DrawWayByHand(Session& session, TeachGesture& gesture, const Scene& s, const Touch& stage,
                   CameraSettings& gaze) {
  if (stage.began) gesture.drawn.clear();
  if (stage.held) {
    FollowPointer(s, gaze);
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const bool far =
        gesture.drawn.empty() || std::hypot(pointer.x - OnStage(s, gesture.drawn.back()).x,
                                            pointer.y - OnStage(s, gesture.drawn.back()).y) >= kPointGap;
    const Camera::Place place = s.camera.ToMetres(pointer);
    if (far) gesture.drawn.push_back({0, static_cast<float>(place.x_m), std::max(0.0f, place.y_m)});
    return;
  }
  if (gesture.drawn.empty()) return;
  const std::vector<WayPoint> drawn = std::exchange(gesture.drawn, {});
  if (drawn.size() < 3) return;  // a press without a drag
  session.Teaching().ShowWay(drawn);
  session.Teaching().PutAway();
  gaze = {};
}

void TurnPoseByHand(Session& session, TeachGesture& gesture, const Scene& s, const Touch& stage) {
  const Demonstration& shown = session.Teaching().Shown();
  if (shown.pose_rad.empty()) return;
  const Skeleton& bones = s.player.Shown().Bones();
  const Camera::Place place = PoseCentre(s, gesture);
  const ImVec2 pointer = ImGui::GetIO().MousePos, centre = s.camera.ToScreen(place.x_m, place.y_m);
  const std::vector<ImVec2> points = PoseOnStage(s, shown, centre);
  const auto pivot = [&](int limb) { return limb == 0 ? centre : StartOf(bones, points, limb); };
  const float near = s.ui.Look().touch ? kFingerGrip : kRodGrip;
  if (stage.began) {
    const int limb = LimbAt(bones, points, ImGui::GetIO().MouseClickedPos[0], near, 0);
    gesture.grip = limb == LimbGrip::kNone ? LimbGrip{} : GripOf(bones, points, limb, pivot(limb), pointer);
    gesture.centre = place;
  }
  const int limb = gesture.grip.limb;
  if (!stage.held || limb == LimbGrip::kNone) {
    gesture.grip = {};
    return;
  }
  const float turn = TurnToward(bones, points, gesture.grip, pivot(limb), pointer);
  if (std::abs(turn) < 1e-4f) return;
  if (limb == 0) return session.Teaching().TurnWhole(shown.pose_turn_rad + turn);
  const Skeleton::Limb& bone = bones.limbs[static_cast<std::size_t>(limb)];
  const auto joint = static_cast<std::size_t>(limb) - 1;
  session.Teaching().TurnJoint(joint, std::clamp(shown.pose_rad[joint] + turn, bone.min_rad, bone.max_rad));
}

void DrawWay(const Scene& s, const std::vector<ImVec2>& points) {
  const ImU32 ink = s.ui.Ink().accent, edge = s.ui.Ink().paper;
  s.list->AddPolyline(points.data(), static_cast<int>(points.size()), edge, 0, 7.0f);
  if (points.size() > 1) DrawArrow(s.list, points[points.size() - 2], points.back(), ink, edge);
  s.list->AddPolyline(points.data(), static_cast<int>(points.size()), ink, 0, 3.0f);
}

void DrawPose(const Scene& s, const TeachGesture& gesture, const Demonstration& shown, bool pointed) {
  const Skeleton& bones = s.player.Shown().Bones();
  const Camera::Place place = PoseCentre(s, gesture);
  const std::vector<ImVec2> points = PoseOnStage(s, shown, s.camera.ToScreen(place.x_m, place.y_m));
  const Palette& p = s.ui.Ink();
  const float width = std::max(4.0f, 0.7f * RodWidth(bones, s.camera.scale));
  const bool turns = s.session.Teaching().InHand() == Teacher::Tool::kPose;
  DrawRods(s.list, bones, points, {.rods = p.paper, .width = width + 4.0f});
  DrawRods(s.list, bones, points,
           {.rods = turns ? p.accent : Mix(p.paper, p.accent, 0.6f), .joints = p.paper, .width = width});
  if (!turns) return;
  const float near = s.ui.Look().touch ? kFingerGrip : kRodGrip;
  const int lit = gesture.grip.limb != LimbGrip::kNone
                      ? gesture.grip.limb
                      : (pointed ? LimbAt(bones, points, ImGui::GetIO().MousePos, near, 0) : LimbGrip::kNone);
  if (lit == LimbGrip::kNone) return;
  if (lit > 0)
    DrawReach(s.list, bones, points, lit, shown.pose_rad[static_cast<std::size_t>(lit) - 1],
              Fade(p.accent, 0.4f));
  DrawCapsule(s.list, StartOf(bones, points, lit), points[static_cast<std::size_t>(lit) + 1], width,
              Mix(p.accent, p.ink, 0.45f));
}

}  // namespace

void TeachByHand(Session& session, TeachGesture& gesture, const Scene& s, const Touch& stage,
                 CameraSettings& gaze) {
  if (session.Teaching().InHand() == Teacher::Tool::kWay)
    return DrawWayByHand(session, gesture, s, stage, gaze);
  TurnPoseByHand(session, gesture, s, stage);
}

void DrawShown(const Scene& s, const TeachGesture& gesture, bool pointed) {
  const Demonstration& shown = s.session.Teaching().Shown();
  std::vector<ImVec2> way;
  for (const WayPoint& point : gesture.drawn.empty() ? shown.way : gesture.drawn)
    way.push_back(OnStage(s, point));
  if (!way.empty()) DrawWay(s, way);
  if (gesture.drawn.empty() && !shown.way.empty()) {
    const auto [x_m, y_m] = shown.WayAt(s.player.Frame());
    const ImVec2 due = s.camera.ToScreen(x_m, static_cast<float>(y_m));
    const Playback::Point now = s.player.CentreAt(s.player.TimeS());
    s.list->AddLine(s.camera.ToScreen(now.x_m, now.y_m), due, Fade(s.ui.Ink().accent, 0.6f), 1.5f);
    s.list->AddCircleFilled(due, 6.0f, s.ui.Ink().paper);
    s.list->AddCircle(due, 6.0f, s.ui.Ink().accent, 0, 2.5f);
  }
  if (!shown.pose_rad.empty()) DrawPose(s, gesture, shown, pointed);
}

}  // namespace gaitsmith::shell
