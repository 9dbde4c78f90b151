// SPDX-License-Identifier: MIT
#include "core/breeding/litter.h"

#include <utility>

#include "core/document/parts.h"
#include "core/rollout/models.h"
#include "core/search/evaluation_score.h"

namespace gaitsmith {

namespace {

std::vector<int> BitsOf(std::uint32_t bits, int most) {
  std::vector<int> set;
  for (int i = 0; i < most; ++i) {
    if ((bits >> i & 1u) != 0) set.push_back(i);
  }
  return set;
}

int JointsOf(const Document& document) { return CountPorts(document.model, document.figure).actuators; }

const BreedRound& RoundOf(const Document& nursery) { return nursery.lineage.rounds.front(); }

}  // namespace

Document NurseryOf(const Document& document, std::vector<Controller> parents, BreedRound wish) {
  Document nursery;
  CopyParts(document, {Part::kTitle, kScene}, nursery);
  wish.parent = -1;
  wish.picks = (1u << parents.size()) - 1;
  nursery.task = wish.task;
  nursery.senses = parents.front().senses;
  nursery.rules = parents.front().rules;
  nursery.kind = parents.front().kind;
  nursery.lineage = {.founders = std::move(parents), .rounds = {std::move(wish)}};
  return nursery;
}

Result<Document> NurseryOf(const Document& document, int round, std::span<const Genome> litter) {
  const auto& [founders, rounds, shown] = document.lineage;
  if (round < 0 || round >= static_cast<int>(rounds.size()))
    return Fail(ErrorCode::kOutOfRange, "round",
                "there is no round " + std::to_string(round) + " in the lineage");
  const BreedRound& wish = rounds[static_cast<std::size_t>(round)];
  std::vector<Controller> parents;
  for (const int pick : BitsOf(wish.picks, kMaxFounders)) {
    const auto at = static_cast<std::size_t>(pick);
    if (wish.parent < 0) {
      parents.push_back(founders[at]);
      continue;
    }
    if (at >= litter.size() || litter[at].size() != founders.front().genes.size())
      return Fail(ErrorCode::kStructure, "lineage.rounds[" + std::to_string(round) + "].picks",
                  "child " + std::to_string(pick) + " was picked, but it was not born");
    parents.push_back(founders.front());
    parents.back().genes = litter[at];
  }
  return NurseryOf(document, std::move(parents), wish);
}

Problem NurseryProblem(const Document& nursery) {
  Problem problem = ProblemOf(nursery);
  // Founders have no genes of a body: breeding keeps it.
  problem.figure = nursery.figure;
  problem.bodies.reset();
  problem.traits = true;
  return problem;
}

std::unique_ptr<Brood> BroodOf(const Document& nursery, int evaluations, int children) {
  const BreedRound& round = RoundOf(nursery);
  BreedWish wish{.parents = {},
                 .children = children,
                 .difference = round.difference,
                 .keep_goal = round.keep_goal,
                 .kept_rules = BitsOf(round.kept_rules, nursery.rules),
                 .kept_joints = BitsOf(round.kept_joints, JointsOf(nursery))};
  for (const Controller& parent : nursery.lineage.founders) wish.parents.push_back(parent.genes);
  SearchSettings settings;
  settings.seed = round.seed;
  settings.evaluations = evaluations;
  return std::make_unique<Brood>(settings, SpaceOf(NurseryProblem(nursery)), std::move(wish));
}

Document ChildOf(const Document& document, Genome child) {
  Document shown = document;
  Controller controller = document.lineage.founders.front();
  controller.name.clear();
  controller.genes = std::move(child);
  shown.senses = controller.senses;
  shown.rules = controller.rules;
  shown.kind = controller.kind;
  shown.controllers = {std::move(controller)};
  shown.timeline = {{.controller = 0, .start_step = 0}};
  shown.duration_steps = shown.task.duration_steps;
  shown.pushes.clear();
  shown.search.start = shown.search.in_place_of = -1;
  shown.search.handovers.clear();
  shown.title = shown.figure.name;
  shown.hash.reset();
  return shown;
}

}  // namespace gaitsmith
