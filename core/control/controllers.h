// SPDX-License-Identifier: MIT
// W controllers of one shape side by side, decoded and ready to run. All differences between the kinds of
// controllers at run time are here, one overload for each kind.
#pragma once

#include <bit>
#include <cstdint>
#include <variant>

#include "core/control/bank.h"
#include "core/control/controller.h"

namespace gaitsmith {

template <int W>
using Controllers = std::variant<Bank<W>, Network<W>, JointCurves<W>>;

/// The state of W controllers between steps, for every kind.
template <int W>
struct ControllerState {
  int steps = 0;               // since the controllers took over
  typename Lane<W>::I rule{};  // active rule of a bank
  SenseVector<W> senses{};     // of a bank
  NetworkState<W> network{};
};

/// @param ports of the plant that the controllers drive
/// @param genomes 1 to W of them, all of this shape; missing lanes repeat the last one
template <int W>
[[nodiscard]] Controllers<W> DecodeControllers(const ControllerShape& shape, const SenseSpec& senses,
                                               std::span<const std::span<const Gene>> genomes,
                                               const Ports& ports, float step_s) {
  if (shape.Kind() == ControllerKind::kNetwork) {
    return Network<W>(shape.Network(), senses, genomes, ports.actuator_range, step_s);
  }
  if (shape.Kind() == ControllerKind::kTrajectory) {
    return JointCurves<W>(shape.Curves(), senses, genomes, ports.actuator_range, step_s);
  }
  return Bank<W>(shape.Bank(), senses, genomes, ports, step_s);
}

/// Takes over: the first rule becomes active and the timer starts at zero.
template <int W>
void Begin(const Bank<W>& bank, ControllerState<W>& state, ActuatorTargets<W>& targets) {
  state.steps = 0;
  state.rule = typename Lane<W>::I{};
  for (int lane = 0; lane < W; ++lane) bank.Respond(0, lane, targets);
}
/// Takes over: all nodes start empty.
template <int W>
void Begin(const Network<W>& network, ControllerState<W>& state, ActuatorTargets<W>& targets) {
  state.steps = 0;
  state.rule = typename Lane<W>::I{};
  network.Begin(state.network, targets);
}
/// Takes over: the curves start at time zero.
template <int W>
void Begin(const JointCurves<W>& curves, ControllerState<W>& state, ActuatorTargets<W>& targets) {
  state.steps = 0;
  state.rule = typename Lane<W>::I{};
  curves.Follow(0, targets);
}

/// Updates the targets from the readings after a step. @param state its steps include this step
template <int W>
[[gnu::noinline]] void Advance(const Bank<W>& bank, const Readings<W>& readings, ControllerState<W>& state,
                               ActuatorTargets<W>& targets) {
  using L = Lane<W>;
  const typename L::I chosen = bank.Decide(readings, state.steps, state.rule, state.senses);
  const typename L::I changed = chosen != state.rule;
  if (!L::Any(changed)) return;
  state.rule = chosen;
  for (int lane = 0; lane < W; ++lane) {
    if (L::At(changed, lane)) bank.Respond(L::At(chosen, lane), lane, targets);
  }
}
template <int W>
void Advance(const Network<W>& network, const Readings<W>& readings, ControllerState<W>& state,
             ActuatorTargets<W>& targets) {
  const NetworkShape& shape = network.Shape();
  network.Advance({readings.position, static_cast<std::size_t>(shape.joints)},
                  {readings.impulse, static_cast<std::size_t>(shape.touches)}, state.network, targets);
}

template <int W>
void Advance(const JointCurves<W>& curves, const Readings<W>&, ControllerState<W>& state,
             ActuatorTargets<W>& targets) {
  curves.Follow(state.steps, targets);
}

/// The active parts of a controller, for display.
struct Activity {
  int rule;              // the active rule; the number of hidden nodes that fire; the nearest knot
  std::uint64_t firing;  // bit i: input i of the network is 1; 0 for other kinds
};
[[nodiscard]] inline Activity ActivityOf(const Bank<1>&, const ControllerState<1>& state) {
  return {state.rule[0], 0};
}
[[nodiscard]] inline Activity ActivityOf(const Network<1>& network, const ControllerState<1>& state) {
  static_assert(kMaxInputs <= 64);
  std::uint64_t firing = 0;
  for (std::size_t i = 0; i < kMaxInputs; ++i) firing |= std::uint64_t{state.network.input[i][0] > 0.0f} << i;
  // Hidden nodes are the last inputs.
  return {std::popcount(firing >> (network.Shape().touches + network.Shape().joints)), firing};
}
[[nodiscard]] inline Activity ActivityOf(const JointCurves<1>& curves, const ControllerState<1>& state) {
  return {curves.Times().NearestTo(state.steps), 0};
}

}  // namespace gaitsmith
