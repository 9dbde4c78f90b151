// SPDX-License-Identifier: MIT
#include "shell/session/moment_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/world/environment.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// "It makes 2 full turns and ends upright."
std::string TurnWords(const Motion& motion) {
  const int last = motion.Frames() - 1;
  constexpr float kNearlyFull = 0.9f;  // share of a turn that counts as a full one
  const auto full = static_cast<int>(motion.TermsAt(last).rotations + 1.0f - kNearlyFull);
  const double turn_rad = motion.At(last).turn_rad - static_cast<double>(motion.Bones().start_angle_rad);
  const double upright = std::cos(turn_rad);  // 1: as drawn, -1: upside down
  const char* turns = full == 0   ? TrLater("It makes no full turn")
                      : full == 1 ? TrLater("It makes 1 full turn")
                                  : TrLater("It makes {1} full turns");
  const char* end = upright > 0.5    ? TrLater("{1} and ends upright.")
                    : upright < -0.5 ? TrLater("{1} and ends upside down.")
                                     : TrLater("{1} and ends on its side.");
  return Tr(end, Tr(turns, full));
}

// The whole motion in words.
std::string WholeWords(const Session& session) {
  const Playback& player = session.Player();
  const Motion& motion = player.Shown();
  const Document& d = session.Doc();
  const std::string name = d.figure.name.empty() ? Tr("The figure") : TrTitle(d.figure.name);
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);
  if (terms.broke_physics) return Tr("The simulation failed, so this motion doesn't count.");
  std::string words =
      Tr("{1} travels {2} in {3} s.", name, WayWords(terms.travel_m), Fixed(player.DurationS(), 2));
  if (d.task.kind == TaskKind::kJump)
    words += " " + Tr("Its centre rises {1} m.", AmountText(terms.max_cm_height_m - terms.start_height_m, 2));
  return words + " " + TurnWords(motion);
}

std::string ContactWords(const Motion& motion, int frame) {
  if (frame == 0) return "";     // the recorded forces are those of the step before
  constexpr float kMin = 0.02f;  // share of the weight from which the stage draws an arrow
  const float weight = motion.Bones().mass_kg * kStandardGravity;
  std::vector<std::string> touching;
  for (int k = 0; k < motion.Connections().contacts; ++k) {
    const Motion::Point force = motion.Force(frame, k);
    if (std::hypot(force.x, force.y) >= kMin * weight) touching.push_back(std::to_string(k + 1));
  }
  if (touching.empty()) return std::string(" ") + Tr("Nothing touches the ground.");
  const bool nodes = motion.Connections().muscles;
  if (touching.size() == 1)
    return " " +
           Tr(nodes ? "Node {1} touches the ground." : "Endpoint {1} touches the ground.", touching.front());
  std::string words;
  for (std::size_t i = 0; i + 1 < touching.size(); ++i) words += (i == 0 ? "" : ", ") + touching[i];
  return " " + Tr(nodes ? "Nodes {1} and {2} touch the ground." : "Endpoints {1} and {2} touch the ground.",
                  words, touching.back());
}

// " Joints 2 and 5 are at their greatest torque.", or nothing.
std::string StrainWords(const Playback& player) {
  std::vector<std::string> joints;
  for (int number = 1; const float strain : player.StrainsNow()) {
    if (strain >= Playback::kAtLimit) joints.push_back(std::to_string(number));
    ++number;
  }
  if (joints.empty()) return "";
  if (joints.size() == 1) return " " + Tr("Joint {1} is at its greatest torque.", joints.front());
  std::string words;
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) words += (i == 0 ? "" : ", ") + joints[i];
  return " " + Tr("Joints {1} and {2} are at their greatest torque.", words, joints.back());
}

// The controller that is active at a frame; null without a clip.
const Controller* InCharge(const Session& session, int frame) {
  const Document& d = session.Doc();
  const int clip = session.Player().Shown().At(frame).clip;
  if (clip < 0 || clip >= static_cast<int>(d.timeline.size())) return nullptr;
  return &d.controllers[static_cast<std::size_t>(d.timeline[static_cast<std::size_t>(clip)].controller)];
}

}  // namespace

std::string MomentWords(const Session& session) {
  const Playback& player = session.Player();
  std::string words = Tr(player.Playing() ? "Plays at {1} s, {2}." : "Paused at {1} s, {2}.",
                         Fixed(player.TimeS(), 2), WayWords(player.TermsNow().travel_m));
  const Controller* controller = InCharge(session, player.Frame());
  if (controller != nullptr && controller->kind == ControllerKind::kRules)
    words += " " + Tr("Rule {1} is active.", player.Shown().At(player.Frame()).rule + 1);
  return words;
}

std::string DescriptionOf(const Session& session) {
  const Playback& player = session.Player();
  const Motion& motion = player.Shown();
  const int frame = player.Frame();
  const Document& d = session.Doc();
  std::string words = WholeWords(session) + " " +
                      Tr("After {1} s it has travelled {2}.", Fixed(player.TimeS(), 2),
                         WayWords(player.TermsNow().travel_m)) +
                      ContactWords(motion, frame) + StrainWords(player);
  if (const Controller* controller = InCharge(session, frame)) {
    if (const auto moment = MomentOf(*controller, motion, motion.At(frame).clip, frame)) {
      words += " " + WhyWords(*moment, motion.At(frame).rule);
    } else {
      words += " " + Tr("It is driven by {1}.",
                        ControllerWords(controller->kind, controller->senses, controller->rules));
    }
  } else {
    words += std::string(" ") + Tr("The figure has no controller yet. A search finds one.");
  }
  words += " " + ScoreWords(d, player.TermsNow());
  if (const Playback* other =
          session.Comparison().Other().Beside() ? session.Comparison().Other().Player() : nullptr) {
    const Terms& terms = other->Shown().TermsAt(std::min(frame, other->Shown().Frames() - 1));
    words += " " + Tr("Beside it, {1}: {2}.", session.Comparison().Words(), WayWords(terms.travel_m));
  }
  return words;
}

}  // namespace gaitsmith::shell
