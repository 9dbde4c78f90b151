// SPDX-License-Identifier: MIT
// How the cost of a motion grows with the number of rods, in both models, the number of rules, and the share
// of senses that a rule uses. cost_slopes.mjs fits the slopes. The time is that of kGenomes motions of 5 s.
// The label counts those that broke off.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "core/rollout/evaluator.h"
#include "tests/bench/workload.h"

namespace {

using namespace gaitsmith;

void Run(benchmark::State& state, const Document& document) {
  const bench::Workload workload = bench::RandomGenomes(document);
  const Evaluator evaluator(ProblemOf(document));
  for (auto _ : state) benchmark::DoNotOptimize(evaluator.Evaluate(workload.genomes));
  const auto is_void = [](const Evaluation& one) { return one.fitness <= kVoidScore; };
  state.SetLabel(std::to_string(std::ranges::count_if(evaluator.Evaluate(workload.genomes), is_void)) +
                 " broke off");
}

/// Rods of half a metre, so that chains of sixteen rods still reach the ground.
Rod ShortRod(int parent, RodEnd end, float rest_rad) {
  return {.length_m = 0.5f, .parent = parent, .parent_end = end, .rest_rad = rest_rad};
}

void Star(benchmark::State& state, int model) {
  Document document;
  document.model = model;
  const int rods = static_cast<int>(state.range(0));
  const float apart_rad = 6.2831853f / static_cast<float>(rods);
  document.figure.rods.push_back(ShortRod(kNoParent, RodEnd::kEnd, 1.5707963f));
  for (int i = 1; i < rods; ++i) {
    const float rest_rad = apart_rad * static_cast<float>(2 * i < rods ? i : i - rods);
    document.figure.rods.push_back(ShortRod(0, RodEnd::kStart, rest_rad));
  }
  Run(state, document);
}

void Chain(benchmark::State& state, int model) {
  Document document;
  document.model = model;
  const int rods = static_cast<int>(state.range(0));
  document.figure.rods.push_back(ShortRod(kNoParent, RodEnd::kEnd, 0.3f));
  for (int i = 1; i < rods; ++i) {
    document.figure.rods.push_back(ShortRod(i - 1, RodEnd::kEnd, i % 2 == 1 ? -0.6f : 0.6f));
  }
  Run(state, document);
}
BENCHMARK_CAPTURE(Star, strong, 1)->Arg(4)->Arg(6)->Arg(8)->Arg(11)->Arg(16);
BENCHMARK_CAPTURE(Chain, strong, 1)->Arg(4)->Arg(6)->Arg(8)->Arg(11)->Arg(16);
BENCHMARK_CAPTURE(Star, limited, 2)->Arg(2)->Arg(3)->Arg(5)->Arg(8)->Arg(10)->Arg(16);
BENCHMARK_CAPTURE(Chain, limited, 2)->Arg(2)->Arg(3)->Arg(5)->Arg(8)->Arg(10)->Arg(16);

void Rules(benchmark::State& state, SenseKind kind) {
  Document document = bench::StarMan(kind);
  document.rules = static_cast<int>(state.range(0));
  Run(state, document);
}
BENCHMARK_CAPTURE(Rules, physical, SenseKind::kPhysical)->Arg(5)->Arg(10)->Arg(20)->Arg(32);
BENCHMARK_CAPTURE(Rules, timer, SenseKind::kTimer)->Arg(5)->Arg(10)->Arg(20)->Arg(32);

void CaredSenses(benchmark::State& state) {
  Document document = bench::StarMan(SenseKind::kPhysical);
  document.search.variation.dont_care = 1.0f - 0.01f * static_cast<float>(state.range(0));
  Run(state, document);
}
BENCHMARK(CaredSenses)->ArgName("percent")->Arg(0)->Arg(20)->Arg(50)->Arg(100);

}  // namespace

BENCHMARK_MAIN();
