// SPDX-License-Identifier: MIT
// Evaluations per second of one core, by senses, genomes and lanes, and the gain by threads. items_per_second
// counts simulated motions of Mr. Star-Man: ten rules, 5 s, 500 steps.
#include <benchmark/benchmark.h>

#include "core/rollout/evaluator.h"
#include "shell/search/parallel_search.h"
#include "tests/bench/workload.h"

namespace {

using namespace gaitsmith;

void Evaluate(benchmark::State& state, const char* name) {
  const bench::Workload& workload = bench::WorkloadOf(name);
  const Evaluator evaluator(ProblemOf(workload.document), static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(evaluator.Evaluate(workload.genomes));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(workload.genomes.size()));
}
void Lanes(benchmark::internal::Benchmark* all) {
  all->ArgName("lanes");
  for (const int lanes : Evaluator::kLaneCounts) all->Arg(lanes);
}
BENCHMARK_CAPTURE(Evaluate, physical / random, "random")->Apply(Lanes);
BENCHMARK_CAPTURE(Evaluate, physical / gait, "gait")->Apply(Lanes);
BENCHMARK_CAPTURE(Evaluate, timer / random, "timer")->Apply(Lanes);
BENCHMARK_CAPTURE(Evaluate, timer / gait, "timer-gait")->Apply(Lanes);

void Search(benchmark::State& state) {
  Document document = bench::StarMan(SenseKind::kPhysical);
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
