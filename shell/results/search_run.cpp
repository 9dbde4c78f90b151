// SPDX-License-Identifier: MIT
#include "shell/results/search_run.h"

#include <algorithm>
#include <utility>

#include "core/document/composite.h"
#include "core/document/parts.h"
#include "core/document/timeline_edit.h"
#include "shell/results/search_queue.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/language.h"
#include "shell/words/motion_name.h"
#include "shell/words/search_words.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr std::size_t kEndedKept = 100;
constexpr double kAtOnceS = 1e9;  // longer than any motion stays on the screen

}  // namespace

SearchRun::SearchRun(Workspace& workspace, const Lab& lab, ResultStore& results)
    : workspace_(workspace), lab_(lab), results_(results), workers_(workspace.TheHost().MaxWorkers()) {}

// Only for this search: the document keeps its own search settings.
Document SearchRun::ShortClimb() const {
  Document wanted = workspace_.Doc();
  const auto clip = static_cast<std::size_t>(workspace_.SelectedClip());
  wanted.search = SearchSettings{};
  wanted.search.algorithm = Algorithm::kPoseCycle;
  wanted.search.seed = workspace_.Doc().search.seed;
  wanted.search.evaluations = kTryEvaluations;
  wanted.search.start = wanted.timeline[clip].controller;
  return wanted;
}

bool SearchRun::TryStyle(UndoStep step) {
  const Controller* shown = workspace_.ShownController();
  if (shown == nullptr || !FitsSearch(workspace_.Doc(), *shown)) {
    workspace_.Say(Tr("There is no motion to start from yet. Press Synthesize."));
    return false;
  }
  Begin(ShortClimb(), Source::kDocument, step);
  return Running();
}

bool SearchRun::CanImproveClip() const {
  return workspace_.SelectedClip() > 0 && workspace_.ShownController() != nullptr;
}

void SearchRun::ImproveClip() {
  if (!CanImproveClip()) {
    workspace_.Say(Tr("Only a clip that takes over from another one can be repaired."));
    return;
  }
  Document wanted = ShortClimb();
  const Controller& shown = *workspace_.ShownController();
  wanted.senses = shown.senses;
  wanted.rules = shown.rules;
  wanted.kind = shown.kind;
  wanted.search.in_place_of = workspace_.SelectedClip();
  Begin(std::move(wanted));
}

void SearchRun::Begin(Document wanted, Source source, UndoStep step) {
  if (lab_.Running()) {
    workspace_.Say(Tr("The lab is running: stop it first, or let it end."));
    return;
  }
  if (Running()) Stop();
  Prepare(std::move(wanted), source,
          step == UndoStep::kMotion ? workspace_.NewOccasion() : workspace_.Gesture());
  const Document& searched = job_->document;
  if (source == Source::kQueue) {
    workspace_.TheHost().StartQueued(searched, workers_, SearchTitle(searched) + ", " + SearchLine(searched));
  } else {
    workspace_.Notice().clear();
    workspace_.TheHost().StartSearch(searched, workers_);
  }
}

void SearchRun::Prepare(Document wanted, Source source, int occasion) {
  Forget();
  interrupted_ = false;
  job_ = {.document = std::move(wanted),
          .source = source,
          .clip = workspace_.SelectedClip(),
          .occasion = occasion};
  const Document& searched = job_->document;
  progress_ = {.state = SearchState::kRunning,
               .budget = searched.search.evaluations,
               .workers = workers_,
               .curve = {},
               .best_genome = {}};
  title_ = Tr("{1}, {2}, seed {3}", SearchTitle(searched), AlgorithmName(searched.search.algorithm),
              std::to_string(searched.search.seed));
  if (source == Source::kQueue) title_ = Tr("Queue: {1}", title_);
  spread_.Begin(progress_.budget);
  shown_for_s_ = kAtOnceS;
  if (ShowsImprovements()) before_ = workspace_.Doc();
}

void SearchRun::Adopt(Document searched, SearchProgress done, int occasion) {
  Prepare(std::move(searched), Source::kDocument, occasion);
  OnProgress(std::move(done));
}

bool SearchRun::WouldRepeat() const {
  const Document& document = workspace_.Doc();
  // Asked in every frame, so what is cheap to compare comes first.
  std::optional<Document> now;
  return std::ranges::any_of(ended_, [&](const Document& ended) {
    if (ended.search.seed != document.search.seed || ended.figure.name != document.figure.name ||
        ended.search.algorithm != document.search.algorithm || ended.task.kind != document.task.kind)
      return false;
    if (!now) now = SearchOf(document);
    return DifferingParts(ended, *now).Empty();
  });
}

void SearchRun::Pause() {
  if (Running()) workspace_.TheHost().PauseSearch();
}

void SearchRun::Resume() {
  if (Running()) workspace_.TheHost().ResumeSearch();
}

void SearchRun::Stop() {
  workspace_.TheHost().StopSearch();
  progress_.state = SearchState::kStopped;
  ShowImprovement(kAtOnceS);
  RecordResult();
}

void SearchRun::Abandon() {
  if (RunsQueued()) {
    job_->hidden = true;
    improvement_.clear();
    return;
  }
  if (Running()) {
    Stop();
    interrupted_ = true;
  }
  Forget();
}

void SearchRun::Forget() {
  job_.reset();
  improvement_.clear();
}

void SearchRun::ForgetProgress() {
  if (RunsQueued()) return;  // the queue's search continues in the background
  progress_ = {};
  spread_.Begin(1);
}

void SearchRun::OnProgress(SearchProgress progress) {
  if (!job_) return;  // a report of a search whose document was replaced
  const bool ended = progress.state == SearchState::kDone || progress.state == SearchState::kStopped ||
                     progress.state == SearchState::kFailed;
  if (progress.state == SearchState::kFailed) {
    // A failed search reports no numbers: keep those of its last report.
    progress = progress_;
    progress.state = SearchState::kFailed;
  }
  if (!progress.best_genome.empty() && progress.best_genome != progress_.best_genome) {
    improvement_ = progress.best_genome;
  } else if (progress.best_genome.empty()) {
    progress.best_genome = progress_.best_genome;
  }
  const bool first_end = ended && Running();
  progress_ = std::move(progress);
  if (progress_.spread) spread_.Add(progress_.evaluations, *progress_.spread);
  if (!ended) return;
  ShowImprovement(kAtOnceS);
  RecordResult();
  if (progress_.state == SearchState::kDone) {
    if (ended_.size() == kEndedKept) ended_.erase(ended_.begin());
    ended_.push_back(SearchOf(job_->document));
  }
  if (auto map = EliteMap::Of(job_->document, progress_.saved)) elites_ = std::move(map);
  if (auto front = FrontMap::Of(job_->document, progress_.saved)) front_ = std::move(front);
  progress_.saved.clear();
  const std::string of_queue = job_->source == Source::kQueue ? SearchTitle(job_->document) : "";
  const std::string found = job_->found;
  Forget();
  // A search that a person stops makes its final report later.
  if (first_end || progress_.state == SearchState::kStopped) ReportEnd(of_queue, found);
  if (!first_end) return;
  // Report at once, not with the next frame: a hidden tab has no frames.
  if (progress_.state != SearchState::kStopped) followers_.ended();
}

// @param of_queue the title of a search of the queue, or empty. @param found the id of the result, or empty
void SearchRun::ReportEnd(const std::string& of_queue, const std::string& found) {
  if (progress_.state == SearchState::kFailed) {
    workspace_.Say(of_queue.empty() ? Tr("The search failed.") : Tr("{1}: the search failed.", of_queue));
    return;
  }
  const bool done = progress_.state == SearchState::kDone;
  const FoundMotions::Entry* entry = results_.Motions().Find(found);
  std::string best;
  if (entry != nullptr && entry->motion.Moves()) {
    best = ReachedWords(entry->motion.document.task.kind, entry->motion.terms);
  } else {
    best = progress_.best_fitness > kVoidScore ? Tr("best {1}", Fixed(progress_.best_fitness, 2))
                                               : Tr("nothing found");
  }
  workspace_.TheHost().Status(
      (of_queue.empty() ? "" : of_queue + ": ") +
      Tr(done ? "Search done: {1} after {2} tries" : "Search stopped: {1} after {2} tries", best,
         Grouped(progress_.evaluations)));
}

// Called at the end of a search, and again when a stopped search makes its final report.
void SearchRun::RecordResult() {
  if (!job_) return;
  const auto id = results_.AddFound(job_->document, progress_, job_->found);
  if (!id) return;
  job_->found = *id;
  followers_.found(*id);
}

// A search of the queue improves the open document only if the document's own search is the same.
bool SearchRun::ShowsImprovements() const {
  if (!job_) return false;
  if (job_->source != Source::kQueue) return true;
  return !job_->hidden && workspace_.Doc().timeline.size() < 2 && job_->document.search.start < 0 &&
         SameSearch(workspace_.Doc(), job_->document);
}

bool SearchRun::HasChangedNothing() const {
  if (!Running() || !job_ || job_->source == Source::kQueue || !improvement_.empty()) return false;
  return SameParts(before_, workspace_.Doc(), AllParts().Without(Part::kView));
}

bool SearchRun::IsDisturbedBy(const Document& next) const {
  const Document& now = workspace_.Doc();
  if (!Running() || !job_ || job_->source == Source::kQueue) return false;
  if (next.timeline.size() != now.timeline.size() || next.timeline.empty()) return true;
  const auto clip = std::min(static_cast<std::size_t>(job_->clip), next.timeline.size() - 1);
  const auto genes = [clip](const Document& d) -> const Genome& {
    return d.controllers[static_cast<std::size_t>(d.timeline[clip].controller)].genes;
  };
  if (genes(next) != genes(now)) return true;
  // A repair is scored from where the clip took over, for the length of the clip.
  return job_->document.search.in_place_of >= 0 && PartingStep(next, now) < EndOf(now, clip);
}

bool SearchRun::ShowImprovement(double seconds) {
  // Shortest time between improvements on the screen [s]: a new motion every frame would be unreadable.
  constexpr double kShortestShow = 0.5;
  shown_for_s_ += seconds;
  if (improvement_.empty() || shown_for_s_ < kShortestShow || !job_) return false;
  shown_for_s_ = 0.0;
  Genome genes = std::exchange(improvement_, {});
  if (!ShowsImprovements()) return false;
  ShowGenome(std::move(genes));
  return true;
}

// Gives the searched clip this genome's controller. Other clips keep theirs, and controllers without a clip
// are removed.
void SearchRun::ShowGenome(Genome genes) {
  const bool first = workspace_.Doc().timeline.empty();
  auto next = workspace_.Edited([&](Document& d) {
    d.controllers.push_back(TakeFound(job_->document, std::move(genes), d));
    const int added = static_cast<int>(d.controllers.size()) - 1;
    if (d.timeline.empty()) d.timeline.push_back({0, 0});
    const int clip = std::clamp(job_->clip, 0, static_cast<int>(d.timeline.size()) - 1);
    const int old = std::exchange(d.timeline[static_cast<std::size_t>(clip)].controller, added);
    if (d.timeline.size() == 1) d.duration_steps = job_->document.task.duration_steps;
    // If the replaced controller was the start of the search, its replacement becomes the start.
    const bool replaced =
        std::ranges::none_of(d.timeline, [&](const Clip& c) { return c.controller == old; });
    if (d.search.start == old && replaced) d.search.start = added;
    DropUnusedControllers(d);
    d.title = FoundTitle(d.figure.name, job_->document);
  });
  if (!next) return;
  const auto clip = std::min(static_cast<std::size_t>(std::max(job_->clip, 0)), next->timeline.size() - 1);
  const int shown = next->timeline[clip].controller;
  next->controllers[static_cast<std::size_t>(shown)].name = MotionName(*next, shown, next->controllers);
  followers_.shown(job_->document, job_->source, next->controllers[static_cast<std::size_t>(shown)]);
  workspace_.Notice().clear();
  workspace_.Remember(job_->occasion);
  next->hash.reset();
  workspace_.Show(std::move(*next), false);
  // Undoing a drag must not lose what the search found during the drag.
  workspace_.BeginGesture();
  if (first) workspace_.Player().Present();
}

}  // namespace gaitsmith::shell
