// SPDX-License-Identifier: MIT
// A host without workers. It records requests, and tests report the progress.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "shell/session/session.h"

namespace gaitsmith::shell::test {

class QuietHost final : public Host {
 public:
  [[nodiscard]] int MaxWorkers() const override { return 1; }
  void StartSearch(const Document& document, int) override { started.push_back(document); }
  void StartPreview(const Document& document, int) override { previews.push_back(document); }
  void StartTrial(const Document&, int, const TrialWords&) override {}
  void PauseSearch() override {}
  void ResumeSearch() override {}
  void StopSearch() override { ++stops; }
  void StartTransitionMap(const Document& request, int generation) override {
    mapped.push_back(request);
    generations.push_back(generation);
  }
  void StopTransitionMap() override { ++map_stops; }
  void StartPlan(const Document& document, int generation) override {
    planned.push_back(document);
    plan_generations.push_back(generation);
  }
  void StopPlan() override { ++plan_stops; }
  void Status(const std::string& sentence) override { status = sentence; }
  void SaveText(const std::string&, const std::string&) override {}
  void DocumentChanged(const std::string&) override { ++changes; }
  void StoreFound(const std::string& id, const std::string& text) override { stored[id] = text; }
  [[nodiscard]] double NowS() const override { return 1000.0 + static_cast<double>(started.size()); }

  std::vector<Document> started;   // searches, in order
  std::vector<Document> previews;  // searches of Live, in order
  std::map<std::string, std::string> stored;
  int stops = 0;
  int changes = 0;               // reported changes of the document or the queue
  std::vector<Document> mapped;  // requested transition maps, in order
  std::vector<int> generations;  // of each map
  int map_stops = 0;
  std::vector<Document> planned;      // documents whose plans were started, in order
  std::vector<int> plan_generations;  // of each of them
  int plan_stops = 0;
  std::string status;
};

/// The document without the view, which Undo ignores.
inline std::string State(const Session& session) {
  Document document = session.Doc();
  document.view = {};
  return EncodeJson(document);
}

/// Ends the last search with a genome in which every gene has this value.
inline void End(Session& session, const QuietHost& host, Gene gene) {
  SearchProgress progress{
      .state = SearchState::kDone, .evaluations = 50, .budget = 50, .curve = {}, .best_genome = {}};
  progress.best_genome.assign(ProblemOf(host.started.back()).Shape().Genes(), gene);
  progress.best_fitness = 1.0;
  session.OnSearchProgress(progress);
}

}  // namespace gaitsmith::shell::test
