// SPDX-License-Identifier: MIT
#include "shell/results/result_store.h"

#include <utility>

#include "shell/results/search_queue.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

ResultStore::ResultStore(Workspace& workspace) : workspace_(workspace) {
  motions_.on_change = [this](const std::string& id, const std::string& text) {
    workspace_.TheHost().StoreFound(id, text);
    workspace_.ClearEarlier();
  };
}

std::optional<std::string> ResultStore::AddFound(const Document& searched, const SearchProgress& at_end,
                                                 const std::string& in_place_of) {
  const bool failed = at_end.state == SearchState::kFailed;
  const bool any = !at_end.best_genome.empty() && at_end.best_fitness > kVoidScore;
  if (!any && !failed) return std::nullopt;
  if (searched.search.in_place_of >= 0) return std::nullopt;  // the result belongs to its composite alone
  Document document = any ? FoundDocument(searched, at_end.best_genome) : SearchOf(searched);
  if (!any) document.title = SearchName(document);
  FoundMotion motion = Measured(std::move(document),
                                failed                                  ? Origin::kFailed
                                : at_end.state == SearchState::kStopped ? Origin::kStopped
                                                                        : Origin::kDone,
                                at_end.evaluations);
  motion.when_s = workspace_.TheHost().NowS();
  std::string id = motions_.Add(std::move(motion), in_place_of);
  if (id.empty())
    workspace_.Say(
        Tr("The motion was not added to the results: all places hold saved motions. Delete some."));
  return id;
}

bool ResultStore::KeepShown() {
  const Document& shown = workspace_.Doc();
  if (shown.timeline.empty()) {
    workspace_.Say(Tr("There is no motion to save yet. Press Synthesize."));
    return false;
  }
  FoundMotion motion = Measured(shown, Origin::kByHand, 0);
  motion.kept = true;
  motion.when_s = workspace_.TheHost().NowS();
  const std::string id = FoundId(motion.document);
  // A motion of the results is saved as found, since its entry records more than the shown motion.
  const bool there = motions_.Keep(id, true);
  if (!there && motions_.Add(std::move(motion)).empty()) {
    workspace_.Say(Tr("Not saved: the results are full. Delete something first."));
    return false;
  }
  workspace_.Report(Tr("Saved to the results: {1}.", TrTitle(shown.title)));
  return true;
}

bool ResultStore::IsShown(const FoundMotions::Entry& entry) const {
  // The cheap test first: this runs at every frame.
  const std::uint64_t shown = workspace_.Player().Shown().Hash();
  return entry.motion.document.hash == shown && entry.id == FoundId(workspace_.WithHash());
}

void ResultStore::AskName(const std::string& id) const {
  if (const FoundMotions::Entry* entry = motions_.Find(id); entry != nullptr)
    workspace_.TheHost().AskName(id, entry->motion.name, SearchTitle(entry->motion.document));
}

}  // namespace gaitsmith::shell
