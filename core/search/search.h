// SPDX-License-Identifier: MIT
// Searches over genomes, as ask/tell: a search hands out genomes and is told their fitness, in the order it
// asked. So one evaluator serves them all, and a search can pause, resume, be cancelled and be tested without
// physics. What a finished search found depends on its settings alone: never on how many genomes are asked
// for at a time, nor on who evaluates them. (On the way, the best may come from ahead of the serial order, so
// a search that is stopped early can differ.)
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/control/stimulus_response.h"
#include "core/numeric/bit_stream.h"
#include "core/numeric/error.h"

namespace gaitsmith {

enum class Algorithm {
  kRandomSearch,  // RG&T: random generate and test
  kSphc,          // stochastic population hill climbing, Figure 5
};
/// Names on the command line and in documents.
inline constexpr std::array<std::string_view, 2> kAlgorithmNames = {"rgt", "sphc"};

struct SearchSettings {
  Algorithm algorithm = Algorithm::kSphc;
  std::uint32_t seed = 1;
  int evaluations = 40000;    // simulations allowed, [1, 100 million]; Table 2 of the paper: 40,000
  int population = 10;        // SPHC, [2, 1000]; Table 2: 10
  int reseed_interval = 200;  // SPHC: generations between reseedings, [1, 1 million]; Table 2: 200
  Variation variation;
};

/// The space a search works in.
struct SearchSpace {
  BankShape shape;
  SenseSpec senses;
};

class Search {
 public:
  virtual ~Search() = default;

  /// The next genomes to evaluate: about `wanted` of them, as many as can be named ahead without knowing
  /// their results; none once the budget is spent. Tell must follow before the next Ask.
  [[nodiscard]] virtual std::vector<Genome> Ask(int wanted) = 0;

  /// Fitness of the genomes of the last Ask, in its order. NaN loses to everything.
  virtual void Tell(std::span<const float> fitness) = 0;

  /// Evaluations the serial algorithm would have made by now.
  [[nodiscard]] virtual int Evaluations() const = 0;
  [[nodiscard]] virtual bool Done() const = 0;

  /// The best genome so far; empty before the first Tell.
  [[nodiscard]] virtual const Genome& BestGenome() const = 0;
  [[nodiscard]] virtual float BestFitness() const = 0;

  /// One point for every improvement of the best, in the order of the serial algorithm.
  struct CurvePoint {
    int evaluation;  // from 1
    float best;
  };
  [[nodiscard]] virtual const std::vector<CurvePoint>& Curve() const = 0;

  /// The whole state between a Tell and an Ask; Load of it continues as if nothing had happened.
  virtual void Save(BitWriter&) const = 0;
  [[nodiscard]] virtual Result<void> Load(BitReader&) = 0;
};

[[nodiscard]] std::unique_ptr<Search> MakeSearch(const SearchSettings&, const SearchSpace&);

}  // namespace gaitsmith
