// SPDX-License-Identifier: MIT
#include "shell/stage/scene.h"

#include <algorithm>
#include <cmath>

#include "core/world/environment.h"
#include "core/world/ground_view.h"
#include "shell/stage/figure_drawing.h"
#include "shell/stage/ground/ground_drawing.h"
#include "shell/stage/stage_marks.h"
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

// Draws the figure of a player, with or without a body. Bodies stand on their soles, so they are raised.
void DrawBones(const Scene& s, const Playback& player, double time_s, const BodyInk& ink, float thin = 1.0f) {
  const Figure& figure = player.ShownFigure();
  std::vector<ImVec2> points = OnScreen(s, player, time_s);
  if (s.rods_only) {
    const float width = thin * RodWidth(figure, s.camera.scale) + 2.0f * ink.grow;
    DrawRods(s.list, BarsOf(figure), points,
             {.rods = ink.body, .joints = ink.joints, .width = width, .strain = ink.strain});
    return;
  }
  const ImVec2 raised = RaisedBySoles(s, player);
  for (ImVec2& point : points) point = {point.x + raised.x, point.y + raised.y};
  DrawBody(s.list, LookOf(figure), points, s.camera.scale, ink);
}

// Two ellipses on the ground, smaller and paler the higher the figure is.
void DrawShadow(const Scene& s, const std::vector<ImVec2>& endpoints) {
  if (s.camera.sine != 0.0f || s.rods_only || !s.player.Ground().Level()) return;
  const Palette& p = s.ui.Ink();
  float left = endpoints[0].x, right = left, lowest = endpoints[0].y;
  for (const ImVec2& point : endpoints) {
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    lowest = std::max(lowest, point.y);
  }
  const float above_m = std::clamp((s.camera.origin.y - lowest) / s.camera.scale, 0.0f, 1.0f);
  const float strength = 1.0f - 0.65f * above_m;
  const ImVec2 centre(0.5f * (left + right), s.camera.origin.y + 7.0f);
  const ImU32 ground = GroundColour(p);
  const float half = 0.5f * (right - left) * (1.0f - 0.25f * above_m);
  s.list->AddEllipseFilled(centre, half, 6.0f, Mix(ground, p.ink, 0.07f * strength));
  s.list->AddEllipseFilled(centre, 0.66f * half, 3.7f, Mix(ground, p.ink, 0.15f * strength));
}

ImU32 ActiveColour(const Scene& s) {
  const Motion::Frame& frame = s.player.Shown().At(s.player.Frame());
  return frame.clip < 0 ? s.ui.Ink().second_ink : s.ui.Look().Rule(frame.rule);
}

// Draws a letter vertically below the centre of mass on the screen, also on a slope.
void DrawLetter(const Scene& s, double x_m, float y_m, ImU32 colour, const std::string& letter) {
  constexpr float kHalfWidth = 8.0f, kDepth = 36.0f;
  const Terrain& ground = s.player.Ground();
  const double above_m = static_cast<double>(y_m) - HeightBelow(ground, x_m);
  const double foot_m = x_m - above_m * static_cast<double>(s.camera.sine / s.camera.cosine);
  const ImVec2 at = BelowGround(s.camera, ground, foot_m, kHalfWidth, 0.0f);
  if (at.y + kDepth > s.texts_until && !ground.Level()) return;
  s.ui.Letters().Draw(s.list, Type::kStrong, {at.x, at.y + kDepth / s.camera.cosine}, colour, letter,
                      Align::kCentre);
}

// The pose at each keyframe, with the keyframe's number; the chosen one's in another colour.
void DrawKeyPoses(const Scene& s) {
  const Palette& p = s.ui.Ink();
  const Playback& player = s.session.Comparison().PlannedOrShown();
  const Motion& motion = player.Shown();
  const auto& keyframes = s.session.Keyframes().Shown().keyframes;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    const int frame = std::min(keyframes[k].step, motion.Frames() - 1);
    const bool chosen = s.session.Keyframes().Chosen() == static_cast<int>(k);
    const ImU32 pale = Mix(p.paper, chosen ? p.accent : p.ink, chosen ? 0.3f : 0.18f);
    DrawBones(s, player, frame * static_cast<double>(motion.StepS()),
              {.body = pale, .far = Mix(p.paper, pale, 0.7f)}, 0.72f);
    DrawLetter(s, motion.At(frame).x_m, motion.At(frame).y_m, chosen ? p.accent : p.second_ink,
               std::to_string(k + 1));
  }
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

  for (std::size_t k = 0; k < past.size(); ++k) {
    const int frame = s.player.PoseFrames()[static_cast<std::size_t>(past[k])];
    const double time_s = frame * static_cast<double>(motion.StepS());
    const float depth = 0.14f + 0.05f * static_cast<float>(k + kPosesShown - past.size());
    const ImU32 pale = Mix(p.paper, p.ink, depth);
    DrawBones(s, s.player, time_s, {.body = pale, .far = Mix(p.paper, pale, 0.7f)}, 0.72f);
    DrawLetter(s, motion.At(frame).x_m, motion.At(frame).y_m, p.second_ink, LetterOf(past[k]));
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
      const ImVec2 along((point.x - before.x) / length, (point.y - before.y) / length);
      before = {before.x + due * along.x, before.y + due * along.y};
      // A short line looks like a dot and has a twelfth of a disc's triangles.
      if (s.rect.Contains(before))
        s.list->AddLine({before.x - along.x, before.y - along.y}, {before.x + along.x, before.y + along.y},
                        s.ui.Ink().second_ink, 2.0f);
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
  const Palette& p = s.ui.Ink();
  DrawBones(s, *ghost, s.player.TimeS(), {.body = Mix(p.paper, p.accent, 0.75f)}, 0.8f);
  DrawBones(s, *ghost, s.player.TimeS(), {.body = Mix(p.paper, p.accent, 0.15f), .grow = -1.5f}, 0.8f);
}

// What the running search tries, with an edge of paper, so that figures one behind the other can be told
// apart.
void DrawAttempts(const Scene& s) {
  const Palette& p = s.ui.Ink();
  const Attempts& tried = s.session.Tried();
  float depth = 0.18f;
  for (const Playback& one : tried.Shown()) {
    const ImU32 pale = Mix(p.paper, p.ink, depth * tried.Strength());
    DrawBones(s, one, one.TimeS(), {.body = p.paper, .grow = 2.0f});
    DrawBones(s, one, one.TimeS(), {.body = pale, .far = Mix(p.paper, pale, 0.75f)});
    depth += 0.03f;
  }
}

void DrawForces(const Scene& s, const std::vector<ImVec2>& endpoints) {
  const Motion& motion = s.player.Shown();
  const float weight = motion.Bones().mass_kg * kStandardGravity;
  const float unit = 0.62f * s.player.ReachM() * s.camera.scale;  // length of one body weight
  for (int k = 0; k < motion.Connections().contacts; ++k) {
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

ImVec2 RaisedBySoles(const Scene& s, const Playback& player) {
  if (s.rods_only) return {};
  const float sole = LookOf(player.ShownFigure()).sole_m * s.camera.scale;
  return {-sole * s.camera.sine, -sole * s.camera.cosine};
}

std::vector<ImVec2> DrawScene(const Scene& s) {
  const View& view = s.session.Doc().view;
  const bool rests = s.session.Doc().timeline.empty();
  const bool alone = s.session.Tried().Shown().empty();
  DrawGround(s.ui, s.rect, s.camera, s.player.Ground(), s.texts_until);
  const bool keyframes = ShowsKeyframes(s.session);
  const bool poses = view.poses && !rests && alone && !keyframes;
  const Past past = poses ? DrawPast(s) : Past{std::max(0.0, s.player.TimeS() - 4.0), 0};
  if (keyframes) DrawKeyPoses(s);
  if (view.trail && !rests && alone) DrawTrail(s, past.oldest_s);
  if (!s.session.Comparison().Other().Beside()) DrawGhost(s);
  DrawAttempts(s);
  const Palette& p = s.ui.Ink();
  const std::vector<ImVec2> endpoints = OnScreen(s, s.player, s.player.TimeS());
  DrawShadow(s, endpoints);
  const std::vector<float> strains = view.torques && !rests ? s.player.StrainsNow() : std::vector<float>();
  DrawBones(s, s.player, s.player.TimeS(),
            {.body = p.ink,
             .far = Mix(p.paper, p.ink, kFarShare),
             .rods = Mix(p.ink, p.paper, 0.42f),
             .joints = rests ? 0 : ActiveColour(s),
             .eye = p.paper,
             .strain = {strains, p.strain, p.paper, Playback::kAtLimit}});
  if (view.forces && !rests) DrawForces(s, endpoints);
  if (poses) {
    const Playback::Point centre = s.player.CentreAt(s.player.TimeS());
    DrawLetter(s, centre.x_m, centre.y_m, s.ui.Ink().ink, LetterOf(past.next));
  }
  return endpoints;
}

}  // namespace gaitsmith::shell
