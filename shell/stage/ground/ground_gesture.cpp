// SPDX-License-Identifier: MIT
#include "shell/stage/ground/ground_gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kStrokeGap = 4.0f;    // between two points of a line while it is drawn
constexpr float kDetail = 3.0f;       // how far corners may be from what was drawn [points]
constexpr float kSnap = 6.0f;         // how close to its neighbour's place a corner is put above it [points]
constexpr float kGroundEdge = 40.0f;  // where the view moves along
constexpr float kViewPerS = 260.0f;   // how fast
constexpr float kMouseGrip = 14.0f;
constexpr float kTouchGrip = 26.0f;

ImVec2 OnStage(const Camera& camera, const Corner& corner) {
  return camera.ToScreen(static_cast<double>(corner.x_m), corner.y_m);
}

Corner UnderPointer(const Scene& s) {
  const Camera::Place place = s.camera.ToMetres(ImGui::GetIO().MousePos);
  return {static_cast<float>(place.x_m), place.y_m};
}

std::optional<std::size_t> CornerAt(const Scene& s, ImVec2 point) {
  float near = s.ui.Look().touch ? kTouchGrip : kMouseGrip;
  std::optional<std::size_t> found;
  const std::vector<Corner>& corners = s.session.Ground().Corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ImVec2 at = OnStage(s.camera, corners[i]);
    const float distance = std::hypot(at.x - point.x, at.y - point.y);
    if (distance >= near) continue;
    near = distance;
    found = i;
  }
  return found;
}

// A long line goes on past the edge of the stage.
void MoveView(const Scene& s, const ImRect& open, CameraSettings& gaze) {
  const float x = ImGui::GetIO().MousePos.x;
  const float over = x > open.Max.x - kGroundEdge ? 1.0f : x < open.Min.x + kGroundEdge ? -1.0f : 0.0f;
  gaze.pan_m += static_cast<double>(over * kViewPerS * ImGui::GetIO().DeltaTime / s.camera.scale);
}

void MoveHeld(GroundEditor& ground, GroundGesture& gesture, const Scene& s) {
  if (!gesture.moved && !ImGui::IsMouseDragging(ImGuiMouseButton_Left, kStrokeGap)) return;
  gesture.moved = true;
  ground.ChooseCorner(gesture.held);
  ground.MoveCorner(*gesture.held, UnderPointer(s), kSnap / s.camera.scale);
}

void AddPoint(GroundGesture& gesture, const Scene& s, const ImRect& open, CameraSettings& gaze) {
  MoveView(s, open, gaze);
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (!gesture.drawn.empty()) {
    const ImVec2 last = OnStage(s.camera, gesture.drawn.back());
    if (std::hypot(pointer.x - last.x, pointer.y - last.y) < kStrokeGap) return;
  }
  gesture.drawn.push_back(UnderPointer(s));
}

}  // namespace

Camera AimAtGround(const Playback& player, const Environment& world, const CameraSettings& gaze,
                   const ImRect& rect) {
  constexpr float kTall = 0.34f, kGroundShare = 0.66f;  // of the height: the figure, and from top to ground
  constexpr float kWideM = 9.0f, kNarrowM = 4.5f;       // at least so much is in view
  constexpr double kStartShare = 0.2;                   // of the width, left of the start
  const float across_m = rect.GetWidth() < kPhoneWidth ? kNarrowM : kWideM;
  Camera camera;
  camera.scale =
      gaze.zoom * std::min(kTall * rect.GetHeight() / player.StandingM(), rect.GetWidth() / across_m);
  camera.left_m = gaze.pan_m - kStartShare * static_cast<double>(rect.GetWidth() / camera.scale);
  camera.origin = {rect.Min.x, rect.Min.y + kGroundShare * rect.GetHeight()};
  camera.pivot = static_cast<float>(-camera.left_m) * camera.scale;
  const float slope = GroundAngle(world, 0.0f);
  camera.sine = std::sin(slope);
  camera.cosine = std::cos(slope);
  return camera;
}

void DrawGroundByHand(Session& session, GroundGesture& gesture, const Scene& s, const Touch& stage,
                      const ImRect& open, CameraSettings& gaze) {
  GroundEditor& ground = session.Ground();
  if (stage.began)
    gesture = {.drawn = {}, .held = CornerAt(s, ImGui::GetIO().MouseClickedPos[0]), .moved = false};
  if (stage.held) {
    if (gesture.held)
      MoveHeld(ground, gesture, s);
    else
      AddPoint(gesture, s, open, gaze);
    return;
  }
  if (stage.pressed && !gesture.moved && gesture.drawn.size() < 2)
    ground.ChooseCorner(gesture.held == ground.Chosen() ? std::nullopt : gesture.held);
  const std::vector<Corner> drawn = std::exchange(gesture.drawn, {});
  gesture.held.reset();
  if (drawn.size() > 1) ground.DrawLine(drawn, kDetail / s.camera.scale);
}

void DrawCorners(const Scene& s, const GroundGesture& gesture, const ImRect& open, bool pointed) {
  const Palette& p = s.ui.Ink();
  const std::vector<Corner>& corners = s.session.Ground().Corners();
  const auto chosen = s.session.Ground().Chosen();
  const bool idle = pointed && !s.ui.Look().touch && gesture.drawn.empty();
  std::optional<std::size_t> lit = gesture.held;
  if (!lit && idle) lit = CornerAt(s, ImGui::GetIO().MousePos);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ImVec2 at = OnStage(s.camera, corners[i]);
    const float radius = chosen == i || lit == i ? 7.0f : 5.0f;
    s.list->AddCircleFilled(at, radius, chosen == i ? p.accent : p.paper);
    s.list->AddCircle(at, radius, p.accent, 0, 2.0f);
  }
  if (!gesture.drawn.empty()) {
    std::vector<ImVec2> line;
    line.reserve(gesture.drawn.size());
    for (const Corner& point : gesture.drawn) line.push_back(OnStage(s.camera, point));
    s.list->AddPolyline(line.data(), static_cast<int>(line.size()), p.paper, 0, 6.0f);
    s.list->AddPolyline(line.data(), static_cast<int>(line.size()), p.accent, 0, 3.0f);
  }
  const bool draws = !gesture.drawn.empty() || gesture.moved;
  if (!draws || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  const Corner at = gesture.held && *gesture.held < corners.size() ? corners[*gesture.held] : UnderPointer(s);
  const std::string words = Fixed(at.x_m, 1) + " m, " + Tr("{1} m high", Fixed(at.y_m, 2));
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float half = 0.5f * s.ui.Letters().Width(Type::kStrong, words) + 8.0f;
  const float x = std::clamp(pointer.x, open.Min.x + half, std::max(open.Min.x + half, open.Max.x - half));
  const ImRect plate({x - half, pointer.y - 40.0f}, {x + half, pointer.y - 16.0f});
  s.list->AddRectFilled(plate.Min, plate.Max, Fade(p.paper, 0.85f), 5.0f);
  s.ui.Letters().Draw(s.list, Type::kStrong, plate.GetCenter(), p.accent, words, Align::kCentre);
}

void DrawGroundTools(Ui& ui, Session& session, CameraSettings& gaze, const ImRect& stage) {
  GroundEditor& ground = session.Ground();
  const float height = ui.Look().touch ? 44.0f : 32.0f;
  ImVec2 at(stage.Min.x + 16.0f, stage.Min.y + 10.0f);
  const auto place = [&](const char* words) {
    const ImRect rect(at, {at.x + ui.Letters().Width(Type::kBody, words) + 28.0f, at.y + height});
    at.x = rect.Max.x + 8.0f;
    return rect;
  };
  const char* done = Tr("Done");
  if (ui.Button("stage/ground-done", place(done), done, ButtonLook::kPrimary)) {
    ground.Draw(false);
    gaze = {};
  }
  const char* remove = Tr("Remove corner");
  const auto chosen = ground.Chosen();
  if (ui.Button("stage/corner-remove", place(remove), remove, ButtonLook::kOutlined, chosen.has_value()))
    ground.RemoveCorner(*chosen);
}

}  // namespace gaitsmith::shell
