// SPDX-License-Identifier: MIT
#include "shell/session/live.h"

#include <algorithm>
#include <utility>

#include "core/document/standing.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr double kKeysS = 0.15;         // after the last step of a key held down
constexpr double kShortestRunS = 0.1;   // of a preview, so that it gets somewhere while a slider moves
constexpr double kShortestShowS = 0.2;  // of one preview
constexpr double kRestS = 3.0;          // a preview of an unchanged document has found what it will find
constexpr double kLateS = 0.5;
constexpr int kMostLate = 3;

Document SearchedWith(Document document, int evaluations, std::uint32_t seed) {
  SearchSettings search;
  search.algorithm = Algorithm::kPoseCycle;
  search.evaluations = evaluations;
  search.seed = seed;
  document.search = search;
  return document;
}

bool ShowsAll(const Arrangement& layout) {
  return std::ranges::find(layout.shown, false) == layout.shown.end() &&
         std::ranges::find(layout.locked, true) == layout.locked.end();
}

}  // namespace

bool Live::On() const {
  const Arrangement& layout = workspace_.Layout();
  return chosen_.value_or(layout.live.value_or(late_ < kMostLate && ShowsAll(layout)));
}

void Live::Switch(bool on) {
  chosen_ = on;
  late_ = 0;
  Drop();
  workspace_.Redraw();
}

void Live::OnEdit(Parts changed) {
  if (!On() || !Possible() || search_.Busy() || !changed.HasAny(kWatched)) return;
  changed_ = outdated_ = true;
  quiet_s_ = 0.0;
  occasion_ = workspace_.Gesture();
}

void Live::Drop() {
  if (Searching()) workspace_.TheHost().StopSearch();
  runs_ = Run::kNothing;
  changed_ = outdated_ = false;
  best_.clear();
  workspace_.EndPreview();
}

Document Live::Wanted(const Genome& genes, int evaluations) const {
  const Controller& shown = *workspace_.ShownController();
  Document wanted = SearchedWith(workspace_.Doc(), evaluations, workspace_.Doc().search.seed);
  wanted.senses = shown.senses;
  wanted.rules = shown.rules;
  wanted.kind = shown.kind;
  wanted.search.start = wanted.timeline.front().controller;
  if (!genes.empty()) wanted.controllers[static_cast<std::size_t>(wanted.search.start)].genes = genes;
  return wanted;
}

void Live::StartPreview() {
  if (runs_ != Run::kPreview) {
    previews_ = 0;
    workspace_.TheHost().Status(Tr("Preview: let go to keep what is found."));
  }
  searched_ = Wanted(workspace_.Previewed(), kPreviewEvaluations);
  searched_.search.seed += static_cast<std::uint32_t>(++previews_);
  runs_ = Run::kPreview;
  outdated_ = answered_ = false;
  running_s_ = 0.0;
  best_.clear();
  // One core is left for drawing.
  workspace_.TheHost().StartPreview(searched_, std::max(1, search_.Workers() - 1));
}

void Live::StartFinal(Document wanted) {
  searched_ = std::move(wanted);
  runs_ = Run::kFinal;
  changed_ = outdated_ = false;
  best_.clear();
  answered_ = true;
  running_s_ = 0.0;
  workspace_.TheHost().StartPreview(searched_, search_.Workers());
}

void Live::SearchAnew() {
  if (!changed_ || search_.Busy()) return;
  Document wanted = SearchedWith(workspace_.Doc(), kQuickEvaluations, workspace_.Doc().search.seed);
  wanted.search.body = workspace_.Doc().search.body;
  StartFinal(std::move(wanted));
}

void Live::OnProgress(const SearchProgress& progress) {
  if (!std::exchange(answered_, true)) late_ = running_s_ > kLateS ? late_ + 1 : 0;
  const bool ended = progress.state != SearchState::kRunning && progress.state != SearchState::kPaused;
  if (runs_ == Run::kPreview) {
    if (!progress.best_genome.empty()) best_ = progress.best_genome;
    if (ended) runs_ = Run::kNothing;
    return;
  }
  if (!ended) return;
  runs_ = Run::kNothing;
  const bool anew = searched_.search.start < 0;
  workspace_.EndPreview();
  if (progress.state == SearchState::kDone) search_.Adopt(std::move(searched_), progress, occasion_);
  if (anew) workspace_.Player().Present();
}

bool Live::Advance(double seconds) {
  quiet_s_ += seconds;
  running_s_ += seconds;
  shown_for_s_ += seconds;
  if (search_.Busy() || !Possible()) {  // a search that a person started, perhaps from the queue
    runs_ = Run::kNothing;
    changed_ = false;
    workspace_.EndPreview();
    return false;
  }
  if (changed_ && held_) {
    const bool on = outdated_ ? runs_ != Run::kPreview || running_s_ >= kShortestRunS
                              : runs_ != Run::kPreview && quiet_s_ < kRestS;
    if (on) StartPreview();
  } else if (changed_ && (Previewing() || quiet_s_ >= kKeysS)) {
    StartFinal(Wanted({}, kEvaluations));
  }
  if (runs_ == Run::kFinal || best_.empty() || shown_for_s_ < kShortestShowS) return false;
  shown_for_s_ = 0.0;
  return workspace_.Preview(std::exchange(best_, {}));
}

}  // namespace gaitsmith::shell
