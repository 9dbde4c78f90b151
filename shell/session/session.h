// SPDX-License-Identifier: MIT
// What is open and what may be done to it: the document, its playback, the search that improves it. Panels
// read it and ask it for changes; it validates, simulates anew, and tells the host.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/transition.h"
#include "shell/session/arrangement.h"
#include "shell/session/elite_map.h"
#include "shell/session/found_motions.h"
#include "shell/session/ghost.h"
#include "shell/session/history.h"
#include "shell/session/host.h"
#include "shell/session/lab.h"
#include "shell/session/playback.h"
#include "shell/session/search_queue.h"
#include "shell/session/spread_curve.h"
#include "shell/session/suite_plan.h"
#include "shell/session/transition_scores.h"

namespace gaitsmith::shell {

class Session {
 public:
  explicit Session(Host& host);

  // Opening. The text is JSON, or a link, or the payload of one.
  [[nodiscard]] Result<void> Open(std::string_view text);
  /// The standard figure, standing still.
  void New();
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
  /// What is shown, and what a person cannot change by hand: searches, scripts and opened documents can.
  Arrangement arrangement;
  /// Changes what is shown and how, which Undo leaves alone.
  void SetView(const std::function<void(View&)>& edit);
  /// The person (or a script) begins to do something new: a press, a key. The first change after it keeps the
  /// document as it was for Undo, so that a whole drag is undone at once.
  void BeginGesture() { gesture_ = ++occasions_; }
  [[nodiscard]] bool CanUndo() const { return history_.CanUndo(document_); }
  [[nodiscard]] bool CanRedo() const { return history_.CanRedo(); }
  void Undo();
  void Redo();
  /// What is open now is where Undo ends.
  void ForgetPast();

  // The figure.
  /// Another figure: controllers that do not fit are dropped, with a sentence that says so.
  bool ReplaceFigure(const Figure& figure);
  [[nodiscard]] const std::vector<Figure>& Figures() const { return figures_; }
  void ChooseFigure(int index);
  /// Shipped ones: a figure with a task and senses that go well together.
  [[nodiscard]] const std::vector<Document>& Problems() const { return problems_; }
  void ChooseProblem(int index);
  /// Shipped motions to look at.
  void ChooseExample(const Document& example);

  // The timeline. One clip is selected: its controller is shown, and a search replaces it.
  [[nodiscard]] int SelectedClip() const { return selected_clip_; }
  void SelectClip(int clip);
  [[nodiscard]] const Controller* ShownController() const;
  /// Changes the shown controller in place, by hand: its name says so from then on, a search that would
  /// replace it ends, and settings of the next search that were this controller's number of rules stay so.
  bool ChangeController(const std::function<void(Controller&)>& edit);
  // Editing them; what cannot be done is said, and changes nothing. Lengths travel with their clips.
  /// The selected clip once more, at the end.
  void AddClip();
  void RemoveClip();
  /// Moves the border before a clip; clips behind it stay where they are.
  void MoveClip(int clip, int start_step);
  void SetClipLength(int clip, int steps);
  /// Cuts the clip in charge at the moment that is shown.
  void SplitClip();
  void DuplicateClip();
  /// The selected clip goes the other way.
  void MirrorClip();
  /// The selected clip goes to this place among all.
  void ReorderClip(int to);
  /// The whole timeline once more behind itself.
  void LoopTimeline();
  /// A found motion takes over at the moment that is shown, all its clips.
  /// @param step  or there instead
  /// @return false: there is no such motion, or it does not fit
  bool InsertFound(const std::string& id, std::optional<int> step = {});
  /// A short search makes the selected clip's controller better from where the clip before it leaves the
  /// figure.
  void RepairClip();
  /// How near the figure is to the usual motion of the selected clip's controller when that takes over;
  /// nothing for the first clip.
  [[nodiscard]] std::optional<Nearness> NearnessAtHandover();
  /// How well the selected clip would do if it took over at other moments. Begins anew, a moment after the
  /// last change, when something else than the clip's own beginning has changed; and waits while a search
  /// changes the motion.
  [[nodiscard]] const TransitionScores& Transitions() const { return transitions_; }
  /// Once a frame. @param seconds since the last one
  void FollowTransitions(double seconds);
  void OnTransitions(const TransitionPart&);
  void OnTransitionsFailed(int generation);
  /// The selected clip takes over at the best moment of its map. Refused, with a sentence, while WhyNoSnap
  /// has one.
  void SnapToBest();
  /// @return translated; empty: it is possible
  [[nodiscard]] const char* WhyNoSnap() const;
  [[nodiscard]] bool CanRepair() const { return selected_clip_ > 0 && ShownController() != nullptr; }
  /// Task, senses and length of the motion belong together while there is only one clip.
  void SetDuration(int steps);

  // The world. What a person does to it is part of the document, so that a link carries it.
  /// An impulse on an endpoint (or kCentreOfMass) at the moment that is shown [N s], along the ground and
  /// away from it. @return false, with a sentence, when there are too many pushes
  bool Kick(int endpoint, float impulse_x_ns, float impulse_y_ns);
  void RemovePush(std::size_t index);
  /// Ground, gravity and pushes differ from what was opened.
  [[nodiscard]] bool WorldChanged() const;
  void ResetWorld();
  [[nodiscard]] const Environment& CalmWorld() const { return calm_.environment; }

  // The motion that the shown one is compared with, in the same world, with the same pushes, but for the calm
  // one.
  /// @param kind  not kFound
  /// @param controller  of the document, for Ghost::Kind::kController
  void ChooseGhost(Ghost::Kind kind, int controller = -1);
  /// @return false: there is no such motion, or its figure is another tree of rods
  bool ChooseFoundGhost(const std::string& id);
  [[nodiscard]] const Ghost& Compared() const { return ghost_; }
  [[nodiscard]] std::string GhostWords() const { return ghost_.Words(document_); }
  /// The ghost is at the moment that is shown.
  void KeepGhostInTime() { ghost_.Seek(player.TimeS()); }
  void PutSideBySide(bool beside);
  /// Beside the shown motion the best one that was found with the other kind of sense variables, for the same
  /// figure and task; when there is none, a search for one begins, or waits in the queue.
  void CompareDeciders();
  void StopComparing();
  /// What CompareDeciders has ordered is still being looked for.
  [[nodiscard]] bool AwaitsRival() const;

  // The search.
  void Synthesize();
  /// Climbs a moment from the shown motion, in the style that is set; the ghost is what it was before.
  void TryStyle();
  static constexpr int kTryEvaluations = 4000;
  void Pause() {
    if (Searching()) host_.PauseSearch();
  }
  void Resume() {
    if (Searching()) host_.ResumeSearch();
  }
  /// Ends the search, or the lab. What waits in the queue goes on waiting.
  void Stop();
  void OnSearchProgress(SearchProgress progress);
  [[nodiscard]] const SearchProgress& Progress() const { return progress_; }
  /// Whose it is, in one line: "Mr. Star-Man · travel, SPHC, seed 3"; of the queue with a word that says so.
  [[nodiscard]] const std::string& ProgressTitle() const { return progress_title_; }
  /// How the population of the present or last search scattered.
  [[nodiscard]] const SpreadCurve& PopulationSpread() const { return spread_; }
  [[nodiscard]] bool Searching() const {
    return progress_.state == SearchState::kRunning || progress_.state == SearchState::kPaused;
  }
  /// Shows the best motion found so far, when the last one has been on the screen for a moment. @return true
  /// if it did
  bool ShowImprovement(double seconds);
  int workers = 1;

  // The queue: searches with their own problems, which begin one after another when the search before them is
  // done or has failed. One that a person stops leaves the others waiting for RunQueue. They leave the stage
  // alone, unless the document in hand asks for just that search; what they find goes to the found motions.
  SearchQueue queue;
  /// Puts a document's search behind all that wait. @param document valid. @return false, with a sentence: no
  /// room
  bool Enqueue(const Document& document);
  /// The search of the document in hand, with further seeds that neither run nor wait yet. @return how many
  int EnqueueSeeds(int count);
  /// Begins with the first that waits; then they go on by themselves. Refused, with a sentence, while a
  /// search or the lab runs.
  bool RunQueue();
  /// Queues the suite's searches, and lets them run.
  void MakeSuite(const SuiteChoice&);
  /// Once a frame: goes on where a search ended by the way, because its document went away.
  void GoOn() {
    if (queue_due_) RunNext();
  }
  /// What runs came from the queue: stopping, undoing and opening in the document in hand do not concern it.
  [[nodiscard]] bool RunsQueued() const { return Searching() && queued_; }
  /// What the running search looks for; null: none runs.
  [[nodiscard]] const Document* Searched() const { return Searching() && searched_ ? &*searched_ : nullptr; }

  // Found motions: of every search that ended, and what a person keeps.
  FoundMotions found;
  /// Keeps the motion in hand. Refused, with a sentence: there is none, or no room.
  bool KeepMotion();
  /// The document as it was found, in the place of the one in hand, which Undo brings back. @return false:
  /// there is no such motion
  bool ShowFound(const std::string& id);
  /// The person is asked for its name.
  void AskName(const std::string& id) const;
  [[nodiscard]] bool CanAskName() const { return host_.CanAskName(); }
  /// The search that found it once more: the same seed, settings and problem. @return whether it is queued
  bool MakeAgain(const std::string& id);
  /// Whether a found motion is what is in hand now.
  [[nodiscard]] bool InHand(const FoundMotions::Entry&) const;

  // The map of styles that the last MAP-Elites search has left.
  [[nodiscard]] const std::optional<EliteMap>& Elites() const { return elites_; }
  /// One of its motions takes the stage; Undo brings back what was there.
  void ShowElite(Document motion);

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
  /// Keeps the present document for Undo, once on each occasion.
  void Remember(int occasion);
  void Remember() { Remember(gesture_); }
  /// @param words a pattern for what is done
  void Return(const Document& document, const char* words);
  /// Another document in the place of this one, which Undo brings back. @return false, with a sentence: it is
  /// locked
  /// @param same_problem  it is another motion of the problem in hand: that is nobody's edit of its
  /// controllers
  bool Replace(Document document, bool same_problem = false);
  /// The arrangement does not let this document take the place of the one in hand. Says so.
  [[nodiscard]] bool Refuses(const Arrangement&, const Document& next);
  [[nodiscard]] bool FoundNothingYet() const;
  /// An edit of the timeline; the clip it returns is selected then.
  void EditTimeline(const std::function<Result<int>(Document&)>& edit);
  /// After each change: what is known of another map is forgotten.
  void CheckTransitions();
  /// After it the running search would look for something else than what is there.
  [[nodiscard]] bool DisturbsSearch(const Document& next) const;
  /// The present document after an edit, or nothing and a sentence when that is invalid.
  [[nodiscard]] std::optional<Document> Edited(const Edit& edit);
  /// Ends the search for good: what it still reports belongs to a document that is no longer here.
  void AbandonSearch();
  void PutController(Controller controller);
  void BeginSearch(Document wanted, bool queued = false);
  void Halt();
  void RunNext();
  void EndSearch();
  void NoteFound();
  [[nodiscard]] bool BelongsOnStage() const;
  void ForgetProgress();
  [[nodiscard]] Ghost::Documents GhostDocuments() const {
    return {.shown = document_, .earlier = earlier_, .calm = calm_};
  }
  /// The found motion that was noted last stands beside, if it was ordered.
  void MeetRival();
  void RunTrial();
  void OnTrialProgress(const SearchProgress&);
  void EndLab(LabState);

  Host& host_;
  std::optional<EliteMap> elites_;
  Document document_;  // its hash: as its maker saw it, until something that the motion depends on changes
  bool differs_from_maker_ = false;
  History history_;
  int occasions_ = 1;  // so far
  int gesture_ = 1;
  int search_occasion_ = 0;  // all that one search finds is one step
  std::vector<Figure> figures_;
  std::vector<Document> problems_;
  int selected_clip_ = 0;
  struct KnownNearness {
    std::uint64_t hash = 0;  // of the motion
    int clip = 0;
    Nearness nearness;
  };
  KnownNearness nearness_;  // what was worked out last
  TransitionScores transitions_;
  double unchanged_for_s_ = 0.0;  // the map that is wanted
  Document calm_;                 // as it was opened, for its world
  Document earlier_;              // as it was before the last search, for the ghost
  Ghost ghost_;
  std::optional<Document> rival_;  // the search whose motion is to stand beside
  SearchProgress progress_;
  std::string progress_title_;
  std::optional<Document> searched_;  // the document as it was when the search began; empty: none is wanted
  int searched_clip_ = 0;             // the clip that it improves
  bool queued_ = false;               // it came from the queue
  bool off_stage_ = false;            // it did, and what it finds is no longer wanted on the stage
  std::string noted_;                 // what it has found so far, among the found motions; empty: not there
  bool queue_due_ = false;            // a search ended by the way: the next one begins with the next frame
  SpreadCurve spread_;
  Genome improvement_;  // found, not shown yet
  double shown_for_s_ = 0.0;
};

/// Mr. Star-Man: five equal rods from one hub.
[[nodiscard]] Figure StandardFigure();

/// What decides: a clock, the physical senses, or a network of sensors.
enum class Decider { kTimer, kSenses, kNetwork };
[[nodiscard]] Decider DeciderOf(const Document&);
/// Of the next search.
void Decide(Document&, Decider);

/// What a controller is compared with: a timer with senses, all others with a timer.
[[nodiscard]] Decider RivalOf(const Controller&);

/// "10 rules with physical senses", "10 rules with timer 0.80 s", "a network of 10 hidden nodes".
[[nodiscard]] std::string ControllerWords(ControllerKind, const SenseSpec&, int rules);
/// What the task rewards, e.g. "travel".
[[nodiscard]] std::string TaskWords(TaskKind);
/// The same in English, whatever the language: what documents are called goes into their files and links.
[[nodiscard]] std::string ControllerName(ControllerKind, const SenseSpec&, int rules);
[[nodiscard]] const char* TaskName(TaskKind);

}  // namespace gaitsmith::shell
