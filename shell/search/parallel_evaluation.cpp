// SPDX-License-Identifier: MIT
#include "shell/search/parallel_evaluation.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace gaitsmith::shell {

std::vector<Evaluation> EvaluateInParallel(const Evaluator& evaluator,
                                           std::span<const std::span<const Gene>> genomes, int threads,
                                           const std::function<bool()>& stop) {
  // Genomes that are simulated side by side.
  constexpr std::size_t kTogether = Evaluator::kDefaultLanes;
  std::vector<Evaluation> results(genomes.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = false;
  const auto take_pieces = [&](auto after_each) {
    for (std::size_t at = next.fetch_add(kTogether); at < genomes.size() && !stopped;
         at = next.fetch_add(kTogether)) {
      const std::size_t count = std::min(kTogether, genomes.size() - at);
      std::ranges::copy(evaluator.Evaluate(genomes.subspan(at, count)),
                        results.begin() + static_cast<std::ptrdiff_t>(at));
      after_each();
    }
  };
  {
    const std::size_t pieces = (genomes.size() + kTogether - 1) / kTogether;
    const std::size_t crew = std::min(static_cast<std::size_t>(threads), pieces);
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < crew; ++i) helpers.emplace_back([&] { take_pieces([] {}); });
    take_pieces([&] {
      if (stop()) stopped = true;
    });
  }
  return results;
}

}  // namespace gaitsmith::shell
