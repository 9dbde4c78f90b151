// SPDX-License-Identifier: MIT
// The shipped motion of the paper's Figure 11: Beryl shuffles, and the body repeats, not only the joints.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "core/rollout/ground_use.h"
#include "tests/scene.h"

namespace gaitsmith {
namespace {

TEST_CASE("figure 11: Beryl shuffles, the same step each second") {
  const auto document = DecodeJson(test::ReadFile("examples/gallery/figure-11.json"));
  REQUIRE(document);
  REQUIRE(document->senses.kind == SenseKind::kTimer);
  const int period = document->senses.period_steps, end = document->duration_steps;
  const Motion motion = Simulate(*document);
  CHECK(document->hash == motion.Hash());

  // A shuffle as docs/style.md defines it, and on the ground.
  const Terms terms = motion.TermsAt(end);
  const GroundUse ground = GroundUseOf(motion);
  CHECK(terms.travel_m > 15.0f);
  CHECK(terms.slip_sum_m >= 0.7f * terms.travel_m);
  CHECK(terms.slip_sum_m <= static_cast<float>(ground.bearers) * terms.travel_m);
  CHECK(terms.rotations < 0.25f);
  CHECK(ground.share > 0.8f);

  // docs/gallery.md: "from 8 s on each second repeats the one before to less than a tenth of a millimetre".
  double height_m = 0.0, lean_rad = 0.0, stride_m = 0.0;
  for (int frame = 800 + period; frame <= end; ++frame) {
    const auto &now = motion.At(frame), &before = motion.At(frame - period);
    height_m = std::max(height_m, std::abs(static_cast<double>(now.y_m - before.y_m)));
    lean_rad = std::max(lean_rad, std::abs(static_cast<double>(now.turn_rad - before.turn_rad)));
    stride_m = now.x_m - before.x_m;
  }
  CHECK(height_m < 1e-4);
  CHECK(lean_rad < 1e-3);
  CHECK(stride_m > 1.0);
}

}  // namespace
}  // namespace gaitsmith
