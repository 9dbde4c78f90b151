// SPDX-License-Identifier: MIT
// A session: the open document, its history, and how another document takes its place. What else is done with
// it has a part of its own, which owns its state: the timeline, the world, the comparison, the search, the
// queue, the results and the lab.
//
// Data flows one way. All parts read and change the document through the workspace; a part knows those before
// it in this list, and none after it: workspace, results, search, lab, queue, world, comparison, timeline.
// Only the session, which knows them all, leads back what one of the first causes in one of the last.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "shell/session/lab_run.h"
#include "shell/session/motion_comparison.h"
#include "shell/session/queue_run.h"
#include "shell/session/result_store.h"
#include "shell/session/search_run.h"
#include "shell/session/shipped_documents.h"
#include "shell/session/timeline_editor.h"
#include "shell/session/workspace.h"
#include "shell/session/world_editor.h"

namespace gaitsmith::shell {

class Session {
 public:
  explicit Session(Host& host);

  // The parts.
  [[nodiscard]] TimelineEditor& Timeline() { return timeline_; }
  [[nodiscard]] const TimelineEditor& Timeline() const { return timeline_; }
  [[nodiscard]] WorldEditor& World() { return world_; }
  [[nodiscard]] const WorldEditor& World() const { return world_; }
  [[nodiscard]] MotionComparison& Comparison() { return comparison_; }
  [[nodiscard]] const MotionComparison& Comparison() const { return comparison_; }
  [[nodiscard]] SearchRun& Search() { return search_; }
  [[nodiscard]] QueueRun& Queue() { return queue_; }
  [[nodiscard]] ResultStore& Results() { return results_; }
  [[nodiscard]] const ResultStore& Results() const { return results_; }
  [[nodiscard]] LabRun& Lab() { return lab_; }
  [[nodiscard]] const ShippedDocuments& Shipped() const { return shipped_; }
  [[nodiscard]] Playback& Player() { return workspace_.Player(); }
  [[nodiscard]] const Playback& Player() const { return workspace_.Player(); }
  /// What is shown, and what a person cannot change by hand: searches, scripts and opened documents can.
  [[nodiscard]] Arrangement& Layout() { return workspace_.Layout(); }
  /// The last thing the reader should know, or empty.
  [[nodiscard]] std::string& Notice() { return workspace_.Notice(); }

  // The open document.
  [[nodiscard]] const Document& Doc() const { return workspace_.Doc(); }
  /// With the present motion's hash, as it is saved and shared.
  [[nodiscard]] Document WithHash() const { return workspace_.WithHash(); }
  /// The document says what its maker saw, and the motion here is another one.
  [[nodiscard]] bool DiffersFromMaker() const { return workspace_.DiffersFromMaker(); }

  // Changing it.
  using Edit = Workspace::Edit;
  /// Changes something that the motion depends on. An invalid result is refused with a sentence for the
  /// reader.
  bool Change(const Edit& edit) { return workspace_.Change(edit); }
  /// Changes settings of the next search, which the motion does not depend on.
  bool Set(const Edit& edit) { return workspace_.Set(edit); }
  /// Changes what is shown and how, which Undo leaves alone.
  void SetView(const std::function<void(View&)>& edit) { workspace_.SetView(edit); }
  /// Another figure: controllers that do not fit are dropped, with a sentence that says so.
  bool ReplaceFigure(const Figure& figure);

  // History.
  /// The person (or a script) begins to do something new: a press, a key. The first change after it keeps the
  /// document as it was for Undo, so that a whole drag is undone at once.
  void BeginGesture() { workspace_.BeginGesture(); }
  [[nodiscard]] bool CanUndo() const { return workspace_.CanUndo(); }
  [[nodiscard]] bool CanRedo() const { return workspace_.CanRedo(); }
  void Undo();
  void Redo();
  /// What is open now is where Undo ends.
  void ForgetPast();

  // Another document, which Undo takes back.
  /// The text is JSON, or a link, or the payload of one.
  [[nodiscard]] Result<void> Open(std::string_view text);
  /// The standard figure, standing still.
  void New();
  /// A figure or a problem that is shipped. @param index of Shipped()
  void ChooseFigure(int index);
  void ChooseProblem(int index);
  /// A shipped motion to look at.
  void ChooseExample(const Document& example);
  /// A result, as it was found. @return false: there is no such motion
  bool ShowFound(const std::string& id);
  /// A motion of the map of styles.
  void ShowElite(Document motion);

  // What runs.
  /// A short climb from the shown motion, in the style that is set; the ghost is what it was before.
  void TryStyle();
  /// Ends the search, or the lab. The queue goes on waiting.
  void Stop();
  /// The host reports here, of a search or of a trial of the lab.
  void OnSearchProgress(SearchProgress progress);

 private:
  /// Another document in the place of this one, which Undo takes back. @return false, with a sentence: it is
  /// locked
  /// @param same_problem  it is another motion of the open problem, and so no edit of its controllers by hand
  bool Replace(Document document, bool same_problem = false);
  /// @param words a pattern for what is done
  void Return(const Document& document, const char* words);

  Workspace workspace_;
  ResultStore results_;
  LabRun lab_;
  SearchRun search_;
  QueueRun queue_;
  WorldEditor world_;
  MotionComparison comparison_;
  TimelineEditor timeline_;
  ShippedDocuments shipped_;
};

}  // namespace gaitsmith::shell
