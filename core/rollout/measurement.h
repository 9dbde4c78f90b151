// SPDX-License-Identifier: MIT
// Scores controllers: runs a rollout for the task's duration and measures it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/rollout/evaluation.h"
#include "core/rollout/gait_meter.h"
#include "core/rollout/rollout.h"
#include "core/rollout/sighting_recorder.h"
#include "core/rollout/style_meter.h"

namespace gaitsmith {

/// Runs a rollout for the task's duration and scores its first lanes.
/// @param body, ports of the plant
/// @param results out: one for each of the first lanes, without hashes
/// @param hashes  one for each lane; each step is added to them. Empty: no hashes
/// @param size_m  of the figure, for traits; 0: no traits
/// @param sees    null: nothing is recorded
/// @param also    further terms to measure, besides those with a weight
template <template <int> class PlantOf, int W>
void Measure(Rollout<PlantOf, W>& rollout, const typename PlantOf<W>::Body& body, const Ports& ports,
             const Task& task, std::span<Evaluation> results, std::span<TrajectoryHash> hashes = {},
             float size_m = 0.0f, SightingRecorder<W>* sees = nullptr, const FurtherTerms& also = {}) {
  const PlantOf<W>& plant = rollout.PlantNow();
  // Most searches give the further terms no weight. Then they are not measured.
  const bool looks = size_m > 0.0f;
  FurtherTerms wanted = WeightedFurtherTerms(task);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = wanted[i] || also[i] || (looks && kFreeFurtherTerms[i]);
  }
  std::optional<StyleMeter<PlantOf<W>>> meter;
  if (wanted != FurtherTerms{}) meter.emplace(plant, body, ports, wanted, rollout.PlantStep());
  std::optional<GaitMeter<PlantOf<W>>> gait;
  if (looks) gait.emplace(plant, ports.Count(), size_m, rollout.PlantStep());
  std::vector<DemonstrationMeter> compared;
  if (task.shown != Demonstration{}) compared.assign(W, DemonstrationMeter(task.shown));
  if (sees != nullptr) sees->Add(rollout.Control(), rollout.StepNow());
  const auto measure = [&] {
    if (meter) meter->Add(rollout.Given());
    if (gait) gait->Add();
  };
  const auto conclude = [&] {
    measure();
    for (std::size_t lane = 0; lane < compared.size(); ++lane) {
      const auto at = static_cast<int>(lane);
      const Snapshot now = plant.Observe(at);
      compared[lane].Add(now.x_m, static_cast<double>(now.y_m), now.turn_rad,
                         [&](std::size_t joint) { return plant.Read().position[joint][at]; });
    }
    if (sees != nullptr) sees->Add(rollout.Control(), rollout.StepNow());
    for (std::size_t lane = 0; lane < hashes.size(); ++lane)
      plant.AddTo(hashes[lane], static_cast<int>(lane));
  };
  rollout.RunTo(rollout.StepNow() + task.duration_steps, kNothing, conclude, measure);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Evaluation result;
    result.terms = plant.TermsOf(static_cast<int>(i));
    if (meter) meter->Put(static_cast<int>(i), result.terms);
    if (!compared.empty()) compared[i].Put(result.terms);
    if (gait) result.traits = gait->TraitsOf(static_cast<int>(i), result.terms);
    result.fitness = Fitness(task, result.terms);
    results[i] = result;
  }
}

}  // namespace gaitsmith
