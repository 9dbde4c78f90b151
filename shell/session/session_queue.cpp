// SPDX-License-Identifier: MIT
// A session's queue of searches, and the motions that searches have found.
#include <algorithm>
#include <vector>

#include "shell/session/session.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

bool Session::Enqueue(const Document& document) {
  if (!queue.Add(document)) {
    Say(Tr("The queue is full: {1} searches wait. Remove one, or let some run.",
           std::to_string(SearchQueue::kMost)));
    return false;
  }
  host_.Status(Tr("Added to the queue: {1}, {2}. {3}.", SearchTitle(document), SearchLine(document),
                  WaitingWords(queue.Waiting().size())));
  return true;
}

int Session::EnqueueSeeds(int count) {
  std::vector<Document> others;
  if (const Document* running = Searched()) others.push_back(*running);
  for (const SearchQueue::Entry& entry : queue.Waiting()) others.push_back(entry.document);
  int added = 0;
  Document next = document_;
  for (const std::uint32_t seed : FreeSeeds(document_, others, count)) {
    next.search.seed = seed;
    if (!Enqueue(next)) break;
    ++added;
  }
  return added;
}

bool Session::RunQueue() {
  if (lab.Running()) {
    Say(Tr("The lab is running: stop it first, or let it end."));
    return false;
  }
  if (Searching() || queue.Waiting().empty()) {
    Say(Tr(Searching() ? "A search is running: the queue goes on when it is done." : "Nothing waits."));
    return false;
  }
  notice.clear();
  RunNext();
  return true;
}

void Session::MakeSuite(const SuiteChoice& choice) {
  const std::vector<Document> suite = SuiteOf(document_, choice);
  int added = 0;
  for (const Document& one : suite) added += queue.Add(one) ? 1 : 0;
  if (!Searching() && !lab.Running()) RunNext();  // which clears the status line
  const std::string count = std::to_string(suite.size());
  host_.Status(
      added < static_cast<int>(suite.size())
          ? Tr("The queue had room for {1} of the suite's {2} searches.", std::to_string(added), count)
          : Tr("The suite's {1} searches run one after another.", count));
}

bool Session::MakeAgain(const std::string& id) {
  const FoundMotions::Entry* entry = found.Find(id);
  if (entry == nullptr || entry->motion.origin == Origin::kByHand) return false;
  const Document document = SearchOf(entry->motion.document);
  if (!Searching() && !lab.Running()) {
    BeginSearch(document, true);
    return true;
  }
  return Enqueue(document);
}

void Session::AskName(const std::string& id) const {
  if (const FoundMotions::Entry* entry = found.Find(id); entry != nullptr)
    host_.AskName(id, entry->motion.name, SearchTitle(entry->motion.document));
}

void Session::RunNext() {
  queue_due_ = false;
  if (Searching() || lab.Running()) return;
  if (auto next = queue.TakeFirst()) BeginSearch(std::move(*next), true);
}

// At the end of a search, and once more when a stopped one tells how far it came in the end.
void Session::NoteFound() {
  const bool failed = progress_.state == SearchState::kFailed;
  const bool any = !progress_.best_genome.empty() && progress_.best_fitness > kVoidScore;
  if (!searched_ || (!any && !failed)) return;
  if (searched_->search.in_place_of >= 0) return;  // it belongs to its composite alone
  Document document = any ? FoundDocument(*searched_, progress_.best_genome) : SearchOf(*searched_);
  if (!any) document.title = SearchName(document);
  FoundMotion motion = Measured(std::move(document),
                                failed                                     ? Origin::kFailed
                                : progress_.state == SearchState::kStopped ? Origin::kStopped
                                                                           : Origin::kDone,
                                progress_.evaluations);
  motion.when_s = host_.NowS();
  noted_ = found.Add(std::move(motion), noted_);
  if (noted_.empty()) Say(Tr("What was found is not among the results: all of them are kept. Delete some."));
  MeetRival();
}

bool Session::KeepMotion() {
  if (document_.timeline.empty()) {
    Say(Tr("There is no motion to keep: press Synthesize."));
    return false;
  }
  FoundMotion motion = Measured(document_, Origin::kByHand, 0);
  motion.kept = true;
  motion.when_s = host_.NowS();
  const std::string id = FoundId(motion.document);
  // What a search has found is known better than what is seen.
  const bool there = found.Keep(id, true);
  if (!there && found.Add(std::move(motion)).empty()) {
    Say(Tr("Not kept: there is no room for more than what is kept. Delete something first."));
    return false;
  }
  host_.Status(Tr("Kept among the results: {1}.", TrTitle(document_.title)));
  return true;
}

bool Session::ShowFound(const std::string& id) {
  const FoundMotions::Entry* entry = found.Find(id);
  if (entry == nullptr) return false;
  Document document = entry->motion.document;
  if (const std::string& name = entry->motion.name; !name.empty()) {
    document.title = name;
    if (document.timeline.size() == 1)
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)].name = name;
  }
  const bool moves = entry->motion.Moves();
  if (!Replace(document, true)) return true;  // it says why
  if (differs_from_maker_) return true;       // the stage says so
  Say(Tr(moves ? "{1}. Undo brings back what was here."
               : "{1}: this search failed. Undo brings back what was here.",
         TrTitle(document_.title)));
  return true;
}

void Session::ShowElite(Document motion) {
  BeginGesture();
  if (!Replace(std::move(motion), true)) return;
  Say(Tr("{1}. “Keep motion” puts it among the results; Undo brings back what was here.",
         TrTitle(document_.title)));
}

bool Session::InHand(const FoundMotions::Entry& entry) const {
  // The cheap question first: this is asked at every frame.
  return entry.motion.document.hash == player.Shown().Hash() && entry.id == FoundId(WithHash());
}

}  // namespace gaitsmith::shell
