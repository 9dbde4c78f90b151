// SPDX-License-Identifier: MIT
#include "core/rollout/decisions.h"

#include <algorithm>

#include "core/rollout/models.h"
#include "core/rollout/rollout.h"

namespace gaitsmith {

namespace {

/// What a bank reads.
std::vector<float> SensesOf(const Bank<1>& bank, const ControllerState<1>& state, const Readings<1>&,
                            const PortCount& ports) {
  std::vector<float> senses(static_cast<std::size_t>(SenseCount(bank.Senses().kind, ports)));
  for (std::size_t i = 0; i < senses.size(); ++i) senses[i] = state.senses[i][0];
  return senses;
}
/// What a network reads.
std::vector<float> SensesOf(const Network<1>&, const ControllerState<1>&, const Readings<1>& readings,
                            const PortCount& ports) {
  const auto touches = static_cast<std::size_t>(ports.contacts);
  std::vector<float> senses(touches + static_cast<std::size_t>(ports.actuators));
  for (std::size_t i = 0; i < senses.size(); ++i) {
    if (i < touches) {
      senses[i] = readings.impulse[i][0] > 0.0f ? 1.0f : 0.0f;
    } else {
      senses[i] = readings.position[i - touches][0];
    }
  }
  return senses;
}
std::vector<float> SensesOf(const JointCurves<1>&, const ControllerState<1>&, const Readings<1>&,
                            const PortCount&) {
  return {};
}

template <template <int> class PlantOf>
std::vector<Decision> Record(const Script& script, std::size_t clip) {
  const typename PlantOf<1>::Body body(script.figure);
  const Ports ports = PlantOf<1>::PortsOf(body);
  const auto takeovers = DecodeClips(script.clips, script.controllers, ports, script.step_s);
  const int start = takeovers[clip].step;
  const int end =
      clip + 1 < takeovers.size() ? std::min(takeovers[clip + 1].step, script.steps) : script.steps;
  std::vector<Decision> decisions;
  if (end <= start) return decisions;
  Rollout<PlantOf, 1> rollout(body, script.environment, script.start, script.pushes, takeovers,
                              script.step_s);
  const auto add = [&](bool sensed) {
    const ControllerState<1>& state = rollout.Control();
    Decision& decision = decisions.emplace_back();
    decision.step = rollout.StepNow();
    std::visit(
        [&](const auto& one) {
          decision.rule = ActivityOf(one, state).rule;
          decision.senses = SensesOf(one, state, rollout.PlantNow().Read(), ports.Count());
        },
        *rollout.InCharge());
    if (!sensed) std::ranges::fill(decision.senses, 0.0f);
    for (std::size_t j = 0; j < ports.actuator_range.size(); ++j) {
      decision.targets.push_back(rollout.Targets().target[j][0]);
      decision.inverse_tau.push_back(rollout.Targets().inverse_tau[j][0]);
      decision.decay.push_back(rollout.Targets().decay[j][0]);
    }
  };
  rollout.RunTo(start, kNothing, kNothing);
  rollout.TakeOver();
  add(false);
  rollout.RunTo(end, kNothing, [&] { add(true); });
  return decisions;
}

}  // namespace

std::vector<Decision> RecordDecisions(const Script& script, std::size_t clip) {
  return WithPlantOf(script.model,
                     [&]<template <int> class PlantOf>() { return Record<PlantOf>(script, clip); });
}

}  // namespace gaitsmith
