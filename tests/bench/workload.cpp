// SPDX-License-Identifier: MIT
#include "tests/bench/workload.h"

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "core/document/json.h"
#include "core/rollout/evaluator.h"

namespace gaitsmith::bench {

namespace {

constexpr int kSearchEvaluations = 3000;  // enough to find a shuffle, in less than a second

Gene Share(int part, int whole) { return static_cast<Gene>(part * int{kGeneMax} / whole); }

}  // namespace

Document StarMan(SenseKind kind) {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/examples/figures/mr-star-man.json");
  Document document;
  document.figure = DecodeFigureJson(std::string(std::istreambuf_iterator<char>(file), {})).value();
  document.senses.kind = kind;
  return document;
}

Workload RandomGenomes(const Document& document) {
  Workload workload{document, {}};
  for (std::uint64_t i = 0; i < kGenomes; ++i) {
    RandomStream random(1, 0, i);
    workload.genomes.push_back(
        RandomGenome(SpaceOf(document).shape, document.senses, document.search.variation, random));
  }
  return workload;
}

Workload Gaits(const Document& document) {
  const Evaluator evaluator(ProblemOf(document));
  const auto search = MakeSearch(document.search, SpaceOf(document));
  while (search->Evaluations() < kSearchEvaluations) {
    std::vector<float> fitness;
    for (const Evaluation& one : evaluator.Evaluate(search->Ask(160))) fitness.push_back(one.fitness);
    search->Tell(fitness);
  }
  Workload workload{document, {}};
  for (std::uint64_t i = 0; i < kGenomes; ++i) {
    RandomStream random(2, 0, i);
    workload.genomes.push_back(Perturb(search->BestGenome(), SpaceOf(document).shape, document.senses,
                                       document.search.variation, random));
  }
  return workload;
}

Workload Peers() {
  Workload peers{StarMan(SenseKind::kTimer), {}};
  Document& document = peers.document;
  document.environment.friction = kPeerFriction;
  document.task.duration_steps = kPeerSteps;
  document.rules = kPeerTargets;
  document.senses.period_steps = kPeerSteps;
  document.senses.tau_min_s = kPeerTauS;
  document.senses.tau_max_s = kPeerTauS;
  const BankShape shape = SpaceOf(document).shape.Bank();
  for (std::uint64_t figure = 0; figure < kGenomes; ++figure) {
    RandomStream random(3, 0, figure);
    Genome genome(shape.Genes());
    for (int rule = 0; rule < kPeerTargets; ++rule) {
      genome[shape.Low(rule, 0)] = Share(rule, kPeerTargets);
      genome[shape.High(rule, 0)] = Share(rule + 1, kPeerTargets);
      for (int joint = 0; joint < shape.joints; ++joint) genome[shape.Target(rule, joint)] = random.Gene();
    }
    peers.genomes.push_back(std::move(genome));
  }
  return peers;
}

Workload LimitedPeers() {
  Workload peers = Peers();
  peers.document.model = 2;
  return peers;
}

float PeerTarget(const Workload& peers, int figure, int interval, int joint) {
  const BankShape shape = SpaceOf(peers.document).shape.Bank();
  const Rod& rod = peers.document.figure.rods[static_cast<std::size_t>(joint) + 1];
  const Genome& genome = peers.genomes[static_cast<std::size_t>(figure)];
  return Decode(genome[shape.Target(interval, joint)], rod.min_rad, rod.max_rad);
}

const Workload& WorkloadOf(std::string_view name) {
  static std::map<std::string_view, Workload> made;
  for (const std::string_view known : kWorkloads) {
    if (known != name || made.contains(known)) continue;
    const bool timer = name.starts_with("timer");
    const Document document = StarMan(timer ? SenseKind::kTimer : SenseKind::kPhysical);
    made[known] = name == "peers"           ? Peers()
                  : name == "peers-limited" ? LimitedPeers()
                  : name.ends_with("gait")  ? Gaits(document)
                                            : RandomGenomes(document);
  }
  return made.at(name);
}

}  // namespace gaitsmith::bench
