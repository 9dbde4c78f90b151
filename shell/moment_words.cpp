// SPDX-License-Identifier: MIT
#include "shell/moment_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shell/rule_words.h"
#include "shell/style_words.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

// "1.84 m to the right"
std::string WayWords(float travel_m) {
  std::string metres = Fixed(std::abs(travel_m), 2) + " m";
  if (std::abs(travel_m) < 0.005f) return metres;
  return metres + (travel_m > 0.0f ? " to the right" : " to the left");
}

std::string ContactWords(const Motion& motion, int frame) {
  if (frame == 0) return "";       // forces are of the step before
  constexpr float kLeast = 0.02f;  // of the weight: what the stage draws as an arrow
  const float weight = motion.Bones().mass_kg * kStandardGravity;
  std::vector<std::string> touching;
  for (int k = 0; k < motion.Bones().endpoints; ++k) {
    const Motion::Point force = motion.Force(frame, k);
    if (std::hypot(force.x, force.y) >= kLeast * weight) touching.push_back(std::to_string(k + 1));
  }
  if (touching.empty()) return " Nothing touches the ground.";
  std::string words = touching.size() == 1 ? " Endpoint " : " Endpoints ";
  for (std::size_t i = 0; i < touching.size(); ++i)
    words += (i == 0 ? "" : i + 1 < touching.size() ? ", " : " and ") + touching[i];
  return words + (touching.size() == 1 ? " touches the ground." : " touch the ground.");
}

// The clip in charge, and its controller.
const Controller* InCharge(const Session& session, int frame) {
  const Document& d = session.Doc();
  const int clip = session.player.Shown().At(frame).clip;
  if (clip < 0 || clip >= static_cast<int>(d.timeline.size())) return nullptr;
  return &d.controllers[static_cast<std::size_t>(d.timeline[static_cast<std::size_t>(clip)].controller)];
}

}  // namespace

std::string MomentWords(const Session& session) {
  const Playback& player = session.player;
  std::string words = std::string(player.Playing() ? "Plays at " : "Paused at ") + Fixed(player.TimeS(), 2) +
                      " s, " + WayWords(player.TermsNow().travel_m) + ".";
  const Controller* controller = InCharge(session, player.Frame());
  if (controller != nullptr && controller->kind == ControllerKind::kRules)
    words += " Rule " + std::to_string(player.Shown().At(player.Frame()).rule + 1) + " acts.";
  return words;
}

std::string DescriptionOf(const Session& session) {
  const Playback& player = session.player;
  const Motion& motion = player.Shown();
  const int frame = player.Frame();
  const Document& d = session.Doc();
  std::string words = (d.figure.name.empty() ? "The figure" : d.figure.name) + " has travelled " +
                      WayWords(player.TermsNow().travel_m) + " after " + Fixed(player.TimeS(), 2) + " s of " +
                      Fixed(player.DurationS(), 2) + " s." + ContactWords(motion, frame);
  if (const Controller* controller = InCharge(session, frame)) {
    if (const auto moment = MomentOf(*controller, motion, motion.At(frame).clip, frame)) {
      words += " " + WhyWords(*moment, motion.At(frame).rule);
    } else {
      words += " It is driven by " +
               ControllerWords(controller->kind, controller->senses, controller->rules) + ".";
    }
  } else {
    words += " Nothing drives it: a search finds a controller.";
  }
  words += " " + ScoreWords(d.task, player.TermsNow());
  if (const Playback* other = session.SideBySide() ? session.Ghost() : nullptr) {
    words += " Beside it, " + session.GhostWords() + ": " +
             WayWords(other->Shown().TermsAt(std::min(frame, other->Shown().Frames() - 1)).travel_m) + ".";
  }
  return words;
}

}  // namespace gaitsmith::shell
