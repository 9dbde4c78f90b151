// SPDX-License-Identifier: MIT
// A session: the open document, its history, and replacing it by another document. Each other concern is a
// part that owns its state: timeline, world, comparison, search, queue, results and lab.
//
// Dependencies go one way. All parts read and change the document through the workspace, and each part knows
// only those before it in this list: workspace, results, search, live, lab, queue, world, ground,
// teacher, comparison, timeline, keyframes, planning, gait. The session knows all parts and forwards events
// from earlier parts to later ones.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "shell/results/lab_run.h"
#include "shell/results/queue_run.h"
#include "shell/results/result_store.h"
#include "shell/results/search_run.h"
#include "shell/session/attempts.h"
#include "shell/session/gait_finder.h"
#include "shell/session/ground_editor.h"
#include "shell/session/live.h"
#include "shell/session/motion_comparison.h"
#include "shell/session/plan_editor.h"
#include "shell/session/plan_run.h"
#include "shell/session/provenance.h"
#include "shell/session/teacher.h"
#include "shell/session/timeline_editor.h"
#include "shell/session/world_editor.h"
#include "shell/workspace/shipped_documents.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

/// How the next try should differ from the shown motion.
enum class Manner { kCalmer, kQuicker, kHigher };

/// Whether a document comes from outside, or was bred from the open one.
enum class OpenedFrom { kOutside, kBreeding };

/// Whose goal the next search has after a motion is opened.
enum class NextGoal { kOwn, kOfOpen };

class Session {
 public:
  explicit Session(Host& host);

  // Parts of the session.
  [[nodiscard]] TimelineEditor& Timeline() { return timeline_; }
  [[nodiscard]] const TimelineEditor& Timeline() const { return timeline_; }
  [[nodiscard]] WorldEditor& World() { return world_; }
  [[nodiscard]] const WorldEditor& World() const { return world_; }
  [[nodiscard]] GroundEditor& Ground() { return ground_; }
  [[nodiscard]] const GroundEditor& Ground() const { return ground_; }
  [[nodiscard]] Teacher& Teaching() { return teacher_; }
  [[nodiscard]] const Teacher& Teaching() const { return teacher_; }
  [[nodiscard]] MotionComparison& Comparison() { return comparison_; }
  [[nodiscard]] const MotionComparison& Comparison() const { return comparison_; }
  [[nodiscard]] PlanEditor& Keyframes() { return keyframes_; }
  [[nodiscard]] const PlanEditor& Keyframes() const { return keyframes_; }
  [[nodiscard]] PlanRun& Planning() { return planning_; }
  [[nodiscard]] const PlanRun& Planning() const { return planning_; }
  [[nodiscard]] const GaitFinder& Gait() const { return gait_; }
  [[nodiscard]] SearchRun& Search() { return search_; }
  [[nodiscard]] const SearchRun& Search() const { return search_; }
  /// Of the running search, if its improvements are shown.
  [[nodiscard]] const Attempts& Tried() const { return attempts_; }
  [[nodiscard]] Live& Following() { return live_; }
  [[nodiscard]] const Live& Following() const { return live_; }
  [[nodiscard]] QueueRun& Queue() { return queue_; }
  [[nodiscard]] ResultStore& Results() { return results_; }
  [[nodiscard]] const ResultStore& Results() const { return results_; }
  [[nodiscard]] LabRun& Lab() { return lab_; }
  [[nodiscard]] const LabRun& Lab() const { return lab_; }
  [[nodiscard]] const ShippedDocuments& Shipped() const { return shipped_; }
  [[nodiscard]] const Provenance& Origins() const { return provenance_; }
  [[nodiscard]] Playback& Player() { return workspace_.Player(); }
  [[nodiscard]] const Playback& Player() const { return workspace_.Player(); }
  /// Visible panels and locked parts. Locks restrict a person's edits, not searches, scripts or opened
  /// documents.
  [[nodiscard]] Arrangement& Layout() { return workspace_.Layout(); }
  [[nodiscard]] const Arrangement& Layout() const { return workspace_.Layout(); }
  /// Whether the host has dialogs, for example to share.
  [[nodiscard]] bool HasDialogs() const { return workspace_.TheHost().HasDialogs(); }
  /// @param command  of the host, such as "document/share"
  void OpenDialog(const std::string& command) { workspace_.TheHost().OpenDialog(command); }
  /// The latest sentence for the reader, or empty.
  [[nodiscard]] std::string& Notice() { return workspace_.Notice(); }

  // The open document.
  [[nodiscard]] const Document& Doc() const { return workspace_.Doc(); }
  /// The document with the present motion's hash, as it is saved and shared.
  [[nodiscard]] Document WithHash() const { return workspace_.WithHash(); }
  /// Whether the motion here differs from the one that the document's maker saw.
  [[nodiscard]] bool DiffersFromMaker() const { return workspace_.DiffersFromMaker(); }

  // Edits.
  using Edit = Workspace::Edit;
  /// Changes something that the motion depends on. An invalid result is refused with a sentence for the
  /// reader.
  bool Change(const Edit& edit) { return workspace_.Change(edit); }
  /// Changes settings of the next search, which the motion does not depend on.
  bool Set(const Edit& edit) { return workspace_.Set(edit); }
  /// Changes the goal of the next search, which runs at once if Live is on.
  void ChangeGoal(const Edit& edit);
  /// Changes the view, which Undo ignores.
  void SetView(const std::function<void(View&)>& edit) { workspace_.SetView(edit); }
  /// Whether the controllers of a document would drive the figure in hand with another body than their own.
  [[nodiscard]] bool CanTryBrain(const Document& other) const;
  /// Lets the controllers of a result drive the figure in hand, whose body stays.
  void TryBrain(const std::string& id);
  /// Changes the figure: controllers that do not fit are removed, with a sentence that says so.
  bool ReplaceFigure(const Figure& figure);

  // History.
  /// Call when a person (or a script) begins an action: a click, a drag, a key. The first change after it
  /// saves the document for Undo, so that a whole drag is one step.
  void BeginGesture() { workspace_.BeginGesture(); }
  [[nodiscard]] bool CanUndo() const { return workspace_.CanUndo(); }
  [[nodiscard]] bool CanRedo() const { return workspace_.CanRedo(); }
  void Undo();
  void Redo();
  /// Makes the open document the last one that Undo reaches.
  void ForgetPast();

  // What a reload of a browser's tab would lose beside the document: Undo, Redo and the queue.
  /// As JSON: {"undo", "redo", "queue"}, lists of payloads of links, "simple", whether only the choices are
  /// shown, and "live", if a person switched it. The oldest steps are left out if the text would be too long
  /// to store. A running search of the queue comes first among the waiting ones.
  [[nodiscard]] std::string StoreVisit() const;
  /// @return false: the text is damaged, and nothing has changed
  bool RestoreVisit(std::string_view text);
  /// Restores a found motion of an earlier visit. @return its id; empty: the text is invalid
  std::string RestoreFound(std::string_view text);

  // Opening other documents. Undo restores the previous one.
  /// @param text JSON, or a link, or the payload of a link
  [[nodiscard]] Result<void> Open(std::string_view text, OpenedFrom from = OpenedFrom::kOutside);
  /// Shows the first document of a visit. There is nothing to undo.
  /// @param example  a shipped motion, such as "star-man-shuffle"; empty: a figure that cannot move yet
  /// @return false: there is no such motion
  bool Begin(std::string_view example);
  /// Whether the page offers only the three choices of a first visit, in place of all panels.
  [[nodiscard]] bool Simple() const { return simple_; }
  /// Shows all panels, or the three choices alone.
  void ShowAll(bool all = true) { simple_ = !all; }
  /// Whether a received motion is shown only to be watched and pushed, without panels and timeline.
  [[nodiscard]] bool Viewing() const { return viewing_ && !Doc().timeline.empty(); }
  void EnterViewer() { viewing_ = true; }
  /// Shows the choices of a first visit beside the open document.
  void LeaveViewer();
  /// Opens the figure of a first visit in place of the open document. If all panels are shown, Search is
  /// open.
  void New();
  /// Opens a shipped figure, standing still in the world of the open document, or a problem. @param index of
  /// Shipped()
  void ChooseFigure(int index);
  void ChooseProblem(int index);
  /// Opens a shipped motion.
  void ChooseExample(const Document& example);
  /// Opens a result, for a next search with its own goal or with that of the open document. @return false:
  /// there is no such motion
  bool ShowFound(const std::string& id, NextGoal = NextGoal::kOwn);
  /// Opens a motion of the map of styles.
  void ShowElite(Document motion);

  // Searches.
  /// Starts the open document's search. If it would find the same motion again, takes the next seed that
  /// none of the results has, unless the search is locked.
  void Synthesize();
  /// Opens the keyframes: those of the document, or a jump to begin with.
  void OpenKeyframes();
  /// Rules that imitate the planned motion replace it, and a search makes them better at it. One step of
  /// Undo. Refused, with a sentence, where nothing is planned.
  void TrackKeyframes();
  /// See TimelineEditor::RecordAsCurves.
  void RecordAsCurves();
  /// Runs a short climb from the shown motion in the chosen style, with the earlier motion as ghost.
  void TryStyle(SearchRun::UndoStep = SearchRun::UndoStep::kMotion);
  /// Changes a style weight so much that one sees it, then TryStyle: the weight of height by its usual
  /// amount, that of effort by three.
  void TryManner(Manner);
  /// Runs the open document's search with five further seeds, in the queue.
  void TryMore();
  /// Ends the search or the lab. Queued searches keep waiting.
  void Stop();
  /// Called by the host with the progress of a search or of a lab trial.
  void OnSearchProgress(SearchProgress progress);
  /// Call once a frame. @param seconds  since the last call @return true if a new frame is due
  bool Advance(double seconds);

 private:
  /// Replaces the document. Undo restores it. @return false, with a sentence: a part is locked
  /// @param same_problem  another motion of the open problem, whose controllers do not count as edited by
  /// hand
  bool Replace(Document document, bool same_problem = false);
  /// The open document, all results and all waiting searches: a further try differs from each of them.
  [[nodiscard]] std::vector<Document> KnownSearches() const;
  /// Plays the shown motion if nothing moved before it. @param rested  the document before had no motion
  void WakeFrom(bool rested);
  /// The open document's search has ended: its motion plays from the start, its last attempts beside it.
  void ShowEnd();
  /// @param words a pattern for the sentence that names the action
  void Return(const Document& document, const char* words);

  Workspace workspace_;
  ResultStore results_;
  LabRun lab_;
  SearchRun search_;
  Live live_;
  QueueRun queue_;
  WorldEditor world_;
  GroundEditor ground_;
  Teacher teacher_;
  MotionComparison comparison_;
  TimelineEditor timeline_;
  PlanEditor keyframes_;
  PlanRun planning_;
  GaitFinder gait_;
  Attempts attempts_;
  ShippedDocuments shipped_;
  Provenance provenance_;
  bool simple_ = false;
  bool viewing_ = false;
  double now_s_ = 1.0;     // time during which the motion played
  double frame_s_ = 0.01;  // time between frames, smoothed
};

}  // namespace gaitsmith::shell
