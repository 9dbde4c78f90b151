// SPDX-License-Identifier: MIT
// The stage's layout, its numbers, and gestures on it.
#include "shell/stage/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shell/stage/felt_senses.h"
#include "shell/stage/invitation.h"
#include "shell/stage/push_gesture.h"
#include "shell/stage/scene.h"
#include "shell/stage/stage_actions.h"
#include "shell/stage/stage_marks.h"
#include "shell/stage/viewer.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kMinZoom = 0.1f;
constexpr float kMaxZoom = 6.0f;
constexpr float kStageSide = 16.0f;
constexpr float kRemark = 71.0f;       // from the stage's top
constexpr float kCornerRoom = 114.0f;  // width reserved for the button in the corner

// A note about the motion, announced by screen readers.
void DrawNote(const Scene& s, ImVec2 at, const std::string& sentence) {
  const float width =
      std::min(s.ui.Letters().Width(Type::kNote, sentence), s.rect.GetWidth() - 2.0f * (at.x - s.rect.Min.x));
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop, true);
  s.ui.Area("stage/note", {{at.x, at.y - 9.0f}, {at.x + width, at.y + 9.0f}}, Grab::kPress,
            {.label = sentence, .role = "note"});
  ImGui::PopItemFlag();
  s.ui.Letters().DrawElided(s.list, Type::kNote, at, width + 1.0f, s.ui.Ink().bad, sentence);
}

/// @param name of the control mode, if two motions are compared
/// @param clear width of the second line, which a button in the corner may cover [points]
void DrawNumbers(const Scene& s, const std::string& name, float clear) {
  const Palette& p = s.ui.Ink();
  const Fonts& letters = s.ui.Letters();
  const Terms& terms = s.player.TermsNow();
  const bool jump = s.session.Doc().task.kind == TaskKind::kJump;
  const float metres = jump ? terms.max_cm_height_m - terms.start_height_m : terms.travel_m;
  const ImVec2 at(s.rect.Min.x + 16.0f, s.rect.Min.y + 27.0f);
  letters.Draw(s.list, Type::kTitle, at, p.ink, Fixed(metres, 2) + " m");
  const std::string words = !name.empty()
                                ? name
                                : Tr(jump ? "jump in {1} s · slid {2} m · {3} turns · up to {4} m high"
                                          : "in {1} s · slid {2} m · {3} turns · up to {4} m high",
                                     Fixed(s.player.TimeS(), 1), Fixed(terms.slip_sum_m, 1),
                                     Fixed(terms.rotations, 1), Fixed(terms.max_cm_height_m, 2));
  letters.DrawElided(s.list, Type::kNote, {at.x, at.y + 27.0f}, clear, p.second_ink, words);
}

/// @param y of its centre. @param clear its greatest width
void DrawRemark(const Scene& s, float y, float clear) {
  const Palette& p = s.ui.Ink();
  const Fonts& letters = s.ui.Letters();
  const Terms& terms = s.player.TermsNow();
  const ImVec2 at(s.rect.Min.x + 16.0f, y);
  const auto remark = [&](ImU32 colour, std::string_view sentence) {
    letters.DrawElided(s.list, Type::kNote, at, clear, colour, sentence);
    s.ui.DescribeText(sentence, {{at.x, at.y - 9.0f}, {at.x + clear, at.y + 9.0f}});
  };
  if (s.session.Ground().Drawing()) {
    remark(p.accent, Tr("Drag to draw the ground or to move a corner."));
  } else if (s.session.Teaching().InHand() == Teacher::Tool::kWay) {
    remark(p.accent, Tr("Drag along the way that the figure's centre should take."));
  } else if (s.session.Teaching().InHand() == Teacher::Tool::kPose) {
    remark(p.accent, Tr("Drag the limbs of the coloured pose. Drag its body to turn all of it."));
  } else if (s.session.Following().Previewing()) {
    remark(p.accent, Tr("Preview: let go to keep what is found."));
  } else if (terms.broke_physics) {
    remark(p.bad, Tr("The simulation failed, so this motion doesn't count."));
  } else if (s.session.World().Changed()) {
    remark(p.accent, Tr("You changed the world, so the motion differs from the one you opened."));
  } else if (s.session.DiffersFromMaker()) {
    DrawNote(s, at, Tr("This motion differs from the one its maker saw."));
  }
}

void Zoom(StageState& state, const Touch& touch) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (!touch.hovered || wheel == 0.0f) return;
  state.gaze.zoom = std::clamp(state.gaze.zoom * std::pow(1.15f, wheel), kMinZoom, kMaxZoom);
  if (std::abs(state.gaze.zoom - 1.0f) < 0.02f) state.gaze.zoom = 1.0f;
}

Camera CameraOf(const Session& session, const CameraSettings& gaze, const ImRect& rect, float ground_y,
                const std::optional<Framing>& framing) {
  const Environment& world = session.Doc().environment;
  if (session.Ground().Drawing() && !session.Viewing())
    return AimAtGround(session.Player(), world, gaze, rect);
  return AimCamera(session.Player(), world, gaze, rect, ground_y, framing);
}

// Zooms about the point between the fingers, and cancels a gesture of one finger.
/// @param area of the whole stage. @param rect of the figure. When motions are compared, a rectangle of the
/// same width is beside it
void TakePinch(Session& session, StageState& state, const ImRect& area, const ImRect& rect, float ground_y,
               const std::optional<Framing>& framing) {
  state.pinch.area = area;
  if (!state.pinch.Holds()) return;
  if (state.push.drawn) session.Player().Play(state.push.was_playing);
  state.push = {};
  state.panning = false;
  const Pinch::Change change = state.pinch.TakeChange();
  const auto metres = [&](float x) {
    const Camera camera = CameraOf(session, state.gaze, rect, ground_y, framing);
    const float across = x > rect.Max.x ? x - rect.Max.x : x - rect.Min.x;
    return camera.left_m + static_cast<double>(across / camera.scale);
  };
  const double held_m = metres(change.from.x);
  state.gaze.zoom = std::clamp(state.gaze.zoom * change.zoom, kMinZoom, kMaxZoom);
  state.gaze.pan_m += held_m - metres(change.to.x);
}

// @return true once a drag has moved the picture, until the drag ends
bool Pan(StageState& state, const Touch& touch, float scale) {
  const bool panned = state.panning;
  if (!touch.held) {
    state.panning = false;
    return panned;
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 5.0f)) state.panning = true;
  if (state.panning) state.gaze.pan_m -= static_cast<double>(ImGui::GetIO().MouseDelta.x / scale);
  return state.panning;
}

/// @param corner of the button, at the upper right
void DrawFollowButton(Ui& ui, StageState& state, ImVec2 corner) {
  const float height = ui.Look().touch ? 44.0f : 32.0f;
  if (!ui.Button("stage/follow", {{corner.x - 82.0f, corner.y}, {corner.x, corner.y + height}}, Tr("Follow")))
    return;
  state.gaze.zoom = 1.0f;
  state.gaze.pan_m = 0.0;
}

// Draws the other motion in the right half of the stage.
void DrawBeside(Ui& ui, Session& session, const StageState& state, const ImRect& half, const ImRect& free,
                float ground_y) {
  const Playback& other = *session.Comparison().Other().Player();
  const Environment& world = session.Comparison().Other().Source() == Ghost::Kind::kAsOpened
                                 ? session.World().AsOpened().environment
                                 : session.Doc().environment;
  const Scene scene{.ui = ui,
                    .session = session,
                    .player = other,
                    .list = ui.Canvas(),
                    .rect = half,
                    .camera = AimCamera(other, world, state.gaze, free, ground_y),
                    .rods_only = state.world.rods_only};
  const PartScope part = ui.Part("beside", "group", Tr("Beside it"));
  ui.DescribeText(
      Tr("Beside it: {1}, {2} m.", session.Comparison().Words(), Fixed(other.TermsNow().travel_m, 2)), half);
  scene.list->PushClipRect(half.Min, half.Max, true);
  DrawScene(scene);
  DrawNumbers(scene, session.Comparison().Words(), half.GetWidth() - kCornerRoom);
  scene.list->PopClipRect();
  ui.VerticalLine(half.Min.x, half.Min.y, half.Max.y);
}

}  // namespace

void DrawStage(Ui& ui, Session& session, StageState& state, const ImRect& rect, float covered) {
  const PartScope part = ui.Part("stage", "region", Tr("Stage"));
  const Terms& terms = session.Player().TermsNow();
  ImGui::SetNextItemAllowOverlap();  // the stage's buttons lie on top of it
  const Touch touch = ui.Area(
      "stage", rect, Grab::kPress,
      {.label = Tr("Stage: {1}", TrTitle(session.Doc().figure.name)),
       .role = "img",
       .value = Tr("{1} m after {2} s", Fixed(terms.travel_m, 2), Fixed(session.Player().TimeS(), 2))});
  Zoom(state, touch);
  const ImRect open(rect.Min, {rect.Max.x - covered, rect.Max.y});
  const bool viewing = session.Viewing();
  const bool drawing = !viewing && session.Ground().Drawing();
  const bool acts = viewing || (!drawing && HasStageActions(session, open));
  if (drawing) session.Teaching().PutAway();
  const bool teaching = !viewing && session.Teaching().InHand() != Teacher::Tool::kNone;
  const bool by_hand = teaching || drawing;  // a drag is for what is drawn, not for the figure
  const bool invites = acts && Invites(session) && !by_hand;
  const bool beside = invites && InvitesBeside(open);
  const float ground_y = ui.Look().Snap(rect.Max.y - GroundRoom(rect.GetHeight(), acts && !beside));
  const auto framing = invites ? std::optional(InvitationFraming(open)) : std::nullopt;
  const bool two = session.Comparison().Other().Beside() && !drawing;
  session.Comparison().KeepInTime();
  const float middle = two ? ui.Look().Snap(0.5f * (rect.Min.x + open.Max.x)) : rect.Max.x;
  const ImRect own(rect.Min, {middle, rect.Max.y});
  const ImRect free(rect.Min, {std::min(middle, open.Max.x), rect.Max.y});
  TakePinch(session, state, open, free, ground_y, framing);
  if (invites) state.gaze = {};  // nothing moves, and all of it is in view
  const Scene scene{.ui = ui,
                    .session = session,
                    .player = session.Player(),
                    .list = ui.Canvas(),
                    .rect = own,
                    .camera = CameraOf(session, state.gaze, free, ground_y, framing),
                    .rods_only = state.world.rods_only,
                    .texts_until = acts ? ActionRow(ui, session, open, ground_y).Min.y : rect.Max.y};
  ui.Behind().Fill(rect, ui.Ink().paper);
  scene.list->PushClipRect(own.Min, own.Max, true);
  const std::vector<ImVec2> endpoints = DrawScene(scene);
  const int felt = std::exchange(state.felt_rule, -1);  // the panel says it again in each frame
  if (const Controller* driver = session.Timeline().ShownController(); driver != nullptr && !viewing)
    DrawFeltSenses(scene, *driver, felt, endpoints);
  const bool pinching = state.pinch.Holds();
  if (!viewing) DrawShown(scene, state.teach, touch.hovered);
  if (teaching && !pinching) TeachByHand(session, state.teach, scene, touch, state.gaze);
  if (!teaching) state.teach = {};
  if (drawing && !pinching) DrawGroundByHand(session, state.ground, scene, touch, free, state.gaze);
  if (!drawing || pinching) state.ground = {};
  if (drawing) DrawCorners(scene, state.ground, free, touch.hovered);
  if (ShowsKeyframes(session) && !pinching && !by_hand) DrawMarks(session, scene);
  const bool pushing =
      !pinching && !by_hand && PushByHand(ui, session, state.push, touch, scene.camera, endpoints);
  const bool panned = !pinching && !pushing && !by_hand && Pan(state, touch, scene.camera.scale);
  if (touch.pressed && !pinching && !pushing && !panned && !by_hand)
    session.Player().Play(!session.Player().Playing());
  const Controller* shown = session.Timeline().ShownController();
  const std::string name = two && shown != nullptr ? ControlModeWords(shown->kind, shown->senses) : "";
  const bool moved = !invites && (state.gaze.zoom != 1.0f || state.gaze.pan_m != 0.0);
  const float clear = (moved ? open.Max.x - kCornerRoom : own.Max.x - kStageSide) - own.Min.x - kStageSide;
  // The button Follow is below the numbers and beside the remark.
  ImVec2 follow(open.Max.x - 12.0f, rect.Min.y + 66.0f);
  if (viewing) {
    const float y = DrawViewerWords(ui, session, own);
    follow.y = y - 6.0f;
    DrawRemark(scene, y, clear);
  } else if (drawing) {
    DrawRemark(scene, own.Min.y + kRemark, std::min(clear, own.GetWidth() - 2.0f * kStageSide));
  } else if (!invites) {
    DrawNumbers(scene, name, own.GetWidth() - (two ? 2.0f * kStageSide : kCornerRoom));
    DrawRemark(scene, own.Min.y + kRemark, std::min(clear, own.GetWidth() - 2.0f * kStageSide));
  }
  scene.list->PopClipRect();
  if (two)
    DrawBeside(ui, session, state, {{middle, rect.Min.y}, rect.Max},
               {{middle, rect.Min.y}, {open.Max.x, rect.Max.y}}, ground_y);
  ImRect ring = rect;
  ring.Expand(-4.0f);
  scene.list->PushClipRect(rect.Min, rect.Max, true);
  ui.DrawFocus(touch, ring, 4.0f);
  scene.list->PopClipRect();
  if (invites) DrawInvitation(ui, session, open);
  if (drawing) DrawGroundTools(ui, session, state.gaze, rect);
  if (acts) {
    const ImRect row = ActionRow(ui, session, open, ground_y);
    if (viewing) {
      state.asks_for_rules |= DrawViewerActions(ui, session, row);
    } else {
      DrawStageActions(ui, session, row);
    }
  }
  if ((!invites && !viewing) || beside || state.world.open) DrawWorldButton(ui, state.world, rect);
  if (moved) DrawFollowButton(ui, state, follow);
}

}  // namespace gaitsmith::shell
