// SPDX-License-Identifier: MIT
#include "shell/parallel_search.h"

#include <algorithm>
#include <thread>

namespace gaitsmith::shell {

int Cores() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

void RunSearch(Search& search, const Evaluator& evaluator, int threads,
               const std::function<bool(const Search&)>& go_on) {
  // Per thread and batch: enough to fill the lanes several times, few enough to look ahead little.
  constexpr int kGenomesPerThread = 80;
  std::vector<float> fitness;
  while (!search.Done()) {
    const std::vector<Genome> genomes = search.Ask(kGenomesPerThread * threads);
    fitness.assign(genomes.size(), 0.0f);
    const auto share =
        (genomes.size() + static_cast<std::size_t>(threads) - 1) / static_cast<std::size_t>(threads);
    const auto evaluate = [&](std::size_t first) {
      const std::size_t count = std::min(share, genomes.size() - first);
      const auto results = evaluator.Evaluate(std::span(genomes).subspan(first, count));
      for (std::size_t i = 0; i < count; ++i) fitness[first + i] = results[i].fitness;
    };
    {
      std::vector<std::jthread> helpers;
      for (std::size_t first = share; first < genomes.size(); first += share)
        helpers.emplace_back(evaluate, first);
      evaluate(0);
    }
    search.Tell(fitness);
    if (!go_on(search)) return;
  }
}

}  // namespace gaitsmith::shell
