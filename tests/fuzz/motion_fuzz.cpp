// SPDX-License-Identifier: MIT
// Figure x controller x start, whatever they are: the motion is finite or void, the same bits twice, the same
// bits in every lane count, and endpoints stay above the ground.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/document/binary.h"
#include "core/physics/evaluator.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  BitReader bits(std::span(data, size));
  const auto between = [&](float low, float high) {
    return std::min(high, low + (high - low) * static_cast<float>(bits.Take(12)) * (1.0f / 4095.0f));
  };
  Document d;
  const int rods = 1 + static_cast<int>(bits.Take(4));
  for (int i = 0; i < rods; ++i) {
    Rod rod;
    rod.length_m = bits.Take(1) != 0 ? between(0.001f, 2.0f) : between(0.1f, 1000.0f);
    rod.mass_kg = between(0.01f, 20.0f);
    rod.rest_rad = between(-3.1f, 3.1f);
    rod.parent = i == 0 ? kNoParent : static_cast<int>(bits.Take(4)) % i;
    rod.parent_end = bits.Take(1) != 0 ? RodEnd::kEnd : RodEnd::kStart;
    d.figure.rods.push_back(rod);
  }
  d.environment = {between(0.0f, 100.0f), between(0.0f, 10.0f), between(-0.6f, 0.6f), between(0.0f, 0.6f),
                   between(0.5f, 60.0f)};
  if (bits.Take(1) != 0) d.environment.sway_rad = 0.0f;
  d.start = {between(0.0f, 100.0f), between(-100.0f, 100.0f), between(-100.0f, 100.0f),
             between(-40.0f, 40.0f)};
  d.senses.kind = bits.Take(1) != 0 ? SenseKind::kTimer : SenseKind::kPhysical;
  if (d.senses.kind == SenseKind::kPhysical && bits.Take(1) != 0) d.kind = ControllerKind::kNetwork;
  d.senses.tau_min_s = between(0.02f, 1.0f);
  d.task.duration_steps = d.duration_steps = 60;
  RandomStream random(bits.Take(64), 0, 0);
  d.controllers = {
      {"", d.kind, d.senses, d.rules, RandomGenome(SpaceOf(d).shape, d.senses, Variation{}, random)}};
  d.timeline = {{0, 0}};
  if (!Validate(d)) std::abort();

  const Motion motion = Simulate(d);
  if (motion.Hash() != Simulate(d).Hash()) std::abort();
  const std::vector<Genome> three(3, d.controllers[0].genes);
  for (const int lanes : {1, 4, 16}) {
    for (const Evaluation& evaluation : Evaluator(ProblemOf(d), lanes, true).Evaluate(three)) {
      if (evaluation.trajectory_hash != motion.Hash()) std::abort();
    }
  }
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);
  if (terms.broke_physics) return 0;
  const float scale = motion.Bones().longest_rod_m * static_cast<float>(rods) + 200.0f;
  for (int i = 0; i < motion.Frames(); ++i) {
    if (!std::isfinite(motion.At(i).x_m) || !std::isfinite(motion.At(i).y_m)) std::abort();
    for (int k = 0; k < motion.Bones().endpoints; ++k) {
      if (motion.At(i).y_m + motion.Endpoint(i, k).y < -1e-5f * scale) std::abort();
    }
  }
  return 0;
}
