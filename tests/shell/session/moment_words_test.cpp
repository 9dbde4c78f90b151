// SPDX-License-Identifier: MIT
// Descriptions of the stage agree with the shown motion.
#include "shell/session/moment_words.h"

#include <catch_amalgamated.hpp>
#include <string>

#include "core/world/environment.h"
#include "shell/embedded/embedded.h"
#include "shell/words/wording.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

bool Has(const std::string& words, const std::string& part) { return words.find(part) != std::string::npos; }

TEST_CASE(
    "the description names figure, distance, contacts, the active rule with its reason, and the score") {
  QuietHost host;
  Session session(host);
  session.Player().Seek(2.0);
  session.Player().Play(false);
  REQUIRE_FALSE(session.Doc().timeline.empty());
  const Motion& motion = session.Player().Shown();
  const int frame = session.Player().Frame();
  const std::string rule = "Rule " + std::to_string(motion.At(frame).rule + 1);
  const std::string words = DescriptionOf(session);
  CHECK(words.starts_with(session.Doc().figure.name + " travels "));  // the whole motion comes first
  CHECK(Has(words, " in " + Fixed(session.Player().DurationS(), 2) + " s. It makes no full turn and ends "));
  CHECK(Has(words, " After 2.00 s it has travelled "));
  CHECK(Has(words, rule));
  CHECK(Has(words, " Score "));
  CHECK(Has(MomentWords(session), "Paused at 2.00 s, "));
  CHECK(Has(MomentWords(session), rule + " is active."));
  session.Player().Play(true);
  CHECK(Has(MomentWords(session), "Plays at 2.00 s, "));

  // Frames with contacts, and frames without.
  bool touched = false;
  for (int f = 1; f < motion.Frames(); ++f) {
    bool any = false;
    for (int k = 0; k < motion.Bones().endpoints; ++k)
      any |= motion.Force(f, k).y > 0.05f * motion.Bones().mass_kg * kStandardGravity;
    session.Player().Seek(f * static_cast<double>(motion.StepS()) + 1e-4);
    if (session.Player().Frame() != f) continue;
    const std::string description = DescriptionOf(session);
    CHECK(Has(description, "Nothing touches the ground.") == !any);
    const bool says = Has(description, "touch the ground.") || Has(description, "Endpoint ");
    if (any) CHECK(says);
    touched |= any;
  }
  CHECK(touched);
  session.Player().Seek(0.0);
  CHECK_FALSE(Has(DescriptionOf(session), " the ground."));  // the first frame has no recorded forces
  session.Player().Seek(1.0);
  const float lift_ns = 6.0f * motion.Bones().mass_kg;
  REQUIRE(session.World().Push(kCentreOfMass, 0.0f, lift_ns));
  session.Player().Seek(1.4);
  CHECK(Has(DescriptionOf(session), "Nothing touches the ground."));
}

TEST_CASE("the description names the joints at their greatest torque, where joints are limited") {
  QuietHost host;
  Session session(host);
  const auto described = [&] {
    int named = 0;
    for (int frame = 1; frame < session.Player().Shown().Frames(); frame += 5) {
      session.Player().SeekFrame(frame * 0.01);
      int strained = 0;
      for (const float strain : session.Player().StrainsNow())
        strained += strain >= Playback::kAtLimit ? 1 : 0;
      const std::string words = DescriptionOf(session);
      CHECK(Has(words, "is at its greatest torque.") == (strained == 1));
      CHECK(Has(words, "are at their greatest torque.") == (strained > 1));
      named += strained > 0 ? 1 : 0;
    }
    return named;
  };
  CHECK(session.Player().StrainsNow().empty());
  CHECK(described() == 0);
  session.World().LimitJoints(true);
  session.World().SetJointStrength(0.5f);
  CHECK(session.Player().StrainsNow().size() ==
        static_cast<std::size_t>(session.Player().Shown().Bones().joints));
  CHECK(described() > 0);
}

TEST_CASE("the description says how often the figure turns, and how it ends") {
  QuietHost host;
  Session session(host);
  Document document = session.Doc();
  document.controllers.clear();
  document.timeline.clear();
  document.hash.reset();
  // Spins in the air for a second.
  const auto thrown = [&](float turns_per_s) {
    document.duration_steps = document.task.duration_steps = 100;
    document.start.drop_height_m = 8.0f;
    document.start.spin_radps = turns_per_s * 6.2831853f;
    REQUIRE(session.Open(EncodeJson(document)));
    return DescriptionOf(session);
  };
  CHECK(Has(thrown(0.0f), "It makes no full turn and ends upright."));
  CHECK(Has(thrown(0.5f), "It makes no full turn and ends upside down."));
  CHECK(Has(thrown(0.75f), "It makes no full turn and ends on its side."));
  CHECK(Has(thrown(1.0f), "It makes 1 full turn and ends upright."));
  CHECK(Has(thrown(-2.0f), "It makes 2 full turns and ends upright."));
}

TEST_CASE("without a controller the description reports that there is none yet") {
  QuietHost host;
  Session session(host);
  session.New();
  CHECK(Has(DescriptionOf(session), "The figure has no controller yet."));
  CHECK_FALSE(Has(MomentWords(session), "Rule"));
}

}  // namespace
}  // namespace gaitsmith::shell::test
