// SPDX-License-Identifier: MIT
#include "shell/command_line/trial.h"

#include <algorithm>

#include "core/document/link.h"
#include "core/rollout/evaluator.h"
#include "core/search/evaluation_score.h"

namespace gaitsmith::shell {

namespace {

/// Genomes per ask: enough to fill the lanes twice. After an improvement, the rest of a batch may be wasted.
constexpr int kAskedTogether = Evaluator::kDefaultLanes * 2;

}  // namespace

std::optional<std::vector<std::string>> RunTrial(const Study& study, std::size_t trial,
                                                 std::span<const StudyTable> tables,
                                                 std::atomic<std::int64_t>& evaluations,
                                                 const std::function<bool()>& stop) {
  const StudyPlan::Trial place = study.plan.At(trial);
  const Document document = TrialDocument(study, place.problem, place.search, place.seed);
  const Problem problem = ProblemOf(document);
  const Scorer scorer(problem);
  const auto search = MakeSearch(document.search, scorer.Space(StartOf(document)));
  while (!search->Done()) {
    if (stop()) return std::nullopt;
    const int before = search->Evaluations();
    const std::vector<Genome> genomes = search->Ask(kAskedTogether);
    search->Tell(scorer.ScoresOf(genomes));
    evaluations += search->Evaluations() - before;
  }
  Document found = document;
  found.controllers.push_back(TakeFound(document, search->BestGenome(), found));
  found.timeline = {{static_cast<int>(found.controllers.size()) - 1, 0}};
  found.duration_steps = document.task.duration_steps;
  const Motion motion = Simulate(found);
  found.hash = motion.Hash();
  const bool linked = std::ranges::find(tables, StudyTable::kMotions) != tables.end();
  const TrialResult result{.best = search->BestFitness(),
                           .terms = motion.TermsAt(motion.Frames() - 1),
                           .ground = GroundUseOf(motion),
                           .hash = *found.hash,
                           .curve = search->Curve(),
                           .link = linked ? EncodeLink(found) : ""};
  std::vector<std::string> rows;
  for (const StudyTable table : tables) rows.push_back(RowsOf(study.plan, table, trial, result));
  return rows;
}

}  // namespace gaitsmith::shell
