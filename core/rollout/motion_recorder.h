// SPDX-License-Identifier: MIT
// Simulates and records a motion, with the plant of one model. Motion chooses the plant.
#pragma once

#include <vector>

#include "core/rollout/motion.h"
#include "core/rollout/rollout.h"
#include "core/rollout/style_meter.h"

namespace gaitsmith {

class MotionRecorder {
 public:
  virtual ~MotionRecorder() = default;
  /// The version of the model. A checkpoint can only be resumed by a recorder of the same model.
  [[nodiscard]] virtual int Model() const = 0;
  /// Removes all checkpoints after a step. @return number of frames before the last remaining checkpoint
  [[nodiscard]] virtual int Rewind(int step) = 0;
  /// Simulates from the last checkpoint, or from the start. @param log recorded up to that checkpoint
  virtual void Record(const Script&, Motion::Log& log) = 0;
};

template <template <int> class PlantOf>
class PlantRecorder final : public MotionRecorder {
 public:
  [[nodiscard]] int Model() const override { return PlantOf<1>::kModel; }

  [[nodiscard]] int Rewind(int step) override {
    while (!checkpoints_.empty() && checkpoints_.back().moment.step > step) checkpoints_.pop_back();
    return checkpoints_.empty() ? 0 : checkpoints_.back().moment.step + 1;
  }

  void Record(const Script& script, Motion::Log& log) override {
    const typename PlantOf<1>::Body body(script.figure);
    const Ports ports = PlantOf<1>::PortsOf(body);
    log.ports = ports.Count();
    log.senses = SenseCount(SenseKind::kSight, log.ports);
    const auto takeovers = DecodeClips(script.clips, script.controllers, ports, script.step_s);
    Rollout<PlantOf, 1> rollout(body, script.environment, script.start, script.pushes, takeovers,
                                script.step_s);
    StyleMeter<PlantOf<1>> meter(rollout.PlantNow(), body, ports, kAllFurtherTerms, script.step_s);
    TrajectoryHash hash;
    if (checkpoints_.empty()) {
      rollout.TakeOver();
      AddFrame(rollout, meter, log);
    } else {
      const Checkpoint& last = checkpoints_.back();
      rollout.Restore(last.moment);
      meter.Restore(last.sums);
      hash = last.hash;
      checkpoints_.pop_back();
    }
    rollout.RunTo(
        script.steps,
        [&] {
          if (rollout.StepNow() % kCheckpointSteps == 0 && rollout.StepNow() > 0)
            checkpoints_.push_back({rollout.Save(), meter.Save(), hash});
        },
        [&] {
          meter.Add(rollout.Given());
          rollout.PlantNow().AddTo(hash, 0);
          AddFrame(rollout, meter, log);
        });
    log.hash = hash.Value();
  }

 private:
  static constexpr int kCheckpointSteps = 100;  // one per second

  /// A state to resume from.
  struct Checkpoint {
    Moment<PlantOf, 1> moment;  // before a clip that starts at this step takes over
    typename StyleMeter<PlantOf<1>>::Sums sums;
    TrajectoryHash hash;
  };

  static void AddFrame(const Rollout<PlantOf, 1>& rollout, const StyleMeter<PlantOf<1>>& meter,
                       Motion::Log& log) {
    const PlantOf<1>& plant = rollout.PlantNow();
    const Activity activity =
        rollout.InCharge() == nullptr
            ? Activity{}
            : std::visit([&](const auto& one) { return ActivityOf(one, rollout.Control()); },
                         *rollout.InCharge());
    log.frames.push_back({plant.Observe(0), rollout.Clip(), activity.rule, activity.firing});
    meter.Put(0, log.terms.emplace_back(plant.TermsOf(0)));
    for (int k = 0; k < log.ports.contacts; ++k) {
      const auto [x, y] = plant.ContactPoint(k, 0);
      log.endpoints.push_back({x, y});
      const auto [along, away] = plant.ContactForce(k, 0);
      log.forces.push_back({along, away});
    }
    const Readings<1> readings = plant.Read();
    for (int j = 0; j < log.ports.actuators; ++j) {
      log.angles.push_back(readings.position[j][0]);
      log.rates.push_back(readings.rate[j][0]);
      if constexpr (requires { plant.Strain(j, 0); }) log.strains.push_back(plant.Strain(j, 0));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(log.senses); ++i)
      log.felt.push_back(rollout.Control().senses[i][0]);
  }

  std::vector<Checkpoint> checkpoints_;
};

}  // namespace gaitsmith
