// SPDX-License-Identifier: MIT
#include "shell/python/figure_worlds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/control/sense_reader.h"
#include "core/numeric/scalar_math.h"
#include "core/rollout/models.h"

namespace gaitsmith::python {

namespace {

/// One figure. It cannot be copied, because its plant refers to a body that all of them share.
template <template <int> class PlantOf>
struct World {
  std::optional<PlantOf<1>> plant;
  int step = 0;               // simulation steps since the start
  std::size_t next_push = 0;  // of the problem's
  double primary = 0.0;       // of the task so far
  double turn_rate_radps = 0.0;
};

template <template <int> class PlantOf>
class WorldsOf final : public FigureWorlds {
 public:
  WorldsOf(const Problem& problem, std::size_t worlds, Observation observation, float tau_s)
      : problem_(problem),
        observation_(observation),
        body_(problem_.figure),
        ports_(PlantOf<1>::PortsOf(body_)),
        reader_(problem_.senses, ports_, kStep),
        worlds_(worlds) {
    // As a rule's response is decoded.
    const auto decay = static_cast<float>(Exp(-static_cast<double>(kStep) / static_cast<double>(tau_s)));
    for (std::size_t j = 0; j < ports_.actuator_range.size(); ++j) {
      targets_.decay[j] = Lane<1>::Splat(decay);
      targets_.inverse_tau[j] = Lane<1>::Splat(1.0f / tau_s);
    }
    for (std::size_t i = 0; i < worlds; ++i) Reset(i, 0.0f, 0.0f, 0.0f);
  }

  void Reset(std::size_t world, float velocity_x_mps, float velocity_y_mps, float spin_radps) override {
    StartState start = problem_.start;
    start.velocity_x_mps += velocity_x_mps;
    start.velocity_y_mps += velocity_y_mps;
    start.spin_radps += spin_radps;
    World<PlantOf>& one = worlds_[world];
    one.plant.emplace(body_, problem_.environment, start, kStep);
    one.step = 0;
    one.next_push = 0;
    one.primary = static_cast<double>(Primary(problem_.task, one.plant->TermsOf(0)));
    one.turn_rate_radps = static_cast<double>(start.spin_radps);
  }

  WorldStep Step(std::size_t world, std::span<const float> targets, int steps) override {
    World<PlantOf>& one = worlds_[world];
    for (std::size_t j = 0; j < targets.size(); ++j) {
      const auto [least, greatest] = ports_.actuator_range[j];
      targets_.target[j] = Lane<1>::Splat(std::clamp(targets[j], least, greatest));
    }
    WorldStep result;
    for (int i = 0; i < steps && !result.terminated && !result.truncated; ++i) {
      const auto& pushes = problem_.pushes;
      for (; one.next_push < pushes.size() && pushes[one.next_push].step <= one.step; ++one.next_push)
        one.plant->Give(pushes[one.next_push]);
      const double turn = one.plant->Observe(0).turn_rad;
      one.plant->Step(one.step, targets_);
      one.turn_rate_radps = (one.plant->Observe(0).turn_rad - turn) / static_cast<double>(kStep);
      ++one.step;
      result.terminated = one.plant->TermsOf(0).broke_physics;
      result.truncated = !result.terminated && one.step >= problem_.task.duration_steps;
    }
    // A void motion is worth nothing, so what it had gained is taken back.
    const double primary =
        result.terminated ? 0.0 : static_cast<double>(Primary(problem_.task, one.plant->TermsOf(0)));
    result.progress = primary - one.primary;
    one.primary = primary;
    return result;
  }

  void Observe(std::size_t world, std::span<float> observation) const override {
    const World<PlantOf>& one = worlds_[world];
    if (observation_ == Observation::kSenses) {
      Sense(one, observation);
    } else {
      Report(one, observation);
    }
    for (float& number : observation) {
      if (!std::isfinite(number)) number = 0.0f;
    }
  }

  [[nodiscard]] double TravelOf(std::size_t world) const override {
    return worlds_[world].plant->Observe(0).x_m;
  }
  [[nodiscard]] std::vector<std::array<float, 2>> JointLimits() const override {
    return ports_.actuator_range;
  }

  [[nodiscard]] std::vector<std::string> Names() const override {
    std::vector<std::string> names;
    if (observation_ == Observation::kSenses) {
      for (int sense = 0; sense < SenseCount(problem_.senses.kind, ports_.Count()); ++sense) {
        names.push_back(SenseName(problem_.senses.kind, ports_.Count(), sense));
        std::ranges::replace(names.back(), ' ', '_');
      }
      return names;
    }
    for (const char* part : {ports_.muscles ? "length_" : "theta_", "rate_"}) {
      for (int joint = 1; joint <= ports_.Count().actuators; ++joint)
        names.push_back(part + std::to_string(joint));
    }
    for (const char* name : {"turn_sine", "turn_cosine", "turn_rate", "y", "vx", "vy"})
      names.emplace_back(name);
    for (int node = 0; node < ports_.contacts; ++node) names.push_back("touch_" + std::to_string(node));
    return names;
  }

 private:
  void Sense(const World<PlantOf>& one, std::span<float> observation) const {
    if (problem_.senses.kind == SenseKind::kTimer) {
      const int period = problem_.senses.period_steps;
      observation[0] = TimerSense(one.step % period, period);
      return;
    }
    SenseVector<1> senses{};
    reader_.Read(one.plant->Read(), senses);
    for (std::size_t i = 0; i < observation.size(); ++i) observation[i] = senses[i][0];
  }

  void Report(const World<PlantOf>& one, std::span<float> observation) const {
    const Readings<1> readings = one.plant->Read();
    const Snapshot seen = one.plant->Observe(0);
    auto at = observation.begin();
    for (std::size_t j = 0; j < ports_.actuator_range.size(); ++j) *at++ = readings.position[j][0];
    for (std::size_t j = 0; j < ports_.actuator_range.size(); ++j) *at++ = readings.rate[j][0];
    Lane<1>::F sine, cosine;
    SinCosOfTurn<1>(Lane<1>::D{} + seen.turn_rad, sine, cosine);
    *at++ = sine[0];
    *at++ = cosine[0];
    *at++ = static_cast<float>(one.turn_rate_radps);
    *at++ = (*readings.height)[0];
    *at++ = seen.velocity_x_mps;
    *at++ = seen.velocity_y_mps;
    for (int k = 0; k < ports_.contacts; ++k) *at++ = readings.impulse[k][0] > 0.0f ? 1.0f : 0.0f;
  }

  Problem problem_;
  Observation observation_;
  typename PlantOf<1>::Body body_;
  Ports ports_;
  SenseReader<1> reader_;
  ActuatorTargets<1> targets_{};
  std::vector<World<PlantOf>> worlds_;
};

}  // namespace

std::unique_ptr<FigureWorlds> MakeFigureWorlds(const Problem& problem, std::size_t worlds,
                                               Observation observation, float tau_s) {
  return WithPlantOf(problem.model, [&]<template <int> class PlantOf>() -> std::unique_ptr<FigureWorlds> {
    return std::make_unique<WorldsOf<PlantOf>>(problem, worlds, observation, tau_s);
  });
}

}  // namespace gaitsmith::python
