// SPDX-License-Identifier: MIT
// Runs the queue: searches with their own problems, each started when the one before is done or has failed.
// After a person stops a search, the others wait for Run. Motions of the queue are shown only if the open
// document has the same search. All results go to the result list.
#pragma once

#include <string>
#include <vector>

#include "shell/results/lab.h"
#include "shell/results/result_store.h"
#include "shell/results/search_queue.h"
#include "shell/results/search_run.h"
#include "shell/results/suite_plan.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class QueueRun {
 public:
  /// @param lab  no search can run while the lab runs
  QueueRun(Workspace&, const Lab& lab, SearchRun&, ResultStore&);

  /// The waiting searches.
  [[nodiscard]] SearchQueue& List() { return list_; }
  [[nodiscard]] const SearchQueue& List() const { return list_; }

  /// Adds a document's search to the end of the queue. @param document valid. @return false, with a sentence:
  /// no room
  bool Add(const Document& document);
  /// Queues the open document's search with further seeds, skipping seeds that run or wait already. @return
  /// the number of searches added
  /// @param known  searches whose seeds are skipped, too
  int AddSeeds(int count, std::vector<Document> known = {});
  /// Queues the suite's searches and starts the queue.
  void AddSuite(const SuiteChoice&);
  /// Repeats the search that found a motion, with the same seed, settings and problem. Starts at once if
  /// nothing runs. @return false: there is no such motion, it is not from a search, or there is no room
  bool Repeat(const std::string& id);

  /// Whether a search or the lab runs.
  [[nodiscard]] bool Busy() const { return search_.Running() || lab_.Running(); }
  /// Starts the first waiting search; the others follow automatically. Refused, with a sentence, while a
  /// search or the lab runs.
  bool Run();
  /// Starts the next search unless something runs.
  void RunNext();
  /// Call once a frame: starts the next search after one was stopped because its document was replaced.
  void Resume();

 private:
  Workspace& workspace_;
  const Lab& lab_;
  SearchRun& search_;
  ResultStore& results_;
  SearchQueue list_;
};

}  // namespace gaitsmith::shell
