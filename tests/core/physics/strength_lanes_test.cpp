// SPDX-License-Identifier: MIT
// Model 2 gives every lane the same bits, whatever the others do, and after every interruption.
#include <array>
#include <bit>
#include <catch_amalgamated.hpp>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "core/numeric/random.h"
#include "core/physics/strength_plant.h"
#include "core/rollout/plant.h"
#include "tests/limb_scene.h"

namespace gaitsmith::test {

static_assert(Plant<StrengthPlant<1>> && Plant<StrengthPlant<8>>);

namespace {

constexpr int kLaneSteps = 250;

/// What the joints of one motion are asked for at a step: poses that change every 0.25 s.
template <int W>
void AskLane(int motion, int step, int joints, int lane, ActuatorTargets<W>& targets) {
  RandomStream random(static_cast<std::uint64_t>(motion), 84, static_cast<std::uint64_t>(step / 25));
  const float tau_s = motion % 2 == 0 ? 0.06f : 0.25f;
  for (std::size_t j = 0; j < static_cast<std::size_t>(joints); ++j) {
    Lane<W>::Put(targets.target[j], lane, static_cast<float>(4.0 * random.Uniform() - 2.0));
    Lane<W>::Put(targets.decay[j], lane, static_cast<float>(Exp(-static_cast<double>(kStep / tau_s))));
    Lane<W>::Put(targets.inverse_tau[j], lane, 1.0f / tau_s);
  }
}

using Bits = std::vector<std::uint64_t>;

/// Everything that carries over, of one lane.
template <int W>
Bits BitsOf(const Mechanism& body, const LimbState<W>& s, int lane) {
  Bits bits = {std::bit_cast<std::uint64_t>(s.distance_m[lane]),
               std::bit_cast<std::uint64_t>(s.turn_rad[lane]), std::bit_cast<std::uint64_t>(s.place_m[lane])};
  const auto add = [&](const auto& numbers, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      bits.push_back(std::bit_cast<std::uint32_t>(Lane<W>::At(numbers[i], lane)));
  };
  add(std::array{s.height_m, s.velocity_x, s.velocity_y, s.angular_momentum}, 4);
  for (const auto* of_joints : {&s.angle_rad, &s.rate_radps}) add(*of_joints, body.joints);
  for (const auto* of_rods : {&s.momentum, &s.torque_side, &s.stop_side, &s.root_answer}) {
    // The root's are not used.
    add(std::span(*of_rods).subspan(1), body.joints);
  }
  for (const auto* of_rods : {&s.speed, &s.cosine, &s.sine}) add(*of_rods, body.rods);
  for (const auto* of_endpoints : {&s.endpoint_x, &s.endpoint_y, &s.last_force.normal, &s.last_force.tangent})
    add(*of_endpoints, body.endpoints);
  return bits;
}

/// Level, or rough under where the figures fall.
Environment WorldOf(bool drawn) {
  if (!drawn) return {};
  return {.ground = {{-3.0f, 0.0f},
                     {-1.0f, 0.2f},
                     {-0.8f, 0.2f},
                     {-0.8f, 0.0f},
                     {-0.1f, 0.1f},
                     {0.0f, -0.1f},
                     {0.4f, 0.3f},
                     {0.5f, 0.0f},
                     {1.0f, 0.05f},
                     {1.0f, 0.4f},
                     {3.0f, 0.0f}}};
}

/// The bits of the motions first, first + 1, ... side by side, after each step.
template <int W>
std::array<std::vector<Bits>, W> SideBySide(const Mechanism& body, const Environment& world, int first) {
  std::array<std::vector<Bits>, W> bits;
  StrengthPlant<W> plant(body, world, {.drop_height_m = 0.2f, .spin_radps = 0.7f}, kStep);
  plant.Give({.step = 0, .endpoint = 1, .impulse_x_ns = 0.3f, .impulse_y_ns = 0.2f});
  for (int step = 0; step < kLaneSteps; ++step) {
    ActuatorTargets<W> targets{};
    for (int lane = 0; lane < W; ++lane) AskLane<W>(first + lane, step, body.joints, lane, targets);
    plant.Step(step, targets);
    for (int lane = 0; lane < W; ++lane)
      bits[static_cast<std::size_t>(lane)].push_back(BitsOf<W>(body, plant.Save(), lane));
  }
  return bits;
}

}  // namespace

TEST_CASE("strength: a lane's bits do not depend on the number of lanes", "[physics][strength]") {
  const float strength = GENERATE(0.0f, 0.2f, 2.0f, 1000.0f);
  const int rods = GENERATE(1, 4, 9);
  const bool drawn = GENERATE(false, true);
  CAPTURE(strength, rods, drawn);
  const Environment world = WorldOf(drawn);
  const Mechanism body(RandomTree(11, rods, strength));
  const auto eight = SideBySide<8>(body, world, 0);
  for (int half = 0; half < 2; ++half) {
    const auto four = SideBySide<4>(body, world, 4 * half);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const bool same = four[lane] == eight[static_cast<std::size_t>(4 * half) + lane];
      REQUIRE(same);
    }
  }
  for (int motion = 0; motion < 8; ++motion) {
    const auto one = SideBySide<1>(body, world, motion);
    const bool same = one[0] == eight[static_cast<std::size_t>(motion)];
    REQUIRE(same);
  }
  if (rods > 1) REQUIRE(eight[0].back() != eight[1].back());
}

TEST_CASE("strength: a motion restored at any moment continues bit by bit", "[physics][strength]") {
  const float strength = GENERATE(0.0f, 0.2f, 2.0f, 1000.0f);
  const bool drawn = GENERATE(false, true);
  const Environment world = WorldOf(drawn);
  const Mechanism body(RandomTree(12, 7, strength));
  const StartState start = {.drop_height_m = 0.2f, .spin_radps = 0.7f};
  StrengthPlant<1> plant(body, world, start, kStep);
  std::vector<LimbState<1>> moments = {plant.Save()};
  const auto step_on = [&](auto& any, int step) {
    constexpr int kLanes = std::remove_reference_t<decltype(any)>::kLanes;
    ActuatorTargets<kLanes> targets{};
    for (int lane = 0; lane < kLanes; ++lane) AskLane<kLanes>(3, step, body.joints, lane, targets);
    any.Step(step, targets);
  };
  for (int step = 0; step < kLaneSteps; ++step) {
    step_on(plant, step);
    moments.push_back(plant.Save());
  }
  const auto last = BitsOf<1>(body, moments.back(), 0);
  for (int moment = 0; moment <= kLaneSteps; moment += 7) {
    CAPTURE(strength, moment, drawn);
    StrengthPlant<1> again(body, world, StartState{}, kStep);
    again.Restore(moments[static_cast<std::size_t>(moment)]);
    StrengthPlant<4> spread(body, world, StartState{}, kStep);
    spread.BeginAt(moments[static_cast<std::size_t>(moment)]);
    for (int step = moment; step < kLaneSteps; ++step) {
      step_on(again, step);
      step_on(spread, step);
    }
    REQUIRE(BitsOf<1>(body, again.Save(), 0) == last);
    // The way is measured from where the lanes began.
    for (int lane = 0; lane < 4; ++lane) {
      auto bits = BitsOf<4>(body, spread.Save(), lane);
      bits[0] = last[0];
      REQUIRE(bits == last);
    }
  }
}

}  // namespace gaitsmith::test
