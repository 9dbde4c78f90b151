// SPDX-License-Identifier: MIT
// The running search: its problem, its progress, its results, and how its best motion replaces the shown one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shell/results/elite_map.h"
#include "shell/results/front_map.h"
#include "shell/results/lab.h"
#include "shell/results/result_store.h"
#include "shell/results/spread_curve.h"
#include "shell/search/search_progress.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class SearchRun {
 public:
  /// Evaluations of the short climbs that TryStyle and ImproveClip run.
  static constexpr int kTryEvaluations = 4000;
  /// Where a search comes from.
  enum class Source { kDocument, kScript, kQueue };

  /// @param lab  no search can run while the lab runs
  SearchRun(Workspace&, const Lab& lab, ResultStore&);

  struct Followers {
    /// Called when a search shows a better controller.
    std::function<void(const Document& searched, Source, const Controller&)> shown;
    /// Called when a search has ended, with the id of its result.
    std::function<void(const std::string& id)> found;
    /// Called when a search has ended by itself, so that the next one may start.
    std::function<void()> ended;
  };
  void SetFollowers(Followers followers) { followers_ = std::move(followers); }

  /// What Undo takes back together with a search's motion.
  enum class UndoStep { kMotion, kMotionAndGesture };  // nothing else, or what the present gesture changed
  /// Starts the open document's own search.
  void Synthesize(UndoStep step = UndoStep::kMotion) { Begin(workspace_.Doc(), Source::kDocument, step); }
  void SynthesizeForScript() { Begin(workspace_.Doc(), Source::kScript); }
  /// Whether that search has run to its end before, and would find the same motion again.
  [[nodiscard]] bool WouldRepeat() const;
  /// Runs a short climb from the shown motion, in the chosen style. @return whether it runs
  bool TryStyle(UndoStep = UndoStep::kMotion);
  /// Runs a short climb that improves the selected clip's controller from the state in which the clip before
  /// it leaves the figure. Refused, with a sentence, unless CanImproveClip.
  void ImproveClip();
  [[nodiscard]] bool CanImproveClip() const;
  /// Stops the running search and starts this one. Refused, with a sentence, while the lab runs. @param
  /// wanted valid
  void Begin(Document wanted, Source source = Source::kDocument, UndoStep = UndoStep::kMotion);
  /// Takes over a search that ran elsewhere to its end, as if it had run here. Only while none runs.
  /// @param occasion  of Undo, see Workspace::NewOccasion
  void Adopt(Document searched, SearchProgress done, int occasion);
  void Pause();
  void Resume();
  /// Stops the running search and keeps its result.
  void Stop();
  /// Ends the document's search before the document is replaced. A search of the queue continues, but is no
  /// longer shown.
  void Abandon();
  /// Whether an edit that leads to `next` changes the problem of the document's own search.
  [[nodiscard]] bool IsDisturbedBy(const Document& next) const;
  /// Ignores further reports: they belong to a document that was replaced.
  void Forget();
  /// Clears the numbers of the last search, which belong to another document.
  void ForgetProgress();

  void OnProgress(SearchProgress);
  /// Shows the best motion found so far if the previous one was visible long enough.
  /// @param seconds since the last call @return whether it showed one
  bool ShowImprovement(double seconds);

  [[nodiscard]] bool Running() const {
    return progress_.state == SearchState::kRunning || progress_.state == SearchState::kPaused;
  }
  /// Whether a search or the lab runs.
  [[nodiscard]] bool Busy() const { return Running() || lab_.Running(); }
  /// Whether the running search came from the queue. Stopping, undoing or opening in the open document does
  /// not affect such a search.
  [[nodiscard]] bool RunsQueued() const { return Running() && job_ && job_->source == Source::kQueue; }
  /// The document of the running search; null if none runs.
  [[nodiscard]] const Document* Searched() const { return Running() && job_ ? &job_->document : nullptr; }
  /// Whether the running search started with this clip selected.
  [[nodiscard]] bool Improves(int clip) const { return Running() && job_ && job_->clip == clip; }
  /// Whether improvements of the search are shown.
  [[nodiscard]] bool ShowsImprovements() const;
  /// Whether the document's own search has found nothing so far and the document is unchanged since it
  /// started.
  [[nodiscard]] bool HasChangedNothing() const;
  /// Whether a search was stopped because its document was replaced, and no other has started since.
  [[nodiscard]] bool WasInterrupted() const { return interrupted_; }
  void ClearInterruption() { interrupted_ = false; }

  [[nodiscard]] const SearchProgress& Progress() const { return progress_; }
  /// The search in one line: "Mr. Star-Man · travel, SPHC, seed 3"; a search of the queue is marked as such.
  [[nodiscard]] const std::string& Title() const { return title_; }
  /// The population's spread over the present or last search.
  [[nodiscard]] const SpreadCurve& PopulationSpread() const { return spread_; }
  /// The map of styles of the last search for a map, MAP-Elites or CMA-MAE.
  [[nodiscard]] const std::optional<EliteMap>& Elites() const { return elites_; }
  /// The front of the last NSGA-II search.
  [[nodiscard]] const std::optional<FrontMap>& Front() const { return front_; }
  /// The document as it was before the last search that was shown.
  [[nodiscard]] const Document& Before() const { return before_; }

  /// Number of threads or workers of the next search, [1, MaxWorkers()].
  [[nodiscard]] int Workers() const { return workers_; }
  void SetWorkers(int workers) { workers_ = workers; }
  [[nodiscard]] int MaxWorkers() const { return workspace_.TheHost().MaxWorkers(); }

 private:
  struct Job {
    Document document;  // as it was when the search began
    Source source = Source::kDocument;
    int clip = 0;            // the clip that the search improves
    int occasion = 0;        // all its improvements are one step of Undo
    bool hidden = false;     // a search of the queue whose improvements are no longer shown
    std::string found = {};  // id of its result; empty: none yet
  };
  [[nodiscard]] Document ShortClimb() const;
  void Prepare(Document wanted, Source, int occasion);
  void ShowGenome(Genome);
  void RecordResult();
  void ReportEnd(const std::string& of_queue, const std::string& found);

  Workspace& workspace_;
  const Lab& lab_;
  ResultStore& results_;
  Followers followers_;
  int workers_;
  std::optional<Job> job_;  // empty: reports are ignored
  SearchProgress progress_;
  std::string title_;
  SpreadCurve spread_;
  std::optional<EliteMap> elites_;
  std::optional<FrontMap> front_;
  Document before_;
  std::vector<Document> ended_;  // the latest searches that ran to their end
  Genome improvement_;           // found, not shown yet
  double shown_for_s_ = 0.0;
  bool interrupted_ = false;
};

}  // namespace gaitsmith::shell
