// SPDX-License-Identifier: MIT
// Searching on while a person changes a weight, the goal, the ground, gravity or a limb. During a drag the
// stage shows a preview: the best motion so far for what is set now, which depends on how fast the machine
// is. The end does not: when the person lets go, a search with a fixed budget and seed begins with the
// document's own motion, and what it finds belongs to the document. Undo takes back the drag and that motion
// in one step.
#pragma once

#include <optional>

#include "core/document/parts.h"
#include "shell/results/search_run.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class Live {
 public:
  /// What is searched anew after a change.
  static constexpr Parts kWatched = {Part::kModel, Part::kFigure, Part::kEnvironment, Part::kGoal};
  /// Evaluations of the search that makes the document, and of each one for the preview.
  static constexpr int kEvaluations = 2000;
  static constexpr int kPreviewEvaluations = 600;

  Live(Workspace& workspace, SearchRun& search) : workspace_(workspace), search_(search) {}

  /// Unless a person chose, on where all panels are shown, nothing is locked and the machine keeps up.
  [[nodiscard]] bool On() const;
  void Switch(bool on);
  /// What a person chose, if anything.
  [[nodiscard]] std::optional<bool> Chosen() const { return chosen_; }
  /// Whether there is one clip, whose motion can follow a change.
  [[nodiscard]] bool Possible() const { return workspace_.Doc().timeline.size() == 1; }
  /// Whether what the stage shows is not the document's motion yet.
  [[nodiscard]] bool Previewing() const { return workspace_.Previews(); }

  /// Call after an edit by hand. @param changed  the parts that it changed
  void OnEdit(Parts changed);
  /// Searches from nothing for the goal that was just changed: another goal may need another motion.
  void SearchAnew();
  /// @param held  whether a person holds a control, so that further changes will follow
  void Hold(bool held) { held_ = held; }
  /// Forgets what has changed: the document was replaced.
  void Drop();

  /// Whether reports of searches are for this part.
  [[nodiscard]] bool Searching() const { return runs_ != Run::kNothing; }
  void OnProgress(const SearchProgress&);
  /// Call once a frame. @param seconds  since the last call @return whether it showed another motion
  bool Advance(double seconds);

 private:
  enum class Run { kNothing, kPreview, kFinal };
  void StartPreview();
  void StartFinal(Document);
  /// A search from the shown controller. @param genes  in place of its own; empty: its own
  [[nodiscard]] Document Wanted(const Genome& genes, int evaluations) const;

  Workspace& workspace_;
  SearchRun& search_;
  std::optional<bool> chosen_;  // by a person
  bool held_ = false;
  bool changed_ = false;   // since the last search that made the document
  bool outdated_ = false;  // since the running preview began
  Run runs_ = Run::kNothing;
  Document searched_;         // of the running search
  int occasion_ = 0;          // of the change, for Undo
  int previews_ = 0;          // since the person took hold: their seeds
  Genome best_;               // for the preview, not shown yet
  double quiet_s_ = 0.0;      // since the last change
  double running_s_ = 0.0;    // since the running search began
  double shown_for_s_ = 1e9;  // since the last preview
  bool answered_ = true;      // whether the running search has reported
  int late_ = 0;              // searches in a row whose first report came too late
};

}  // namespace gaitsmith::shell
