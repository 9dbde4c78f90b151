// SPDX-License-Identifier: MIT
// Evaluations per second of one core, by senses and lanes, and what threads add. items_per_second counts
// simulated motions of Mr. Star-Man: ten rules, 5 s, 500 steps.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>

#include "core/document/json.h"
#include "core/physics/evaluator.h"
#include "shell/parallel_search.h"

namespace {

using namespace gaitsmith;

Document StarMan(SenseKind kind) {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/examples/figures/mr-star-man.json");
  Document document;
  document.figure = DecodeFigureJson(std::string(std::istreambuf_iterator<char>(file), {})).value();
  document.senses.kind = kind;
  return document;
}

void Evaluate(benchmark::State& state) {
  const Document document = StarMan(state.range(0) == 0 ? SenseKind::kPhysical : SenseKind::kTimer);
  const Evaluator evaluator(ProblemOf(document), static_cast<int>(state.range(1)));
  std::vector<Genome> genomes;
  for (std::uint64_t i = 0; i < 32; ++i) {
    RandomStream random(1, 0, i);
    genomes.push_back(RandomGenome(SpaceOf(document).shape, document.senses, Variation{}, random));
  }
  for (auto _ : state) benchmark::DoNotOptimize(evaluator.Evaluate(genomes));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(genomes.size()));
}
BENCHMARK(Evaluate)->ArgNames({"timer", "lanes"})->ArgsProduct({{0, 1}, {1, 2, 4, 8, 16}});

void Search(benchmark::State& state) {
  Document document = StarMan(SenseKind::kPhysical);
  document.search.evaluations = 2000;
  for (auto _ : state) {
    shell::SearchControl control;
    benchmark::DoNotOptimize(shell::RunParallelSearch(
        ProblemOf(document), document.search, static_cast<int>(state.range(0)), control, [](const auto&) {}));
  }
  state.SetItemsProcessed(state.iterations() * document.search.evaluations);
}
BENCHMARK(Search)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
