// SPDX-License-Identifier: MIT
#include "shell/algorithm_words.h"

namespace gaitsmith::shell {

const std::array<AlgorithmWords, kAlgorithmNames.size()>& AlgorithmTexts() {
  static const std::array<AlgorithmWords, kAlgorithmNames.size()> kTexts = {{
      {"RG&T", "RG&T: at random", "Draws controllers at random and keeps the best: the benchmark."},
      {"SPHC", "SPHC: hill climbing, reseeded",
       "Some climb side by side; now and then the better half replaces the worse. The paper's best."},
      {"GGA", "GGA: genetic, by generations",
       "Parents drawn by roulette wheel; their children replace the whole population."},
      {"SSGA", "SSGA: genetic, steady state",
       "Parents chosen by rank; two children at a time push out the two worst."},
      {"SHC", "SHC: hill climbing", "One controller, perturbed; the change stays if it is better."},
      {"MPGA", "MPGA: genetic, on a torus",
       "One controller on each cell of a torus, mating nearby: Ngo and Marks' parallel search."},
      {"Nelder–Mead", "Nelder–Mead: simplex",
       "Moves a simplex of controllers downhill. For refining what was found; poor from random."},
      {"Powell", "Powell: direction set",
       "Climbs along one gene after another. For refining what was found; poor from random."},
      {"CMA-ES", "CMA-ES: covariance adaptation",
       "Samples around a mean and learns which directions pay. Quick with a timer."},
      {"MAP-Elites", "MAP-Elites: a suite of styles",
       "Keeps the best for every height, slip and turn: many motions from one search."},
      {"Two-stage", "Two-stage: random, then climbing",
       "Draws many at random, then climbs from the best: how networks were first found."},
  }};
  return kTexts;
}

const AlgorithmWords& WordsOf(Algorithm algorithm) {
  return AlgorithmTexts()[static_cast<std::size_t>(algorithm)];
}

bool RefinesOne(Algorithm algorithm) {
  return algorithm == Algorithm::kShc || algorithm == Algorithm::kNelderMead ||
         algorithm == Algorithm::kPowell || algorithm == Algorithm::kCmaEs;
}

}  // namespace gaitsmith::shell
