// SPDX-License-Identifier: MIT
// A fixed amount of simulation, for counting instructions. `instructions WORKLOAD TIMES` scores a batch of
// perturbations of the shipped gait ("gait"), or of random banks ("random", "timer"), TIMES times.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/bench/workload.h"

namespace {

using namespace gaitsmith;

constexpr int kSteps = 300;
constexpr std::size_t kFigures = 16;

/// A shipped gait, because a search under valgrind would take a minute.
bench::Workload ShippedGait() {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/examples/star-man-shuffle.json");
  Document document = DecodeJson(std::string(std::istreambuf_iterator<char>(file), {})).value();
  const Controller gait = document.controllers.at(0);
  document.senses = gait.senses;
  document.rules = gait.rules;
  bench::Workload workload{document, {}};
  for (std::uint64_t i = 0; i < kFigures; ++i) {
    RandomStream random(2, 0, i);
    workload.genomes.push_back(
        Perturb(gait.genes, SpaceOf(document).shape, gait.senses, document.search.variation, random));
  }
  return workload;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const std::string name = words[1];
  bench::Workload workload = name == "gait" ? ShippedGait() : bench::WorkloadOf(name);
  workload.document.task.duration_steps = kSteps;
  const Evaluator evaluator(ProblemOf(workload.document));
  const int times = std::atoi(words[2]);
  float sum = 0.0f;
  for (int i = 0; i < times; ++i) {
    for (const Evaluation& one : evaluator.Evaluate(std::span(workload.genomes).first(kFigures))) {
      sum += one.fitness;
    }
  }
  std::printf("%zu figure-steps, sum of fitness %g\n", kFigures * kSteps * static_cast<std::size_t>(times),
              static_cast<double>(sum));
  return 0;
}
