// SPDX-License-Identifier: MIT
// The queue at work: searches with their own problems, which begin one after another when the search before
// them is done or has failed. One that a person stops leaves the others waiting for Run. They leave the stage
// alone, unless the open document asks for just that search. What they find goes to the results.
#pragma once

#include <string>

#include "shell/session/lab.h"
#include "shell/session/result_store.h"
#include "shell/session/search_queue.h"
#include "shell/session/search_run.h"
#include "shell/session/suite_plan.h"
#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class QueueRun {
 public:
  /// @param lab  excludes searches while it runs
  QueueRun(Workspace& workspace, const Lab& lab, SearchRun& search, ResultStore& results)
      : workspace_(workspace), lab_(lab), search_(search), results_(results) {}

  /// The searches that wait.
  [[nodiscard]] SearchQueue& List() { return list_; }
  [[nodiscard]] const SearchQueue& List() const { return list_; }

  /// Puts a document's search behind all that wait. @param document valid. @return false, with a sentence: no
  /// room
  bool Add(const Document& document);
  /// The search of the open document, with further seeds that neither run nor wait yet. @return how many
  int AddSeeds(int count);
  /// Queues the suite's searches, and lets them run.
  void AddSuite(const SuiteChoice&);
  /// The search that found a motion once more: the same seed, settings and problem. It begins at once where
  /// nothing runs. @return false: there is no such motion, no search has found it, or there is no room
  bool Repeat(const std::string& id);

  /// A search or the lab runs.
  [[nodiscard]] bool Busy() const { return search_.Running() || lab_.Running(); }
  /// Begins with the first that waits; then the others follow by themselves. Refused, with a sentence, while
  /// a search or the lab runs.
  bool Run();
  /// Begins the next one, unless something runs.
  void RunNext();
  /// Once a frame: begins the next one after a search was stopped because its document went away.
  void Resume();

 private:
  Workspace& workspace_;
  const Lab& lab_;
  SearchRun& search_;
  ResultStore& results_;
  SearchQueue list_;
};

}  // namespace gaitsmith::shell
