// SPDX-License-Identifier: MIT
#include "shell/session/moment_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/rule_words.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// "1.84 m to the right"
std::string WayWords(float travel_m) {
  const std::string metres = Fixed(std::abs(travel_m), 2);
  if (std::abs(travel_m) < 0.005f) return metres + " m";
  return Tr(travel_m > 0.0f ? "{1} m to the right" : "{1} m to the left", metres);
}

std::string ContactWords(const Motion& motion, int frame) {
  if (frame == 0) return "";     // the recorded forces are those of the step before
  constexpr float kMin = 0.02f;  // share of the weight from which the stage draws an arrow
  const float weight = motion.Bones().mass_kg * kStandardGravity;
  std::vector<std::string> touching;
  for (int k = 0; k < motion.Bones().endpoints; ++k) {
    const Motion::Point force = motion.Force(frame, k);
    if (std::hypot(force.x, force.y) >= kMin * weight) touching.push_back(std::to_string(k + 1));
  }
  if (touching.empty()) return std::string(" ") + Tr("Nothing touches the ground.");
  if (touching.size() == 1) return " " + Tr("Endpoint {1} touches the ground.", touching.front());
  std::string words;
  for (std::size_t i = 0; i + 1 < touching.size(); ++i) words += (i == 0 ? "" : ", ") + touching[i];
  return " " + Tr("Endpoints {1} and {2} touch the ground.", words, touching.back());
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
  const std::string name = d.figure.name.empty() ? Tr("The figure") : TrTitle(d.figure.name);
  std::string words =
      Tr("{1} has travelled {2} after {3} s of {4} s.", name, WayWords(player.TermsNow().travel_m),
         Fixed(player.TimeS(), 2), Fixed(player.DurationS(), 2)) +
      ContactWords(motion, frame);
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
  words += " " + ScoreWords(d.task, player.TermsNow());
  if (const Playback* other =
          session.Comparison().Other().Beside() ? session.Comparison().Other().Player() : nullptr) {
    const Terms& terms = other->Shown().TermsAt(std::min(frame, other->Shown().Frames() - 1));
    words += " " + Tr("Beside it, {1}: {2}.", session.Comparison().Words(), WayWords(terms.travel_m));
  }
  return words;
}

}  // namespace gaitsmith::shell
