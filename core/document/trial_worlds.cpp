// SPDX-License-Identifier: MIT
#include "core/document/trial_worlds.h"

#include "core/numeric/random.h"

namespace gaitsmith {

namespace {

// A stream that no search draws from: proposals are counted from 0.
constexpr std::uint64_t kWorldStream = 0x776f726c6473;

}  // namespace

std::vector<TrialWorld> DrawWorlds(std::uint32_t seed, int worlds, int parts, const WorldNoise& noise) {
  std::vector<TrialWorld> drawn;
  for (int i = 1; i < worlds; ++i) {
    RandomStream random(seed, static_cast<std::uint64_t>(i), kWorldStream);
    const auto about = [&](double middle, double most) {
      return static_cast<float>(middle + most * (2.0 * random.Uniform() - 1.0));
    };
    TrialWorld& world = drawn.emplace_back();
    world.friction = about(1.0, noise.friction);
    world.slope_rad = about(0.0, noise.slope_rad);
    world.delay_steps = static_cast<int>(random.Below(static_cast<std::uint32_t>(noise.delay_steps) + 1u));
    for (int part = 0; part < parts; ++part) world.masses.push_back(about(1.0, noise.mass));
    // In turn, the finest first: a few drawn numbers would often leave it out.
    world.substeps = 1 << (noise.halvings - (i - 1) % (noise.halvings + 1));
  }
  return drawn;
}

}  // namespace gaitsmith
