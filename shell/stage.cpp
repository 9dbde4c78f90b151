// SPDX-License-Identifier: MIT
// Drawing of the stage, back to front: ground, past poses, trail, figure, forces, numbers.
#include "shell/stage.h"

#include <algorithm>
#include <cmath>

#include "shell/camera.h"
#include "shell/figure_drawing.h"
#include "shell/ground_drawing.h"
#include "shell/push_gesture.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr int kPosesShown = 5;
constexpr float kLeastZoom = 0.1f;
constexpr float kMostZoom = 6.0f;

struct Scene {
  Ui& ui;
  const Session& session;
  const Playback& player;
  ImDrawList* list;
  ImRect rect;
  Camera camera;
  float ground_y;
};

// The figure keeps its size on the stage; where it goes, the camera follows a little later than it.
Camera AimCamera(const Session& session, const StageState& state, const ImRect& rect, float ground_y) {
  const Playback& player = session.player;
  const float reach = player.ReachM();
  const float room = ground_y - rect.Min.y - 70.0f;
  Camera camera;
  const float radius =
      std::clamp(0.155f * rect.GetHeight(), 44.0f, std::max(44.0f, 0.185f * rect.GetWidth()));
  camera.scale =
      state.zoom * std::min(radius / reach, std::max(20.0f, room) / std::max(player.HeightM(), 0.1f));

  // The side it comes from gets more of the stage, since that is where its past stands.
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
  camera.left_m += state.pan_m;
  camera.origin = {rect.Min.x, ground_y};
  camera.pivot = static_cast<float>(x - camera.left_m) * camera.scale;
  const float slope = GroundAngle(session.Doc().environment, static_cast<float>(player.TimeS()));
  camera.sine = std::sin(slope);
  camera.cosine = std::cos(slope);
  return camera;
}

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

// Below the centre of mass as the eye sees it, which on a slope is not at its ground coordinate.
void DrawLetter(const Scene& s, double x_m, float y_m, ImU32 colour, int index) {
  const double foot_m = x_m - static_cast<double>(y_m * s.camera.sine / s.camera.cosine);
  const ImVec2 at = s.camera.ToScreen(foot_m, 0.0f);
  s.ui.Letters().Draw(s.list, Type::kStrong, {at.x, at.y + 42.0f / s.camera.cosine}, colour, LetterOf(index),
                      Align::kCentre);
}

struct Past {
  double oldest_s;  // time of the oldest pose drawn
  int next;         // letter of the figure itself
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
    // A figure that comes back must not stand in its own ghosts.
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

// The path of the centre of mass as dots of equal distance, where they can be seen.
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
    // Between two frames it crossed the whole stage: no eye could follow.
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

// Another motion at the same time, as an outline of another colour: it must not be taken for a past pose.
void DrawGhost(const Scene& s) {
  const Playback* ghost = s.session.Ghost();
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

// Stays as long as what it says is true, and is told to whoever cannot see it.
void DrawNote(const Scene& s, ImVec2 at, const std::string& sentence) {
  const float width =
      std::min(s.ui.Letters().Width(Type::kNote, sentence), s.rect.GetWidth() - 2.0f * (at.x - s.rect.Min.x));
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  s.ui.Area("stage/note", {{at.x, at.y - 9.0f}, {at.x + width, at.y + 9.0f}}, Grab::kPress,
            {.label = sentence, .role = "note"});
  ImGui::PopItemFlag();
  s.ui.Letters().DrawElided(s.list, Type::kNote, at, width + 1.0f, s.ui.Ink().bad, sentence);
}

void DrawNumbers(const Scene& s) {
  const Palette& p = s.ui.Ink();
  const Fonts& letters = s.ui.Letters();
  const Terms& terms = s.player.TermsNow();
  const bool jump = s.session.Doc().task.kind == TaskKind::kJump;
  const float metres = jump ? terms.max_cm_height_m - terms.start_height_m : std::abs(terms.travel_m);
  const ImVec2 at(s.rect.Min.x + 16.0f, s.rect.Min.y + 23.0f);
  letters.Draw(s.list, Type::kNumber, at, p.ink, Fixed(metres, 2) + " m");
  const std::string words = std::string(jump ? "jump" : "travel") + " · slip " + Fixed(terms.slip_sum_m, 1) +
                            " m · " + Fixed(terms.rotations, 1) + " rotations · peak " +
                            Fixed(terms.max_cm_height_m, 2) + " m";
  // The button in the corner reaches down to this line.
  letters.DrawElided(s.list, Type::kNote, {at.x, at.y + 22.0f}, s.rect.GetWidth() - 134.0f, p.second_ink,
                     words);
  const auto remark = [&](ImU32 colour, std::string_view sentence) {
    const float width = s.rect.GetWidth() - 32.0f;
    letters.DrawElided(s.list, Type::kNote, {at.x, at.y + 40.0f}, width, colour, sentence);
    s.ui.Tell(sentence, {{at.x, at.y + 31.0f}, {at.x + width, at.y + 49.0f}});
  };
  if (terms.broke_physics) {
    remark(p.bad, "This motion breaks physics and counts as void.");
  } else if (s.session.WorldChanged()) {
    remark(p.accent, "You changed its world: this is not the motion that was opened.");
  } else if (s.session.DiffersFromMaker()) {
    DrawNote(s, {at.x, at.y + 40.0f}, "This motion differs from the one its maker saw.");
  } else if (s.session.Doc().timeline.empty()) {
    remark(p.accent, "No controller yet: press Synthesize in the Search panel.");
  }
}

void Zoom(StageState& state, const Touch& touch) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (!touch.hovered || wheel == 0.0f) return;
  state.zoom = std::clamp(state.zoom * std::pow(1.15f, wheel), kLeastZoom, kMostZoom);
  if (std::abs(state.zoom - 1.0f) < 0.02f) state.zoom = 1.0f;
}

// What lies between the fingers stays there. Whatever one finger had begun is over.
void TakePinch(Session& session, StageState& state, const ImRect& rect, float ground_y) {
  state.pinch.area = rect;
  if (!state.pinch.Holds()) return;
  if (state.push.drawn) session.player.Play(state.push.was_playing);
  state.push = {};
  state.panning = false;
  const Pinch::Change change = state.pinch.TakeChange();
  const auto metres = [&](float x) {
    const Camera camera = AimCamera(session, state, rect, ground_y);
    return camera.left_m + static_cast<double>((x - rect.Min.x) / camera.scale);
  };
  const double held_m = metres(change.from.x);
  state.zoom = std::clamp(state.zoom * change.zoom, kLeastZoom, kMostZoom);
  state.pan_m += held_m - metres(change.to.x);
}

// @return true when a drag has moved the picture, until it ends
bool Pan(StageState& state, const Touch& touch, float scale) {
  const bool panned = state.panning;
  if (!touch.held) {
    state.panning = false;
    return panned;
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 5.0f)) state.panning = true;
  if (state.panning) state.pan_m -= static_cast<double>(ImGui::GetIO().MouseDelta.x / scale);
  return state.panning;
}

void DrawFollowButton(Ui& ui, StageState& state, const ImRect& rect) {
  const float height = ui.Look().touch ? 40.0f : 32.0f;
  const ImVec2 corner(rect.Max.x - 98.0f, rect.Min.y + 10.0f);
  if (!ui.Button("stage/follow", {{corner.x - 82.0f, corner.y}, {corner.x, corner.y + height}}, "Follow"))
    return;
  state.zoom = 1.0f;
  state.pan_m = 0.0;
}

}  // namespace

void DrawStage(Ui& ui, Session& session, StageState& state, const ImRect& rect, float covered) {
  const PartScope part = ui.Part("stage", "region", "Stage");
  const Terms& terms = session.player.TermsNow();
  ImGui::SetNextItemAllowOverlap();  // its buttons lie on it
  const Touch touch =
      ui.Area("stage", rect, Grab::kPress,
              {.label = "Stage: " + session.Doc().figure.name,
               .role = "img",
               .value = Fixed(terms.travel_m, 2) + " m after " + Fixed(session.player.TimeS(), 2) + " s"});
  Zoom(state, touch);
  const float ground_y = ui.Look().Snap(rect.Max.y - std::clamp(0.178f * rect.GetHeight(), 62.0f, 130.0f));
  const ImRect free(rect.Min, {rect.Max.x - covered, rect.Max.y});
  TakePinch(session, state, free, ground_y);
  const Scene scene{.ui = ui,
                    .session = session,
                    .player = session.player,
                    .list = ui.Canvas(),
                    .rect = rect,
                    .camera = AimCamera(session, state, free, ground_y),
                    .ground_y = ground_y};
  const View& view = session.Doc().view;
  scene.list->PushClipRect(rect.Min, rect.Max, true);
  ui.Behind().Fill(rect, ui.Ink().paper);
  DrawGround(ui, rect, scene.camera);
  const Past past = view.poses ? DrawPast(scene) : Past{std::max(0.0, session.player.TimeS() - 4.0), 0};
  if (view.trail) DrawTrail(scene, past.oldest_s);

  const Motion& motion = session.player.Shown();
  DrawGhost(scene);
  const std::vector<ImVec2> endpoints = OnScreen(scene, session.player, session.player.TimeS());
  const ImU32 active = ActiveColour(scene);
  DrawFigure(scene.list, motion.Bones(), endpoints,
             {.rods = ui.Ink().ink, .joints = active, .width = RodWidth(motion.Bones(), scene.camera.scale)});
  if (view.forces) DrawForces(scene, endpoints);
  const bool pinching = state.pinch.Holds();
  const bool pushing = !pinching && PushByHand(ui, session, state.push, touch, scene.camera, endpoints);
  const bool panned = !pinching && !pushing && Pan(state, touch, scene.camera.scale);
  if (touch.pressed && !pinching && !pushing && !panned) session.player.Play(!session.player.Playing());
  if (view.poses) {
    const Playback::Point centre = session.player.CentreAt(session.player.TimeS());
    DrawLetter(scene, centre.x_m, centre.y_m, active, past.next);
  }
  DrawNumbers(scene);
  ImRect ring = rect;
  ring.Expand(-4.0f);
  ui.DrawFocus(touch, ring, 4.0f);
  scene.list->PopClipRect();
  DrawWorldButton(ui, state.world, rect);
  if (state.zoom != 1.0f || state.pan_m != 0.0) DrawFollowButton(ui, state, rect);
}

}  // namespace gaitsmith::shell
