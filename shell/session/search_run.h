// SPDX-License-Identifier: MIT
// The search that runs: what it looks for, how far it has come, what it has found, and how its best motion
// takes the place of the one on the stage.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "shell/search/search_progress.h"
#include "shell/session/elite_map.h"
#include "shell/session/lab.h"
#include "shell/session/result_store.h"
#include "shell/session/spread_curve.h"
#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class SearchRun {
 public:
  /// Evaluations of the short climbs that TryStyle and ImproveClip run.
  static constexpr int kTryEvaluations = 4000;
  /// Whose search it is.
  enum class Source { kDocument, kQueue };

  /// @param lab  excludes a search while it runs
  SearchRun(Workspace&, const Lab& lab, ResultStore&);

  struct Followers {
    /// A search has ended; what it found has this id among the results.
    std::function<void(const std::string& id)> found;
    /// A search has ended by itself: the next one may begin.
    std::function<void()> ended;
  };
  void SetFollowers(Followers followers) { followers_ = std::move(followers); }

  /// The open document's own search.
  void Synthesize() { Begin(workspace_.Doc()); }
  /// A short climb from the shown motion, in the style that is set. @return whether it runs
  bool TryStyle();
  /// A short climb that makes the selected clip's controller better from where the clip before it leaves the
  /// figure. Refused, with a sentence, unless CanImproveClip.
  void ImproveClip();
  [[nodiscard]] bool CanImproveClip() const;
  /// Stops what runs. Refused, with a sentence, while the lab runs. @param wanted valid
  void Begin(Document wanted, Source source = Source::kDocument);
  void Pause();
  void Resume();
  /// Keeps what was found. There is a search that runs.
  void Stop();
  /// The document goes away: its search ends for good. One of the queue goes on, off the stage.
  void Abandon();
  /// After an edit that leads to `next` the document's own search would look for something else than what is
  /// there.
  [[nodiscard]] bool IsDisturbedBy(const Document& next) const;
  /// What it still reports belongs to a document that is no longer here.
  void Forget();
  /// The numbers of the last search, which belong to another document.
  void ForgetProgress();

  void OnProgress(SearchProgress);
  /// Shows the best motion found so far, when the last one has been on the screen for a moment.
  /// @param seconds since the last call @return true if it did
  bool ShowImprovement(double seconds);

  [[nodiscard]] bool Running() const {
    return progress_.state == SearchState::kRunning || progress_.state == SearchState::kPaused;
  }
  /// What runs came from the queue: stopping, undoing and opening in the open document do not concern it.
  [[nodiscard]] bool RunsQueued() const { return Running() && job_ && job_->source == Source::kQueue; }
  /// What the running search looks for; null: none runs.
  [[nodiscard]] const Document* Searched() const { return Running() && job_ ? &job_->document : nullptr; }
  /// Whether the search that runs began with this clip selected.
  [[nodiscard]] bool Improves(int clip) const { return Running() && job_ && job_->clip == clip; }
  /// What it finds is shown.
  [[nodiscard]] bool BelongsOnStage() const;
  /// Its own search has found nothing so far, and the document is as it was when that began.
  [[nodiscard]] bool HasChangedNothing() const;
  /// A search was stopped because its document went away, and since then nothing has taken its place.
  [[nodiscard]] bool WasInterrupted() const { return interrupted_; }
  void ClearInterruption() { interrupted_ = false; }

  [[nodiscard]] const SearchProgress& Progress() const { return progress_; }
  /// Whose it is, in one line: "Mr. Star-Man · travel, SPHC, seed 3"; of the queue with a word that says so.
  [[nodiscard]] const std::string& Title() const { return title_; }
  /// How the population of the present or last search scattered.
  [[nodiscard]] const SpreadCurve& PopulationSpread() const { return spread_; }
  /// The map of styles that the last MAP-Elites search has left.
  [[nodiscard]] const std::optional<EliteMap>& Elites() const { return elites_; }
  /// The document as it was before the last search that was shown.
  [[nodiscard]] const Document& Before() const { return before_; }

  /// Threads or workers of the next search, [1, MaxWorkers()].
  [[nodiscard]] int Workers() const { return workers_; }
  void SetWorkers(int workers) { workers_ = workers; }
  [[nodiscard]] int MaxWorkers() const { return workspace_.TheHost().MaxWorkers(); }

 private:
  struct Job {
    Document document;  // as it was when the search began
    Source source = Source::kDocument;
    int clip = 0;            // that it improves
    int occasion = 0;        // all that it finds is one step of Undo
    bool off_stage = false;  // of the queue, and what it finds is no longer wanted on the stage
    std::string found = {};  // its id among the results; empty: not there
  };
  [[nodiscard]] Document ShortClimb() const;
  void ShowController(Controller);
  void NoteFound();
  void ReportEnd(const std::string& of_queue);

  Workspace& workspace_;
  const Lab& lab_;
  ResultStore& results_;
  Followers followers_;
  int workers_;
  std::optional<Job> job_;  // empty: what is reported is nobody's
  SearchProgress progress_;
  std::string title_;
  SpreadCurve spread_;
  std::optional<EliteMap> elites_;
  Document before_;
  Genome improvement_;  // found, not shown yet
  double shown_for_s_ = 0.0;
  bool interrupted_ = false;
};

}  // namespace gaitsmith::shell
