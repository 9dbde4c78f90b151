// SPDX-License-Identifier: MIT
// Runs short rounds of simulation on demand, so that rival_bench.mjs can measure alternatives in turn within
// one run. Reads one command per line and answers each with one line:
//   about                     the compiler and its flags, as JSON
//   write FOLDER              writes every workload for programs in other languages: NAME.json and NAME.genes
//   box2d WORKLOAD MS         rollouts per second of processor time of Box2D, in about MS; a scenario of the
//   peers WORKLOAD LANES MS         motions per second of processor time of the evaluator, in about MS, one
//   thread
#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/bench/workload.h"
#ifdef GAITSMITH_BOX2D
#include "tests/bench/box2d_rival.h"
#endif

namespace {

using namespace gaitsmith;

/// Processor time of this program [s], which excludes other programs on a busy machine.
double Spent() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Repeats work until the time is up. @param work returns the number of simulated motions
template <class Work>
double PerSecond(double ms, Work work) {
  const double start = Spent();
  int done = 0;
  double spent = 0.0;
  do {
    done += work();
    spent = Spent() - start;
  } while (spent * 1000.0 < ms);
  return done / spent;
}

double EvaluatorRate(const std::string& name, int lanes, double ms) {
  const bench::Workload& workload = bench::WorkloadOf(name);
  const Evaluator evaluator(ProblemOf(workload.document), lanes);
  const std::span<const Genome> all(workload.genomes);
  std::size_t at = 0;
  volatile float sink = 0.0f;
  return PerSecond(ms, [&] {
    for (const Evaluation& one : evaluator.Evaluate(all.subspan(at, 16))) sink = sink + one.fitness;
    at = (at + 16) % all.size();
    return 16;
  });
}

double Box2dRate([[maybe_unused]] const std::string& name, [[maybe_unused]] double ms) {
#ifdef GAITSMITH_BOX2D
  const bench::Workload& peers = bench::WorkloadOf(name);
  int figure = 0;
  volatile float sink = 0.0f;
  return PerSecond(ms, [&] {
    sink = sink + bench::RunInBox2d(peers, figure);
    figure = (figure + 1) % bench::kGenomes;
    return 1;
  });
#else
  return 0.0;
#endif
}

void Write(const std::string& folder) {
  for (const std::string_view name : bench::kWorkloads) {
    const bench::Workload& workload = bench::WorkloadOf(name);
    const std::string path = folder + "/" + std::string(name);
    std::ofstream(path + ".json") << EncodeJson(workload.document);
    std::ofstream genes(path + ".genes", std::ios::binary);
    for (const Genome& genome : workload.genomes) {
      genes.write(reinterpret_cast<const char*>(genome.data()),
                  static_cast<std::streamsize>(genome.size() * sizeof(Gene)));
    }
  }
}

}  // namespace

int main() {
  std::cout << std::unitbuf;  // the caller waits for each line
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string command, folder, scenario;
    int lanes = 0;
    double ms = 0.0;
    words >> command;
    if (command == "about") {
      std::cout << R"({"compiler":")" GAITSMITH_COMPILER R"(","flags":")" GAITSMITH_FLAGS R"(","lanes":)"
                << Evaluator::kDefaultLanes << "}" << '\n';
    } else if (command == "write" && words >> folder) {
      Write(folder);
      std::cout << "written" << '\n';
    } else if (command == "box2d" && words >> scenario >> ms && scenario.starts_with("peers")) {
      std::cout << Box2dRate(scenario, ms) << '\n';
    } else if (std::ranges::count(bench::kWorkloads, command) == 1 && words >> lanes >> ms) {
      std::cout << EvaluatorRate(command, lanes, ms) << '\n';
    } else {
      std::cout << "unknown" << '\n';
    }
  }
  return 0;
}
