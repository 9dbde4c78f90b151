// SPDX-License-Identifier: MIT
// A session's search: starting it, and letting its best motion take the place of the one on the stage.
#include <algorithm>
#include <utility>

#include "core/document/timeline_edit.h"
#include "shell/session/session.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

void Session::Synthesize() { BeginSearch(document_); }

void Session::TryStyle() {
  const Controller* shown = ShownController();
  if (shown == nullptr || !SuitsSearch(document_, *shown)) {
    Say(Tr("There is no motion to begin with: press Synthesize."));
    return;
  }
  // A moment's climb from what is there: the settings of the real search stay as they are.
  Document wanted = document_;
  wanted.search = SearchSettings{};
  wanted.search.algorithm = Algorithm::kShc;
  wanted.search.seed = document_.search.seed;
  wanted.search.evaluations = kTryEvaluations;
  wanted.search.start = document_.timeline[static_cast<std::size_t>(selected_clip_)].controller;
  BeginSearch(std::move(wanted));
  if (Searching()) ChooseGhost(Ghost::Kind::kEarlier);
}

void Session::BeginSearch(Document wanted, bool queued) {
  if (lab.Running()) {
    Say(Tr("The lab is running: stop it first, or let it end."));
    return;
  }
  if (Searching()) Halt();
  EndSearch();
  search_occasion_ = ++occasions_;
  searched_ = std::move(wanted);
  searched_clip_ = selected_clip_;
  queued_ = queued;
  off_stage_ = false;
  queue_due_ = false;
  progress_ = {.state = SearchState::kRunning,
               .budget = searched_->search.evaluations,
               .workers = workers,
               .curve = {},
               .best_genome = {}};
  progress_title_ = Tr("{1}, {2}, seed {3}", SearchTitle(*searched_),
                       WordsOf(searched_->search.algorithm).name, std::to_string(searched_->search.seed));
  if (queued) progress_title_ = Tr("Queue: {1}", progress_title_);
  spread_.Begin(progress_.budget);
  shown_for_s_ = 1e9;
  if (BelongsOnStage()) earlier_ = document_;
  if (queued) {
    host_.StartQueued(*searched_, workers, SearchTitle(*searched_) + ", " + SearchLine(*searched_));
  } else {
    notice.clear();
    host_.StartSearch(*searched_, workers);
  }
}

void Session::Stop() {
  StopLab();
  if (!Searching()) return;
  Halt();
  if (const std::size_t count = queue.Waiting().size(); count > 0)
    Say(Tr("Stopped. {1} until you press Run queue.", WaitingWords(count)));
}

void Session::Halt() {
  host_.StopSearch();
  progress_.state = SearchState::kStopped;
  ShowImprovement(1e9);
  NoteFound();
}

void Session::AbandonSearch() {
  if (RunsQueued()) {
    off_stage_ = true;
    improvement_.clear();
    return;
  }
  if (Searching()) {
    Halt();
    queue_due_ = true;
  }
  EndSearch();
}

// What it still reports is nobody's any more.
void Session::EndSearch() {
  searched_.reset();
  improvement_.clear();
  noted_.clear();
  queued_ = false;
}

void Session::ForgetProgress() {
  if (RunsQueued()) return;  // it goes on behind another document
  progress_ = {};
  spread_.Begin(1);
}

void Session::OnSearchProgress(SearchProgress progress) {
  if (lab.Running()) return OnTrialProgress(progress);
  if (!searched_) return;  // of a search that was stopped before its document went away
  const bool ended = progress.state == SearchState::kDone || progress.state == SearchState::kStopped ||
                     progress.state == SearchState::kFailed;
  if (progress.state == SearchState::kFailed) {
    // It has nothing more to say, but what it said before holds.
    progress = progress_;
    progress.state = SearchState::kFailed;
  }
  if (!progress.best_genome.empty() && progress.best_genome != progress_.best_genome) {
    improvement_ = progress.best_genome;
  } else if (progress.best_genome.empty()) {
    progress.best_genome = progress_.best_genome;
  }
  const bool first_end = ended && Searching();
  progress_ = std::move(progress);
  if (progress_.spread) spread_.Add(progress_.evaluations, *progress_.spread);
  if (!ended) return;
  ShowImprovement(1e9);
  NoteFound();
  if (auto map = EliteMap::Of(*searched_, progress_.saved)) elites_ = std::move(map);
  progress_.saved.clear();
  const std::string whose = queued_ ? SearchTitle(*searched_) : "";
  EndSearch();
  if (!first_end) return;
  if (progress_.state == SearchState::kFailed) {
    Say(whose.empty() ? Tr("The search failed.") : Tr("{1}: the search failed.", whose));
  } else {
    host_.Status((whose.empty() ? "" : whose + ": ") +
                 Tr(progress_.state == SearchState::kDone ? "Search done: best {1} after {2} evaluations."
                                                          : "Search stopped: best {1} after {2} evaluations.",
                    Fixed(progress_.best_fitness, 2), Grouped(progress_.evaluations)));
  }
  // At once rather than with the next frame: a tab that is not seen has none.
  if (progress_.state != SearchState::kStopped) RunNext();
}

// A search of the queue improves the document in hand only where that asks for the very same search.
bool Session::BelongsOnStage() const {
  if (!searched_) return false;
  if (!queued_) return true;
  return !off_stage_ && document_.timeline.size() < 2 && searched_->search.start < 0 &&
         SameSearch(document_, *searched_);
}

bool Session::ShowImprovement(double seconds) {
  // A new motion every frame would show none of them.
  constexpr double kShortestShow = 0.8;
  shown_for_s_ += seconds;
  if (improvement_.empty() || shown_for_s_ < kShortestShow || !searched_) return false;
  shown_for_s_ = 0.0;
  Genome genes = std::move(improvement_);
  improvement_.clear();
  if (!BelongsOnStage()) return false;
  const SearchSettings& search = searched_->search;
  PutController({.name = WordsOf(search.algorithm).name + ", seed " + std::to_string(search.seed),
                 .kind = searched_->kind,
                 .senses = searched_->senses,
                 .rules = searched_->rules,
                 .genes = std::move(genes)});
  return true;
}

// Gives the searched clip this controller; other clips keep theirs, and controllers that nobody uses any more
// go.
void Session::PutController(Controller controller) {
  const bool first = document_.timeline.empty();
  auto next = Edited([&](Document& d) {
    d.controllers.push_back(std::move(controller));
    const int added = static_cast<int>(d.controllers.size()) - 1;
    if (d.timeline.empty()) d.timeline.push_back({0, 0});
    const int clip = std::clamp(searched_clip_, 0, static_cast<int>(d.timeline.size()) - 1);
    const int old = std::exchange(d.timeline[static_cast<std::size_t>(clip)].controller, added);
    if (d.timeline.size() == 1) d.duration_steps = searched_->task.duration_steps;
    // A search that began with what is replaced begins with what replaces it.
    const bool replaced =
        std::ranges::none_of(d.timeline, [&](const Clip& c) { return c.controller == old; });
    if (d.search.start == old && replaced) d.search.start = added;
    DropUnusedControllers(d);
    d.title = FoundTitle(d.figure.name, *searched_);
  });
  if (!next) return;
  notice.clear();
  Remember(search_occasion_);
  next->hash.reset();
  Show(std::move(*next), false);
  // What was found in the middle of a drag must not be lost by undoing the drag.
  BeginGesture();
  if (first) player.Seek(0.0);
}

}  // namespace gaitsmith::shell
