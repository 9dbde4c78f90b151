// SPDX-License-Identifier: MIT
#include "shell/results/queue_run.h"

#include <utility>
#include <vector>

#include "shell/words/language.h"
#include "shell/words/search_words.h"

namespace gaitsmith::shell {

QueueRun::QueueRun(Workspace& workspace, const Lab& lab, SearchRun& search, ResultStore& results)
    : workspace_(workspace), lab_(lab), search_(search), results_(results) {
  list_.on_change = [this] {
    workspace_.ClearEarlier();
    workspace_.Redraw();  // the page stores the queue with the document
  };
}

bool QueueRun::Add(const Document& document) {
  if (!list_.Add(document)) {
    workspace_.Say(Tr("The queue is full: {1} searches wait. Remove one, or let some run.",
                      std::to_string(SearchQueue::kMax)));
    return false;
  }
  workspace_.Report(Tr("Added to the queue: {1}, {2}. {3}.", SearchTitle(document), SearchLine(document),
                       WaitingWords(list_.Waiting().size())));
  return true;
}

int QueueRun::AddSeeds(int count, std::vector<Document> known) {
  std::vector<Document> others = std::move(known);
  if (const Document* running = search_.Searched()) others.push_back(*running);
  for (const SearchQueue::Entry& entry : list_.Waiting()) others.push_back(entry.document);
  int added = 0;
  Document next = workspace_.Doc();
  for (const std::uint32_t seed : FreeSeeds(workspace_.Doc(), others, count)) {
    next.search.seed = seed;
    if (!Add(next)) break;
    ++added;
  }
  return added;
}

void QueueRun::AddSuite(const SuiteChoice& choice) {
  const std::vector<Document> suite = SuiteOf(workspace_.Doc(), choice);
  int added = 0;
  for (const Document& one : suite) added += list_.Add(one) ? 1 : 0;
  if (!Busy()) RunNext();  // clears the status line
  const std::string count = std::to_string(suite.size());
  workspace_.Report(
      added < static_cast<int>(suite.size())
          ? Tr("The queue had room for {1} of the suite's {2} searches.", std::to_string(added), count)
          : Tr("The suite's {1} searches run one after another.", count));
}

bool QueueRun::Repeat(const std::string& id) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr || !entry->motion.CanRepeat()) return false;
  const Document document = SearchOf(entry->motion.document);
  if (Busy()) return Add(document);
  search_.Begin(document, SearchRun::Source::kQueue);
  return true;
}

bool QueueRun::Run() {
  if (lab_.Running()) {
    workspace_.Say(Tr("The lab is running: stop it first, or let it end."));
    return false;
  }
  if (search_.Running() || list_.Waiting().empty()) {
    workspace_.Say(Tr(search_.Running() ? "A search is running. The queue continues when the search is done."
                                        : "The queue is empty."));
    return false;
  }
  workspace_.Report("");
  RunNext();
  return true;
}

void QueueRun::RunNext() {
  search_.ClearInterruption();
  if (Busy()) return;
  if (auto next = list_.TakeFirst()) search_.Begin(std::move(*next), SearchRun::Source::kQueue);
}

void QueueRun::Resume() {
  if (search_.WasInterrupted()) RunNext();
}

}  // namespace gaitsmith::shell
