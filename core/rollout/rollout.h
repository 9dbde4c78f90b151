// SPDX-License-Identifier: MIT
// The only simulation loop: W plants, each driven by its own controller, step by step. The evaluator,
// motions, beginnings and transition maps all use it.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/control/controllers.h"
#include "core/rollout/plant.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

/// Decoded controllers that take over at a step. The whole state of the plant carries over.
template <int W>
struct Takeover {
  int step;
  Controllers<W> controllers;
};

/// A saved moment of a rollout. Restoring it continues the rollout as if it had not been interrupted.
template <template <int> class PlantOf, int W>
struct Moment {
  typename PlantOf<W>::State plant;
  ControllerState<W> control;
  ActuatorTargets<W> targets;
  int step = 0;                // since the start
  std::size_t taken_over = 0;  // takeovers so far
};

/// A callback for RunTo that does nothing.
inline constexpr auto kNothing = [] {};

template <template <int> class PlantOf, int W>
  requires Plant<PlantOf<W>>
class Rollout {
  using L = Lane<W>;

 public:
  using P = PlantOf<W>;

  /// @param body, pushes, takeovers must outlive the rollout. Pushes and takeovers are sorted by step. Until
  /// the first takeover the plant holds its drawn pose
  /// @param substeps of the plant in each step of the controllers, a power of two: physics with a finer step,
  /// and the same decisions at the same times
  Rollout(const typename P::Body& body, const Environment& environment, const StartState& start,
          std::span<const Push> pushes, std::span<const Takeover<W>> takeovers = {}, float step_s = kStep,
          int substeps = 1)
      : plant_step_s_(step_s / static_cast<float>(substeps)),
        plant_(body, environment, start, plant_step_s_),
        pushes_(pushes),
        takeovers_(takeovers),
        substeps_(substeps),
        contacts_(substeps > 1 ? static_cast<std::size_t>(P::PortsOf(body).contacts) : 0) {}

  /// Lets controllers take over now: their first rules become active, their timers start at zero, their
  /// networks are empty. The motion continues from its present state.
  /// @param controllers must outlive their use
  void Follow(const Controllers<W>& controllers) {
    controllers_ = &controllers;
    std::visit([&](const auto& one) { Begin(one, control_, targets_); }, controllers);
  }

  /// From the start on joints follow decisions this many steps late. Saved moments do not contain what waits.
  /// @param steps [0, kMostDelaySteps]
  void Delay(int steps) { waiting_.assign(static_cast<std::size_t>(steps), {}); }

  [[nodiscard]] Moment<PlantOf, W> Save() const {
    return {plant_.Save(), control_, targets_, step_, taken_over_};
  }
  /// @param moment of a rollout with the same body, environment and start, and the same pushes and takeovers
  /// before it
  void Restore(const Moment<PlantOf, W>& moment) {
    plant_.Restore(moment.plant);
    control_ = moment.control;
    targets_ = moment.targets;
    step_ = moment.step;
    taken_over_ = moment.taken_over;
    controllers_ = taken_over_ == 0 ? nullptr : &takeovers_[taken_over_ - 1].controllers;
    SkipPushes();
  }
  /// Starts every lane from one plant's state at a moment, without its controller. The plant need not be at
  /// rest. Measurements start from there.
  /// @param delay_steps as for Delay: until then joints follow what the moment's controller decided last
  void BeginAt(const Moment<PlantOf, 1>& moment, int delay_steps = 0) {
    plant_.BeginAt(moment.plant);
    ActuatorTargets<W> before{};
    for (std::size_t i = 0; i < kMaxActuators; ++i) {
      before.target[i] = Lane<W>::Splat(moment.targets.target[i][0]);
      before.decay[i] = Lane<W>::Splat(moment.targets.decay[i][0]);
      before.inverse_tau[i] = Lane<W>::Splat(moment.targets.inverse_tau[i][0]);
    }
    waiting_.assign(static_cast<std::size_t>(delay_steps), before);
    control_ = {};
    targets_ = {};
    step_ = moment.step;
    controllers_ = nullptr;
    SkipPushes();
  }

  /// Applies all takeovers up to the present step.
  void TakeOver() {
    while (taken_over_ < takeovers_.size() && takeovers_[taken_over_].step <= step_) {
      Follow(takeovers_[taken_over_].controllers);
      ++taken_over_;
    }
  }

  /// Advances every lane by one step.
  /// @param between is called after each substep but the last
  template <class Between>
  void Step(Between between) {
    first_given_ = next_push_;
    for (; next_push_ < pushes_.size() && pushes_[next_push_].step <= step_; ++next_push_) {
      plant_.Give(pushes_[next_push_]);
    }
    if (substeps_ > 1) {
      StepFinely(waiting_.empty() ? targets_ : Waited(), between);
    } else if (waiting_.empty()) {
      plant_.Step(step_, targets_);
    } else {
      plant_.Step(step_, Waited());
    }
    ++step_;
    ++control_.steps;
    if (controllers_ == nullptr) return;
    std::visit([&](const auto& one) { Advance(one, Felt(), control_, targets_); }, *controllers_);
  }
  void Step() { Step(kNothing); }

  /// Simulates until a step.
  /// @param before is called before each step, before any controller takes over at it
  /// @param after  is called after each step
  /// @param between is called after each substep but the last of a step
  template <class Before, class After, class Between>
  void RunTo(int end, Before before, After after, Between between) {
    while (step_ < end) {
      before();
      TakeOver();
      Step(between);
      after();
    }
  }
  template <class Before, class After>
  void RunTo(int end, Before before, After after) {
    RunTo(end, before, after, kNothing);
  }

  /// The pushes that were applied right before the last step or substep.
  [[nodiscard]] std::span<const Push> Given() const {
    return pushes_.subspan(first_given_, next_push_ - first_given_);
  }
  [[nodiscard]] const P& PlantNow() const { return plant_; }
  /// What controllers read: the plant, with the ground's impulses of the whole step.
  [[nodiscard]] Readings<W> Felt() const {
    Readings<W> readings = plant_.Read();
    if (substeps_ > 1) readings.impulse = impulse_.data();
    return readings;
  }
  [[nodiscard]] int StepNow() const { return step_; }
  /// Of the plant [s].
  [[nodiscard]] float PlantStep() const { return plant_step_s_; }
  [[nodiscard]] const ControllerState<W>& Control() const { return control_; }
  /// What the joints follow in the next step.
  [[nodiscard]] const ActuatorTargets<W>& Targets() const { return targets_; }
  /// The active controllers, or null if there are none.
  [[nodiscard]] const Controllers<W>* InCharge() const { return controllers_; }
  /// Index of the active takeover, or -1 before the first one.
  [[nodiscard]] int Clip() const { return static_cast<int>(taken_over_) - 1; }

 private:
  /// One step in several. Ground impulses are those of the whole step: controllers feel the same as ever.
  template <class Between>
  [[gnu::noinline]] void StepFinely(ActuatorTargets<W> targets, Between between) {
    for (int parts = substeps_; parts > 1; parts /= 2) {
      for (auto& decay : targets.decay) {
        for (int lane = 0; lane < W; ++lane) L::Put(decay, lane, std::sqrt(L::At(decay, lane)));
      }
    }
    impulse_ = {};
    for (int part = 0; part < substeps_; ++part) {
      plant_.Step(step_ * substeps_ + part, targets);
      const Readings<W> readings = plant_.Read();
      for (std::size_t i = 0; i < contacts_; ++i) impulse_[i] += readings.impulse[i];
      if (part + 1 == substeps_) break;
      between();
      first_given_ = next_push_;
    }
  }
  /// What was decided before the delay, in place of which the present decision waits.
  ActuatorTargets<W> Waited() {
    return std::exchange(waiting_[static_cast<std::size_t>(step_) % waiting_.size()], targets_);
  }
  /// Skips the pushes that were applied before the present step.
  void SkipPushes() {
    next_push_ = 0;
    while (next_push_ < pushes_.size() && pushes_[next_push_].step < step_) ++next_push_;
    first_given_ = next_push_;
  }

  float plant_step_s_;
  P plant_;
  std::span<const Push> pushes_;
  std::span<const Takeover<W>> takeovers_;
  const Controllers<W>* controllers_ = nullptr;
  ControllerState<W> control_;
  ActuatorTargets<W> targets_{};
  std::vector<ActuatorTargets<W>> waiting_;  // decisions that joints do not follow yet
  int substeps_;
  std::size_t contacts_;                               // of the plant, if its steps are split
  std::array<typename L::F, kMaxContacts> impulse_{};  // of the ground in all substeps of the last step
  int step_ = 0;
  std::size_t next_push_ = 0, first_given_ = 0;
  std::size_t taken_over_ = 0;
};

/// Decodes the controller of each clip. @param controllers the clips index into them
[[nodiscard]] std::vector<Takeover<1>> DecodeClips(std::span<const Clip> clips,
                                                   std::span<const Controller> controllers,
                                                   const Ports& ports, float step_s);

}  // namespace gaitsmith
