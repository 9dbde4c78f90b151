// SPDX-License-Identifier: MIT
// A session's search: starting it, and letting its best motion take the place of the one on the stage.
#include <algorithm>

#include "shell/algorithm_words.h"
#include "shell/session.h"
#include "shell/wording.h"

namespace gaitsmith::shell {

void Session::Synthesize() { BeginSearch(document_); }

void Session::TryStyle() {
  const Controller* shown = ShownController();
  if (shown == nullptr || !SuitsSearch(document_, *shown)) {
    Say("There is no motion to begin with: press Synthesize.");
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
  if (Searching()) ChooseGhost(kEarlierGhost);
}

void Session::BeginSearch(Document wanted) {
  if (lab.Running()) {
    Say("The lab is running: stop it first, or let it end.");
    return;
  }
  if (Searching()) Stop();
  search_occasion_ = ++occasions_;
  notice.clear();
  earlier_ = document_;
  searched_ = std::move(wanted);
  searched_clip_ = selected_clip_;
  progress_ = {.state = SearchState::kRunning,
               .budget = searched_->search.evaluations,
               .workers = workers,
               .curve = {},
               .best_genome = {}};
  improvement_.clear();
  shown_for_s_ = 1e9;
  host_.StartSearch(*searched_, workers);
}

void Session::Stop() {
  StopLab();
  if (!Searching()) return;
  host_.StopSearch();
  progress_.state = SearchState::kStopped;
  ShowImprovement(1e9);
}

void Session::AbandonSearch() {
  if (Searching()) Stop();
  searched_.reset();
  improvement_.clear();
}

void Session::OnSearchProgress(SearchProgress progress) {
  if (lab.Running()) return OnTrialProgress(progress);
  if (!searched_) return;  // of a search that was stopped before its document went away
  const bool ended = progress.state == SearchState::kDone || progress.state == SearchState::kStopped ||
                     progress.state == SearchState::kFailed;
  if (!progress.best_genome.empty() && progress.best_genome != progress_.best_genome) {
    improvement_ = progress.best_genome;
  } else if (progress.best_genome.empty()) {
    progress.best_genome = progress_.best_genome;
  }
  const bool first_end = ended && Searching();
  progress_ = std::move(progress);
  if (!ended) return;
  ShowImprovement(1e9);
  searched_.reset();
  if (!first_end) return;
  if (progress_.state == SearchState::kFailed) {
    Say("The search failed.");
  } else {
    host_.Status((progress_.state == SearchState::kDone ? "Search done: best " : "Search stopped: best ") +
                 Fixed(progress_.best_fitness, 2) + " after " + Grouped(progress_.evaluations) +
                 " evaluations.");
  }
}

bool Session::ShowImprovement(double seconds) {
  // A new motion every frame would show none of them.
  constexpr double kShortestShow = 0.8;
  shown_for_s_ += seconds;
  if (improvement_.empty() || shown_for_s_ < kShortestShow || !searched_) return false;
  shown_for_s_ = 0.0;
  Genome genes = std::move(improvement_);
  improvement_.clear();
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
    d.timeline[static_cast<std::size_t>(clip)].controller = added;
    if (d.timeline.size() == 1) d.duration_steps = searched_->task.duration_steps;
    for (int c = added; c >= 0; --c) {
      if (std::ranges::any_of(d.timeline, [c](const Clip& one) { return one.controller == c; })) continue;
      // A search that began with what is replaced begins with what replaces it.
      if (d.search.start == c) d.search.start = d.timeline[static_cast<std::size_t>(clip)].controller;
      if (d.search.start > c) --d.search.start;
      d.controllers.erase(d.controllers.begin() + c);
      for (Clip& one : d.timeline) one.controller -= one.controller > c ? 1 : 0;
    }
    const std::string how = " · " + TaskWords(searched_->task.kind) + ", " +
                            ControllerWords(searched_->kind, searched_->senses, searched_->rules) +
                            ", seed " + std::to_string(searched_->search.seed);
    d.title = Shortened(d.figure.name, kMaxNameBytes - how.size()) + how;
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
