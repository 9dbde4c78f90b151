// SPDX-License-Identifier: MIT
// What is open and what may be done to it: the document, its playback, the search that improves it. Panels
// read it and ask it for changes; it validates, simulates anew, and tells the host.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/host.h"
#include "shell/lab.h"
#include "shell/playback.h"

namespace gaitsmith::shell {

class Session {
 public:
  explicit Session(Host& host);

  // Opening. The text is JSON, or a link, or the payload of one.
  [[nodiscard]] Result<void> Open(std::string_view text);
  [[nodiscard]] const Document& Doc() const { return document_; }
  /// With the present motion's hash, as it is saved and shared.
  [[nodiscard]] Document WithHash() const;
  /// The document says what its maker saw, and the motion here is another one.
  [[nodiscard]] bool DiffersFromMaker() const { return differs_from_maker_; }

  // Changing.
  using Edit = std::function<void(Document&)>;
  /// Changes something that the motion depends on. An invalid result is refused with a sentence for the
  /// reader.
  bool Change(const Edit& edit);
  /// Changes settings of the next search, which the motion does not depend on.
  bool Set(const Edit& edit);
  /// Changes what is shown and how, which Undo leaves alone.
  void SetView(const std::function<void(View&)>& edit);
  /// The person (or a script) begins to do something new: a press, a key. The first change after it keeps the
  /// document as it was for Undo, so that a whole drag is undone at once.
  void BeginGesture() { ++gesture_; }
  [[nodiscard]] bool CanUndo() const { return remembered_.has_value(); }
  void Undo();

  // The figure.
  /// Another figure: controllers that do not fit are dropped, with a sentence that says so.
  bool ReplaceFigure(const Figure& figure);
  [[nodiscard]] const std::vector<Figure>& Figures() const { return figures_; }
  void ChooseFigure(int index);
  /// Shipped ones: a figure with a task and senses that go well together.
  [[nodiscard]] const std::vector<Document>& Problems() const { return problems_; }
  void ChooseProblem(int index);

  // The timeline. One clip is selected: its controller is shown, and a search replaces it.
  [[nodiscard]] int SelectedClip() const { return selected_clip_; }
  void SelectClip(int clip);
  [[nodiscard]] const Controller* ShownController() const;
  /// Changes the shown controller in place, by hand: its name says so from then on, a search that would
  /// replace it ends, and settings of the next search that were this controller's number of rules stay so.
  bool ChangeController(const std::function<void(Controller&)>& edit);
  void AddClip();
  void RemoveClip();
  void MoveClip(int clip, int start_step);
  /// Task, senses and length of the motion belong together while there is only one clip.
  void SetDuration(int steps);

  // The search.
  void Synthesize();
  void Pause() {
    if (Searching()) host_.PauseSearch();
  }
  void Resume() {
    if (Searching()) host_.ResumeSearch();
  }
  /// Ends the search, or the lab.
  void Stop();
  void OnSearchProgress(SearchProgress progress);
  [[nodiscard]] const SearchProgress& Progress() const { return progress_; }
  [[nodiscard]] bool Searching() const {
    return progress_.state == SearchState::kRunning || progress_.state == SearchState::kPaused;
  }
  /// Shows the best motion found so far, when the last one has been on the screen for a moment. @return true
  /// if it did
  bool ShowImprovement(double seconds);
  int workers = 1;

  // The lab: many searches for the present document's problem, of which only the curves are kept. It and the
  // search exclude each other.
  Lab lab;
  /// Runs the lab with these settings; one that runs is stopped first. Refused while a search runs.
  [[nodiscard]] Result<void> StartLab(const LabSettings&);
  /// The same with the settings on the panel, and the notice says what speaks against it.
  void StartLab();
  void StopLab();
  void SaveLabCurves();

  Playback player;
  std::string notice;  // the last thing the reader should know, or empty

  [[nodiscard]] Host& Place() { return host_; }

 private:
  void Show(Document document, bool start_over);
  void Say(std::string sentence);
  void Remember();
  /// The present document after an edit, or nothing and a sentence when that is invalid.
  [[nodiscard]] std::optional<Document> Edited(const Edit& edit);
  /// Ends the search for good: what it still reports belongs to a document that is no longer here.
  void AbandonSearch();
  void PutController(Controller controller);
  void RunTrial();
  void OnTrialProgress(const SearchProgress&);
  void EndLab(LabState);

  Host& host_;
  Document document_;  // its hash: as its maker saw it, until something that the motion depends on changes
  bool differs_from_maker_ = false;
  std::optional<Document> remembered_;
  int gesture_ = 1;
  int remembered_gesture_ = 0;  // the one that `remembered_` was kept in
  std::vector<Figure> figures_;
  std::vector<Document> problems_;
  int selected_clip_ = 0;
  SearchProgress progress_;
  std::optional<Document> searched_;  // the document as it was when the search began; empty: none is wanted
  int searched_clip_ = 0;             // the clip that it improves
  Genome improvement_;                // found, not shown yet
  double shown_for_s_ = 0.0;
};

/// What decides: a clock, the physical senses, or a network of sensors.
enum class Decider { kTimer, kSenses, kNetwork };
[[nodiscard]] Decider DeciderOf(const Document&);
/// Of the next search.
void Decide(Document&, Decider);

/// "10 rules with physical senses", "10 rules with timer 0.80 s", "a network of 10 hidden nodes".
[[nodiscard]] std::string ControllerWords(ControllerKind, const SenseSpec&, int rules);
/// What the task rewards, e.g. "travel".
[[nodiscard]] std::string TaskWords(TaskKind);

}  // namespace gaitsmith::shell
