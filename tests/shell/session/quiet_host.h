// SPDX-License-Identifier: MIT
// A place without workers: searches begin, and report what a test makes them report.
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
  void StartTrial(const Document&, int, const TrialWords&) override {}
  void PauseSearch() override {}
  void ResumeSearch() override {}
  void StopSearch() override { ++stops; }
  void StartTransitionMap(const Document& request, int generation) override {
    mapped.push_back(request);
    generations.push_back(generation);
  }
  void StopTransitionMap() override { ++map_stops; }
  void Status(const std::string& sentence) override { status = sentence; }
  void SaveText(const std::string&, const std::string&) override {}
  void DocumentChanged(const std::string&) override {}
  void StoreFound(const std::string& id, const std::string& text) override { stored[id] = text; }
  [[nodiscard]] double NowS() const override { return 1000.0 + static_cast<double>(started.size()); }

  std::vector<Document> started;  // searches, in their order
  std::map<std::string, std::string> stored;
  int stops = 0;
  std::vector<Document> mapped;  // transition maps, in their order
  std::vector<int> generations;  // of each
  int map_stops = 0;
  std::string status;
};

/// All but the view, which is no part of any step of Undo.
inline std::string State(const Session& session) {
  Document document = session.Doc();
  document.view = {};
  return EncodeJson(document);
}

/// The search that was started last ends with this gene everywhere.
inline void End(Session& session, const QuietHost& host, Gene gene) {
  SearchProgress progress{
      .state = SearchState::kDone, .evaluations = 50, .budget = 50, .curve = {}, .best_genome = {}};
  progress.best_genome.assign(ProblemOf(host.started.back()).Shape().Genes(), gene);
  progress.best_fitness = 1.0;
  session.OnSearchProgress(progress);
}

}  // namespace gaitsmith::shell::test
