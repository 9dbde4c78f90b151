// SPDX-License-Identifier: MIT
#include "shell/stage/scene.h"

#include <algorithm>
#include <cmath>

#include "shell/stage/figure_drawing.h"
#include "shell/stage/ground_drawing.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr int kPosesShown = 5;

std::vector<ImVec2> OnScreen(const Scene& s, const Playback& player, double time_s) {
  const std::vector<Playback::Point> metres = player.EndpointsAt(time_s);
  std::vector<ImVec2> points;
  points.reserve(metres.size());
  for (const Playback::Point& point : metres) points.push_back(s.camera.ToScreen(point.x_m, point.y_m));
  return points;
}

std::string LetterOf(int index) {
  std::string letters(1, static_cast<char>('A' + index % 26));
  if (index >= 26) letters += std::to_string(index / 26);
  return letters;
}

ImU32 ActiveColour(const Scene& s) {
  const Motion::Frame& frame = s.player.Shown().At(s.player.Frame());
  return frame.clip < 0 ? s.ui.Ink().second_ink : s.ui.Look().Rule(frame.rule);
}

// Draws a letter vertically below the centre of mass on the screen, also on a slope.
void DrawLetter(const Scene& s, double x_m, float y_m, ImU32 colour, int index) {
  const double foot_m = x_m - static_cast<double>(y_m * s.camera.sine / s.camera.cosine);
  const ImVec2 at = s.camera.ToScreen(foot_m, 0.0f);
  s.ui.Letters().Draw(s.list, Type::kStrong, {at.x, at.y + 42.0f / s.camera.cosine}, colour, LetterOf(index),
                      Align::kCentre);
}

struct Past {
  double oldest_s;  // time of the oldest pose drawn
  int next;         // letter of the present pose
};

// Past poses, paler with age.
Past DrawPast(const Scene& s) {
  const Palette& p = s.ui.Ink();
  const Motion& motion = s.player.Shown();
  const double now_x = s.player.CentreAt(s.player.TimeS()).x_m;
  std::vector<int> past;  // indices into PoseFrames
  for (int i = 0; i < static_cast<int>(s.player.PoseFrames().size()); ++i) {
    const int frame = s.player.PoseFrames()[static_cast<std::size_t>(i)];
    if (frame >= s.player.Frame()) break;
    // A figure that comes back must not cover its own past poses.
    if (std::abs(motion.At(frame).x_m - now_x) > 1.3 * static_cast<double>(s.player.ReachM()))
      past.push_back(i);
  }
  if (past.size() > kPosesShown) past.erase(past.begin(), past.end() - kPosesShown);
  if (past.empty()) return {std::max(0.0, s.player.TimeS() - 2.0), 0};

  const float width = 0.72f * RodWidth(motion.Bones(), s.camera.scale);
  for (std::size_t k = 0; k < past.size(); ++k) {
    const int frame = s.player.PoseFrames()[static_cast<std::size_t>(past[k])];
    const double time_s = frame * static_cast<double>(motion.StepS());
    const float depth = 0.14f + 0.05f * static_cast<float>(k + kPosesShown - past.size());
    DrawFigure(s.list, motion.Bones(), OnScreen(s, s.player, time_s),
               {.rods = Mix(p.paper, p.ink, depth), .width = width});
    DrawLetter(s, motion.At(frame).x_m, motion.At(frame).y_m, p.second_ink, past[k]);
  }
  const int oldest = s.player.PoseFrames()[static_cast<std::size_t>(past.front())];
  return {oldest * static_cast<double>(motion.StepS()), past.back() + 1};
}

// The path of the centre of mass as dots at equal distances, if it is long enough to see.
void DrawTrail(const Scene& s, double from_s) {
  constexpr float kSpacing = 7.0f;
  const Motion& motion = s.player.Shown();
  const int last = s.player.Frame();
  const float diagonal = std::hypot(s.rect.GetWidth(), s.rect.GetHeight());
  ImVec2 before = s.camera.ToScreen(motion.At(last).x_m, motion.At(last).y_m);
  float due = kSpacing;
  for (int frame = last - 1; frame >= static_cast<int>(from_s / static_cast<double>(motion.StepS()));
       --frame) {
    const ImVec2 point = s.camera.ToScreen(motion.At(frame).x_m, motion.At(frame).y_m);
    float length = std::hypot(point.x - before.x, point.y - before.y);
    // The path crossed the whole stage between two frames: too fast to see.
    if (length > diagonal) {
      before = point;
      due = kSpacing;
      continue;
    }
    while (length >= due) {
      const float share = due / length;
      before = {before.x + (point.x - before.x) * share, before.y + (point.y - before.y) * share};
      if (s.rect.Contains(before)) s.list->AddCircleFilled(before, 0.95f, s.ui.Ink().second_ink, 8);
      length -= due;
      due = kSpacing;
    }
    due -= length;
    before = point;
  }
}

// The other motion at the same time, in another colour than the past poses.
void DrawGhost(const Scene& s) {
  const Playback* ghost = s.session.Comparison().Other().Player();
  if (ghost == nullptr) return;
  const float width = RodWidth(s.player.Shown().Bones(), s.camera.scale);
  const std::vector<ImVec2> points = OnScreen(s, *ghost, s.player.TimeS());
  const Skeleton& bones = ghost->Shown().Bones();
  DrawFigure(s.list, bones, points,
             {.rods = Mix(s.ui.Ink().paper, s.ui.Ink().accent, 0.75f), .width = 0.8f * width});
  DrawFigure(s.list, bones, points,
             {.rods = Mix(s.ui.Ink().paper, s.ui.Ink().accent, 0.15f), .width = 0.8f * width - 3.0f});
}

void DrawForces(const Scene& s, const std::vector<ImVec2>& endpoints) {
  const Motion& motion = s.player.Shown();
  const float weight = motion.Bones().mass_kg * kStandardGravity;
  const float unit = 0.62f * s.player.ReachM() * s.camera.scale;  // length of one body weight
  for (int k = 0; k < motion.Bones().endpoints; ++k) {
    const Motion::Point force = motion.Force(s.player.Frame(), k);
    const float size = std::hypot(force.x, force.y) / weight;
    if (!(size >= 0.02f) || !std::isfinite(size)) continue;
    const float length = unit * std::min(size, 2.2f);
    const float x = force.x / (size * weight) * length;
    const float y = force.y / (size * weight) * length;
    const ImVec2 from = endpoints[static_cast<std::size_t>(k)];
    const ImVec2 to(from.x + x * s.camera.cosine - y * s.camera.sine,
                    from.y - x * s.camera.sine - y * s.camera.cosine);
    DrawArrow(s.list, from, to, ActiveColour(s), Fade(s.ui.Ink().paper, 0.85f));
  }
}

}  // namespace

Camera AimCamera(const Playback& player, const Environment& world, const CameraSettings& gaze,
                 const ImRect& rect, float ground_y) {
  const float reach = player.ReachM();
  const float room = ground_y - rect.Min.y - 70.0f;
  Camera camera;
  const float radius =
      std::clamp(0.155f * rect.GetHeight(), 44.0f, std::max(44.0f, 0.185f * rect.GetWidth()));
  camera.scale =
      gaze.zoom * std::min(radius / reach, std::max(20.0f, room) / std::max(player.HeightM(), 0.1f));

  // Leave more space behind the figure, for its past poses.
  const double width_m = static_cast<double>(rect.GetWidth() / camera.scale);
  const double margin_m = 1.35 * static_cast<double>(reach);
  const auto finite = [](double metres) { return std::isfinite(metres) ? metres : 0.0; };
  const double x = finite(player.CameraXAt(player.TimeS()));
  const double end_m = finite(player.Shown().At(player.Shown().Frames() - 1).x_m);
  if (std::abs(end_m) < margin_m) {
    camera.left_m = x - 0.5 * width_m;
  } else if (end_m < 0.0) {
    camera.left_m = std::max(std::min(x - 0.29 * width_m, margin_m - width_m), x - 0.8 * width_m);
  } else {
    camera.left_m = std::min(std::max(x - 0.71 * width_m, -margin_m), x - 0.2 * width_m);
  }
  camera.left_m += gaze.pan_m;
  camera.origin = {rect.Min.x, ground_y};
  camera.pivot = static_cast<float>(x - camera.left_m) * camera.scale;
  const float slope = GroundAngle(world, static_cast<float>(player.TimeS()));
  camera.sine = std::sin(slope);
  camera.cosine = std::cos(slope);
  return camera;
}

std::vector<ImVec2> DrawScene(const Scene& s) {
  const View& view = s.session.Doc().view;
  DrawGround(s.ui, s.rect, s.camera);
  const Past past = view.poses ? DrawPast(s) : Past{std::max(0.0, s.player.TimeS() - 4.0), 0};
  if (view.trail) DrawTrail(s, past.oldest_s);
  if (!s.session.Comparison().Other().Beside()) DrawGhost(s);
  const Motion& motion = s.player.Shown();
  const std::vector<ImVec2> endpoints = OnScreen(s, s.player, s.player.TimeS());
  const ImU32 active = ActiveColour(s);
  DrawFigure(s.list, motion.Bones(), endpoints,
             {.rods = s.ui.Ink().ink, .joints = active, .width = RodWidth(motion.Bones(), s.camera.scale)});
  if (view.forces) DrawForces(s, endpoints);
  if (view.poses) {
    const Playback::Point centre = s.player.CentreAt(s.player.TimeS());
    DrawLetter(s, centre.x_m, centre.y_m, s.ui.Ink().ink, past.next);
  }
  return endpoints;
}

}  // namespace gaitsmith::shell
