// SPDX-License-Identifier: MIT
#include "shell/words/algorithm_words.h"

#include "shell/words/language.h"

namespace gaitsmith::shell {

const std::array<AlgorithmWords, kAlgorithmNames.size()>& AlgorithmTexts() {
  static const auto kTexts = std::to_array<AlgorithmWords>({
      {"RG&T", TrLater("RG&T: at random"),
       TrLater("Draws controllers at random and keeps the best: the benchmark.")},
      {"SPHC", TrLater("SPHC: hill climbing, reseeded"),
       TrLater("Several candidates improve in parallel. From time to time the best half replaces the rest. "
               "The best search in the paper.")},
      {"GGA", TrLater("GGA: genetic, by generations"),
       TrLater("Parents are drawn by roulette wheel. Their children replace the whole population.")},
      {"SSGA", TrLater("SSGA: genetic, steady state"),
       TrLater("Parents are chosen by rank. Two children at a time replace the two worst.")},
      {"SHC", TrLater("SHC: hill climbing"),
       TrLater("Changes one controller at random. A change stays if it is better.")},
      {"MPGA", TrLater("MPGA: genetic, on a torus"),
       TrLater("One controller on each cell of a torus, mating nearby: Ngo and Marks' parallel search.")},
      {"Nelder–Mead", TrLater("Nelder–Mead: simplex"),
       TrLater("Moves a simplex of controllers downhill. Refines a found motion. Poor from a random start.")},
      {"Powell", TrLater("Powell: direction set"),
       TrLater("Climbs along one gene after another. Refines a found motion. Poor from a random start.")},
      {"CMA-ES", TrLater("CMA-ES: covariance adaptation"),
       TrLater("Samples around a mean and learns which directions pay. Quick with a timer.")},
      {"MAP-Elites", TrLater("MAP-Elites: a suite of styles"),
       TrLater("Keeps the best for every height, slip and turn: many motions from one search.")},
      {TrLater("Two-stage"), TrLater("Two-stage: random, then climbing"),
       TrLater("Draws many at random, then climbs from the best: how networks were first found.")},
      {TrLater("Pose cycle"), TrLater("Pose cycle: race, then place rules"),
       TrLater("Races loops of poses, then adds rules where the figure really passes. Usually needs the "
               "fewest tries.")},
      {"DE", TrLater("DE: differential evolution"),
       TrLater("Moves each controller by the difference of two others, and keeps what is no worse.")},
      {"NSGA-II", TrLater("NSGA-II: score against cost"),
       TrLater("Finds the best motion for every price, from hardly any effort to the highest score.")},
      {"CMA-MAE", TrLater("CMA-MAE: styles by adaptation"),
       TrLater("As MAP-Elites, but several samplings learn which directions lead to new or better styles.")},
  });
  static_assert(std::tuple_size_v<decltype(kTexts)> == kAlgorithmNames.size(),
                "every algorithm needs its words");
  return kTexts;
}

const AlgorithmWords& WordsOf(Algorithm algorithm) {
  return AlgorithmTexts()[static_cast<std::size_t>(algorithm)];
}

std::string AlgorithmName(Algorithm algorithm) { return Tr(WordsOf(algorithm).name.c_str()); }

bool RefinesOne(Algorithm algorithm) { return kRefinesOne[static_cast<std::size_t>(algorithm)]; }

}  // namespace gaitsmith::shell
