// SPDX-License-Identifier: MIT
// Scores a batch of genomes side by side, with the plant of one model. Evaluator chooses the plant.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/rollout/beginning.h"
#include "core/rollout/measurement.h"

namespace gaitsmith {

class BatchEvaluator {
 public:
  virtual ~BatchEvaluator() = default;
  /// Maximum number of genomes in a batch.
  [[nodiscard]] virtual std::size_t Lanes() const = 0;
  /// @param genomes of the problem's shape, 1 to Lanes() of them @param results out: one for each genome
  /// @param watch   of as many genomes, from the first of the problem's beginnings; networks have no rules,
  /// so
  ///                nothing is recorded of them
  virtual void Evaluate(std::span<const std::span<const Gene>> genomes, std::span<Evaluation> results,
                        const Watch& watch) const = 0;
};

template <template <int> class PlantOf, int W>
class PlantEvaluator final : public BatchEvaluator {
 public:
  PlantEvaluator(const Problem& problem, bool with_hash)
      : problem_(problem),
        body_(problem.figure),
        ports_(PlantOf<W>::PortsOf(body_)),
        shape_(problem.ShapeFor(ports_.Count())),
        with_hash_(with_hash) {
    for (const Beginning& beginning : problem_.beginnings) {
      const std::span<const int> end(&beginning.steps, 1);
      moments_.push_back(MomentsDuring<PlantOf>(beginning, problem_, body_, end).front());
    }
  }

  [[nodiscard]] std::size_t Lanes() const override { return W; }

  void Evaluate(std::span<const std::span<const Gene>> genomes, std::span<Evaluation> results,
                const Watch& watch) const override {
    const Controllers<W> controllers = DecodeControllers<W>(shape_, problem_.senses, genomes, ports_, kStep);
    std::array<TrajectoryHash, W> hashes;
    const std::span<TrajectoryHash> hashed =
        with_hash_ ? std::span<TrajectoryHash>(hashes) : std::span<TrajectoryHash>();
    std::array<Evaluation, W> scored;
    const std::size_t begins = moments_.empty() ? 1 : moments_.size();
    for (std::size_t begin = 0; begin < begins; ++begin) {
      Rollout<PlantOf, W> rollout(body_, problem_.environment, problem_.start, problem_.pushes, {}, kStep,
                                  problem_.substeps);
      if (moments_.empty()) {
        rollout.Delay(problem_.delay_steps);
      } else {
        rollout.BeginAt(moments_[begin], problem_.delay_steps);
      }
      rollout.Follow(controllers);
      std::optional<SightingRecorder<W>> sees;
      if (watch.count > 0 && begin == 0 && shape_.Kind() == ControllerKind::kRules)
        sees.emplace(shape_.Bank(), problem_.senses.kind, rollout.StepNow(), problem_.task.duration_steps,
                     watch);
      Measure(rollout, body_, ports_, problem_.task, std::span(scored).first(results.size()), hashed,
              problem_.traits ? size_m_ : 0.0f, sees ? &*sees : nullptr,
              problem_.all_terms ? kAllFurtherTerms : FurtherTerms{});
      for (std::size_t i = 0; i < results.size(); ++i) {
        if (begins > 1) {
          AddToMean(results[i], scored[i], static_cast<int>(begin));
        } else {
          results[i] = scored[i];
        }
      }
    }
    if (!with_hash_) return;
    for (std::size_t i = 0; i < results.size(); ++i) results[i].trajectory_hash = hashes[i].Value();
  }

 private:
  Problem problem_;
  typename PlantOf<W>::Body body_;
  Ports ports_;
  ControllerShape shape_;
  std::vector<Moment<PlantOf, 1>> moments_;  // one for each of the problem's beginnings
  bool with_hash_;
  float size_m_ = SizeOf(problem_.figure);
};

/// For problems in which genomes have bodies. The lanes of a plant share one, so only genomes with the same
/// body are simulated side by side.
template <template <int> class PlantOf, int W>
class BodyEvaluator final : public BatchEvaluator {
 public:
  BodyEvaluator(const Problem& problem, bool with_hash)
      : problem_(problem), body_genes_(problem.Shape().BodyGenes()), with_hash_(with_hash) {}

  [[nodiscard]] std::size_t Lanes() const override { return W; }

  void Evaluate(std::span<const std::span<const Gene>> genomes, std::span<Evaluation> results,
                const Watch& watch) const override {
    std::vector<char> scored(genomes.size(), 0);
    for (std::size_t first = 0; first < genomes.size(); ++first) {
      if (scored[first] != 0) continue;
      std::vector<std::size_t> alike;
      std::vector<std::span<const Gene>> controllers;
      for (std::size_t i = first; i < genomes.size(); ++i) {
        if (!std::ranges::equal(genomes[i].last(body_genes_), genomes[first].last(body_genes_))) continue;
        scored[i] = 1;
        alike.push_back(i);
        controllers.push_back(genomes[i].first(genomes[i].size() - body_genes_));
      }
      std::vector<Evaluation> evaluations(alike.size());
      std::vector<std::vector<Sighting>> sightings(watch.count > 0 ? alike.size() : 0);
      PlantEvaluator<PlantOf, W>(problem_.WithBodyOf(genomes[first]), with_hash_)
          .Evaluate(controllers, evaluations, {watch.count, sightings});
      for (std::size_t i = 0; i < alike.size(); ++i) {
        results[alike[i]] = evaluations[i];
        if (watch.count > 0) watch.of_genomes[alike[i]] = std::move(sightings[i]);
      }
    }
  }

 private:
  Problem problem_;
  std::size_t body_genes_;
  bool with_hash_;
};

/// For problems with several worlds. It evaluates in each of them, one after another.
class WorldsEvaluator final : public BatchEvaluator {
 public:
  /// @param worlds of the same problem, its own first
  explicit WorldsEvaluator(std::vector<std::shared_ptr<const BatchEvaluator>> worlds)
      : worlds_(std::move(worlds)) {}

  [[nodiscard]] std::size_t Lanes() const override { return worlds_.front()->Lanes(); }

  void Evaluate(std::span<const std::span<const Gene>> genomes, std::span<Evaluation> results,
                const Watch& watch) const override {
    worlds_.front()->Evaluate(genomes, results, watch);
    std::vector<Evaluation> scored(genomes.size());
    for (std::size_t world = 1; world < worlds_.size(); ++world) {
      worlds_[world]->Evaluate(genomes, scored, {});
      for (std::size_t i = 0; i < genomes.size(); ++i)
        AddToMean(results[i], scored[i], static_cast<int>(world));
    }
  }

 private:
  std::vector<std::shared_ptr<const BatchEvaluator>> worlds_;
};

/// The evaluator that a problem needs.
template <template <int> class PlantOf, int W>
std::shared_ptr<const BatchEvaluator> BatchEvaluatorOf(const Problem& problem, bool with_hash) {
  if (!problem.worlds.empty()) {
    std::vector<std::shared_ptr<const BatchEvaluator>> worlds{
        BatchEvaluatorOf<PlantOf, W>(problem.In({}), with_hash)};
    for (const TrialWorld& world : problem.worlds)
      worlds.push_back(BatchEvaluatorOf<PlantOf, W>(problem.In(world), false));
    return std::make_shared<WorldsEvaluator>(std::move(worlds));
  }
  if (problem.bodies) return std::make_shared<BodyEvaluator<PlantOf, W>>(problem, with_hash);
  return std::make_shared<PlantEvaluator<PlantOf, W>>(problem, with_hash);
}

}  // namespace gaitsmith
