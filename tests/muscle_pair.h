// SPDX-License-Identifier: MIT
// A second plant for tests: two masses that slide on the ground, with a muscle between them. It has nothing
// in common with articulated figures except the concept of rollout/plant.h.
//
//   muscle    pulls and pushes both masses with the same force, so that its length approaches the target,
//             l'' = (target - l) / tau^2 - 2 l' / tau
//   ground    Coulomb friction on each mass, at most mu m g h in a step of h
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "core/rollout/plant.h"

namespace gaitsmith::test {

/// Made from a figure of one rod. The rod's length is the muscle's rest length. A third of its mass is at its
/// start, the rest at its end.
struct MuscleBody {
  explicit MuscleBody(const Figure& figure)
      : length_m(figure.rods[0].length_m),
        mass_kg{figure.rods[0].mass_kg / 3.0f, figure.rods[0].mass_kg * (2.0f / 3.0f)} {}

  [[nodiscard]] float Mass() const { return mass_kg[0] + mass_kg[1]; }

  float length_m;
  std::array<float, 2> mass_kg;
};

template <int W>
struct MuscleState {
  using F = typename Lane<W>::F;
  typename Lane<W>::D distance_m{};      // of the centre of mass, since the start
  F velocity_mps{};                      // of the centre of mass
  F length_m{}, rate_mps{}, change_m{};  // of the muscle; change is that of the last step
  std::array<F, 2> normal{}, tangent{};  // impulses of the ground in the last step [N s]
  F slip_m{};                            // path of both masses
  F pull_ns{};                           // impulse of the muscle in the last step, outwards
  F height{}, rise{};                    // always 0: masses never leave the ground
};

/// As in physics/muscles.h; the muscle's impulse is known.
template <int W>
struct KnownMuscle {
  struct Memory {};
  KnownMuscle(const MuscleBody& /*body*/, float /*step_s*/) {}
  [[nodiscard]] Memory Begin(const MuscleState<W>& /*state*/) const { return {}; }
  [[nodiscard]] std::array<typename Lane<W>::F, kMaxActuators> ImpulsesOf(const MuscleState<W>& s,
                                                                          std::span<const Push> /*pushes*/,
                                                                          Memory& /*memory*/) const {
    return {s.pull_ns};
  }
};

template <int W>
class MusclePair {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  static constexpr int kLanes = W;
  static constexpr int kModel = 1000;  // not a model of documents
  using Body = MuscleBody;
  using State = MuscleState<W>;
  using LaneState = MuscleState<1>;
  using Muscles = KnownMuscle<W>;

  MusclePair(const MuscleBody& body, const Environment& environment, const StartState& start, float step_s)
      : body_(body), environment_(environment), step_s_(step_s) {
    state_.length_m = L::Splat(body.length_m);
    state_.velocity_mps = L::Splat(start.velocity_x_mps);
  }

  static PortCount CountPorts(const Figure&) { return {1, 2}; }
  static Ports PortsOf(const MuscleBody& body) {
    return {.actuator_range = {{0.5f * body.length_m, 1.5f * body.length_m}},
            .contacts = 2,
            .mass_kg = body.Mass(),
            .length_m = body.length_m};
  }

  [[nodiscard]] const State& Save() const { return state_; }
  void Restore(const State& state) { state_ = state; }
  void BeginAt(const MuscleState<1>& one) {
    state_ = {};
    state_.velocity_mps = L::Splat(one.velocity_mps[0]);
    state_.length_m = L::Splat(one.length_m[0]);
    state_.rate_mps = L::Splat(one.rate_mps[0]);
    for (std::size_t i = 0; i < 2; ++i) state_.normal[i] = L::Splat(one.normal[i][0]);
  }

  /// Only along the ground, because masses never leave it.
  void Give(const Push& push) {
    state_.velocity_mps += L::Splat(push.impulse_x_ns / body_.Mass());
    if (push.endpoint == kCentreOfMass) return;
    const auto mass = static_cast<std::size_t>(push.endpoint);
    state_.rate_mps += L::Splat((mass == 0 ? -1.0f : 1.0f) * push.impulse_x_ns / body_.mass_kg[mass]);
  }

  void Step(int step, const ActuatorTargets<W>& targets) {
    State& s = state_;
    const SineCosine slope = SinCos(GroundAngle(environment_, static_cast<float>(step) * step_s_));
    const float share0 = body_.mass_kg[0] / body_.Mass(), share1 = body_.mass_kg[1] / body_.Mass();
    const F inverse_tau = targets.inverse_tau[0];
    const F pull = (targets.target[0] - s.length_m) * inverse_tau - 2.0f * s.rate_mps;
    s.rate_mps += pull * inverse_tau * step_s_;
    s.pull_ns = pull * inverse_tau * (step_s_ * share0 * body_.mass_kg[1]);
    s.velocity_mps -= environment_.gravity_mps2 * slope.sine * step_s_;
    const std::array<F, 2> slide = {s.velocity_mps - share1 * s.rate_mps,
                                    s.velocity_mps + share0 * s.rate_mps};
    for (std::size_t i = 0; i < 2; ++i) {
      const float normal = body_.mass_kg[i] * environment_.gravity_mps2 * slope.cosine * step_s_;
      s.normal[i] = L::Splat(normal);
      const F most = L::Splat(environment_.friction * normal);
      s.tangent[i] = L::Max(L::Min(-body_.mass_kg[i] * slide[i], most), -most);
      s.slip_m += L::Abs(slide[i] + s.tangent[i] / body_.mass_kg[i]) * step_s_;
    }
    s.velocity_mps += (s.tangent[0] + s.tangent[1]) / body_.Mass();
    s.rate_mps += s.tangent[1] / body_.mass_kg[1] - s.tangent[0] / body_.mass_kg[0];
    const F free_length = s.length_m + s.rate_mps * step_s_;
    const F held =
        L::Max(L::Min(free_length, L::Splat(1.5f * body_.length_m)), L::Splat(0.5f * body_.length_m));
    s.change_m = held - s.length_m;
    s.length_m = held;
    s.rate_mps = L::Select(held == free_length, s.rate_mps, F{});
    s.distance_m += L::ToDouble(s.velocity_mps * step_s_);
  }

  [[nodiscard]] Readings<W> Read() const {
    return {.position = &state_.length_m,
            .rate = &state_.rate_mps,
            .change = &state_.change_m,
            .impulse = state_.normal.data(),
            .height = &state_.height,
            .rise = &state_.rise};
  }
  [[nodiscard]] F Upright() const { return L::Splat(1.0f); }
  [[nodiscard]] F HeadHeight() const { return state_.height; }
  [[nodiscard]] Terms TermsOf(int lane) const {
    Terms terms;
    terms.travel_m = static_cast<float>(state_.distance_m[lane]);
    terms.slip_sum_m = state_.slip_m[lane];
    terms.broke_physics = !std::isfinite(state_.distance_m[lane]) || !std::isfinite(state_.length_m[lane]);
    return terms;
  }
  void AddTo(TrajectoryHash& hash, int lane) const {
    hash.Add(state_.distance_m[lane]);
    hash.Add(state_.length_m[lane]);
  }
  [[nodiscard]] Snapshot Observe(int lane) const {
    Snapshot seen{};
    seen.x_m = state_.distance_m[lane];
    seen.velocity_x_mps = state_.velocity_mps[lane];
    return seen;
  }
  [[nodiscard]] std::array<float, 2> ContactPoint(int contact, int lane) const {
    const float share = body_.mass_kg[contact == 0 ? 1 : 0] / body_.Mass();
    return {(contact == 0 ? -share : share) * state_.length_m[lane], 0.0f};
  }
  [[nodiscard]] std::array<float, 2> ContactForce(int contact, int lane) const {
    const auto i = static_cast<std::size_t>(contact);
    return {state_.tangent[i][lane] / step_s_, state_.normal[i][lane] / step_s_};
  }

 private:
  const MuscleBody& body_;
  Environment environment_;
  float step_s_;
  State state_;
};

}  // namespace gaitsmith::test
