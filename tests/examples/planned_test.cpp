// SPDX-License-Identifier: MIT
// The planned motions that are shipped: each is the plan of its name, solved, and played within a centimetre
// of its marks, as docs/spacetime.md says.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "core/planning/plan_draft.h"
#include "core/planning/plan_playback.h"
#include "core/planning/plan_recorder.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("planned: each shipped plan is solved, and played within a centimetre of its marks", "[planned]") {
  const char* name =
      GENERATE("acrobat-somersault", "biped-step", "lamp-hurdle", "lamp-jump", "star-man-cartwheel");
  CAPTURE(name);
  const auto plan = DecodeJson(ReadFile("examples/plans/" + std::string(name) + ".json"));
  const auto planned = DecodeJson(ReadFile("examples/planned/" + std::string(name) + ".json"));
  REQUIRE((plan && planned));
  CHECK(SameWishes(plan->plan, planned->plan));
  REQUIRE_FALSE(planned->plan.solved.unknowns.empty());
  const Motion played = Simulate(*planned);
  CHECK(played.Hash() == planned->hash.value());
  CHECK_FALSE(played.TermsAt(played.Frames() - 1).broke_physics);
  const Keyframe& last = planned->plan.keyframes.back();
  const double mark = static_cast<double>(last.marks[0].x_m);
  CHECK(std::abs(played.At(last.step).x_m - mark) < 0.01);
  // And it stands there the right way up.
  const double turned = played.At(last.step).turn_rad - static_cast<double>(played.Bones().start_angle_rad);
  CHECK(std::abs(turned - static_cast<double>(last.turn_rad)) < 0.05);
  // The planned motion, as every exporter sees it.
  const PlannedMotion solved = SolvedMotion(*planned);
  const Motion recorded = RecordPlanned(*planned, solved);
  CHECK(recorded.Frames() == played.Frames());
  CHECK(std::abs(recorded.At(last.step).x_m - mark) < 1e-4);
  CHECK(std::abs(recorded.At(last.step).turn_rad - static_cast<double>(recorded.Bones().start_angle_rad) -
                 static_cast<double>(last.turn_rad)) < 1e-4);
  for (const Stance& stance : planned->plan.stances) {
    const int middle = (stance.first_step + stance.last_step) / 2;
    CHECK(std::abs(static_cast<float>(recorded.At(middle).y_m) +
                   recorded.Endpoint(middle, stance.endpoint).y) < 0.01f);
  }
}

}  // namespace gaitsmith::test
