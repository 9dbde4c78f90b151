// SPDX-License-Identifier: MIT
// Replacing one document by another. Undo is in session_history.cpp.
#include "shell/session/session.h"

#include <cmath>
#include <utility>

#include "core/document/goals.h"
#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/parts.h"
#include "core/document/standing.h"
#include "core/document/style_weights.h"
#include "core/planning/plan_tracking.h"
#include "shell/words/figure_words.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {
namespace {

constexpr double kSlowFrameS = 0.08;  // a machine that draws so slowly does not draw attempts, too

// Removes what was made for another figure.
void Strip(Document& document) {
  document.controllers.clear();
  document.timeline.clear();
  document.pushes.clear();
  document.plan = {};
  document.duration_steps = document.task.duration_steps;
}

// The next search of a document that is opened has the goal of the one before.
void KeepGoal(const Document& before, Document& document) {
  const int duration = document.task.duration_steps;
  document.task = before.task;
  document.task.duration_steps = duration;
  if (!SameTree(before.figure, document.figure)) ForgetShown(document.task);
  if (const auto goal = GoalOf(before)) SetGoal(*goal, document);
}

}  // namespace

Session::Session(Host& host)
    : workspace_(host),
      results_(workspace_),
      lab_(workspace_, search_),
      search_(workspace_, lab_.Trials(), results_),
      live_(workspace_, search_),
      queue_(workspace_, lab_.Trials(), search_, results_),
      world_(workspace_),
      ground_(workspace_),
      teacher_(workspace_, ground_),
      comparison_(workspace_, world_, search_, queue_, results_),
      timeline_(workspace_, search_, comparison_, results_),
      keyframes_(workspace_),
      planning_(workspace_, search_, comparison_),
      gait_(workspace_) {
  workspace_.SetFollowers({.motion =
                               [this](bool opened) {
                                 if (opened || Doc().timeline.empty()) attempts_.Clear();
                                 if (opened) live_.Drop();
                                 world_.Follow(opened);
                                 ground_.Follow(opened);
                                 teacher_.Follow(opened);
                                 comparison_.Follow();
                                 timeline_.Transitions().Follow();
                                 planning_.Follow(opened);
                               },
                           .settings =
                               [this] {
                                 timeline_.Transitions().Follow();
                                 planning_.Follow(false);
                               },
                           .edited = [this](Parts changed) { live_.OnEdit(changed); }});
  search_.SetFollowers({.shown =
                            [this](const Document& searched, SearchRun::Source source, const Controller& c) {
                              const bool script = source == SearchRun::Source::kScript;
                              provenance_.AddFound(searched, c, script ? FoundBy::kScript : FoundBy::kPerson);
                            },
                        .found = [this](const std::string& id) { comparison_.ShowIfRequested(id); },
                        .ended = [this] { queue_.RunNext(); }});
  workspace_.Show(*shipped_.Motion("star-man-shuffle"), true);
  provenance_.AddOpened(Doc());
}

Result<void> Session::Open(std::string_view text, OpenedFrom from) {
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && text[first] == '{';
  auto document = json ? DecodeJson(text) : DecodeLink(text);
  if (!document) return std::unexpected(document.error());
  if (from == OpenedFrom::kOutside) provenance_.AddOpened(*document);
  const bool rested = Doc().timeline.empty();
  simple_ = false;
  search_.Abandon();
  BeginGesture();
  workspace_.Remember();
  BeginGesture();
  search_.ForgetProgress();
  workspace_.SelectClip(0);
  Player().speed = static_cast<double>(document->view.speed);
  workspace_.Show(std::move(*document), true);
  WakeFrom(rested);
  workspace_.Report(DiffersFromMaker()
                        ? Tr("This motion differs from the one its maker saw: hash {1} here, {2} there.",
                             HashText(Player().Shown().Hash()), HashText(*Doc().hash))
                        : Tr("Opened {1}.", TrTitle(Doc().title)));
  return {};
}

bool Session::Replace(Document document, bool same_problem) {
  Arrangement locks = Layout();
  for (const LockedPart part : {LockedPart::kController, LockedPart::kSearch, LockedPart::kTimeline})
    locks.locked[static_cast<std::size_t>(part)] &= !same_problem;
  // A search that may change the body leaves the drawn one, which is what is locked.
  const Figure drawn = AsDrawn(document), before = AsDrawn(Doc());
  const bool same_body =
      drawn.rods == before.rods && drawn.nodes == before.nodes && drawn.springs == before.springs;
  locks.locked[static_cast<std::size_t>(LockedPart::kFigure)] &= !(same_problem && same_body);
  if (workspace_.Refuses(locks, document)) return false;
  const bool rested = Doc().timeline.empty();
  LeaveViewer();
  search_.Abandon();
  workspace_.Remember();
  CopyParts(Doc(), Part::kView, document);
  workspace_.SelectClip(0);
  search_.ForgetProgress();
  workspace_.Show(std::move(document), true);
  WakeFrom(rested);
  return true;
}

void Session::WakeFrom(bool rested) {
  if (rested && !Doc().timeline.empty()) Player().Present();
}

bool Session::Begin(std::string_view example) {
  auto document = example.empty() ? std::optional(shipped_.FirstFigure()) : shipped_.Motion(example);
  if (!document) return false;
  provenance_.AddOpened(*document);
  workspace_.Show(std::move(*document), true);
  simple_ = example.empty();
  if (simple_) Player().Play(false);
  ForgetPast();
  return true;
}

void Session::LeaveViewer() {
  if (!std::exchange(viewing_, false)) return;
  simple_ = true;
  workspace_.Report(Tr("This motion is yours to change now."));
  workspace_.Redraw();
}

void Session::New() {
  if (!Replace(shipped_.FirstFigure())) return;
  Player().Play(false);
  SetView([](View& view) { view.panel = static_cast<int>(Panel::kSearch); });
  workspace_.Say(CannotMoveWords(Doc().figure.name) + " " + Tr("Undo restores the previous version."));
}

bool Session::ReplaceFigure(const Figure& figure) {
  const bool fits = SameTree(figure, Doc().figure);
  const Edit edit = [&](Document& d) {
    SetFigure(figure, d);
    d.drawn.clear();
    if (fits) return;
    Strip(d);
    ForgetShown(d.task);
    d.title = figure.name;
  };
  const auto next = workspace_.Edited(edit);
  if (!next || workspace_.Refuses(Layout(), *next)) return false;
  if (DifferingParts(*next, Doc()).Empty()) return true;
  search_.Abandon();  // the search is for the figure before the change
  const bool loses = !fits && !Doc().controllers.empty();
  const bool changed = Change(edit);
  if (changed && loses) {
    search_.ForgetProgress();
    workspace_.Say(Tr(
        "The old controllers do not fit the changed figure, so they were removed. Undo brings them back."));
  }
  return changed;
}

bool Session::CanTryBrain(const Document& other) const {
  return SameTree(other.figure, Doc().figure) && !SameRods(other, Doc());
}

void Session::TryBrain(const std::string& id) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr || !CanTryBrain(entry->motion.document)) return;
  Document tried = entry->motion.document;
  tried.figure = Doc().figure;
  tried.drawn = Doc().drawn;
  tried.lineage = {};
  tried.hash.reset();
  KeepGoal(Doc(), tried);
  if (!Replace(std::move(tried), true)) return;
  workspace_.Say(Tr("Another brain drives this body. Undo restores the previous version."));
}

void Session::ChooseFigure(int index) {
  Document standing = Standing(shipped_.Figures()[static_cast<std::size_t>(index)]);
  standing.environment = Doc().environment;
  if (GroundNeedsLimits(standing)) LimitJoints(standing);
  if (!Replace(std::move(standing))) return;
  Player().Play(false);
  workspace_.Say(CannotMoveWords(Doc().figure.name) + " " + Tr("Undo restores the previous version."));
}

void Session::ChooseProblem(int index) {
  if (!Replace(shipped_.Problems()[static_cast<std::size_t>(index)])) return;
  workspace_.Say(Tr("{1}: press Synthesize. Undo restores the previous version.", TrTitle(Doc().title)));
}

void Session::ChooseExample(const Document& example) {
  if (!Replace(example)) return;
  provenance_.AddOpened(example);
  workspace_.Say(Tr("{1}. Undo restores the previous version.", TrTitle(Doc().title)));
}

bool Session::ShowFound(const std::string& id, NextGoal goal) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr) return false;
  Document document = entry->motion.document;
  if (goal == NextGoal::kOfOpen) KeepGoal(Doc(), document);
  if (const std::string& name = entry->motion.name; !name.empty()) {
    document.title = name;
    if (document.timeline.size() == 1)
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)].name = name;
  }
  const bool moves = entry->motion.Moves();
  if (!Replace(document, true)) return true;  // Replace explains the refusal
  if (DiffersFromMaker()) return true;        // the stage reports it
  workspace_.Say(Tr(moves ? "{1}. Undo restores the previous version."
                          : "{1}: this search failed. Undo restores the previous version.",
                    TrTitle(Doc().title)));
  return true;
}

void Session::ShowElite(Document motion) {
  BeginGesture();
  if (!Replace(std::move(motion), true)) return;
  workspace_.Say(
      Tr("{1}. “Save to results” keeps it. Undo restores the previous version.", TrTitle(Doc().title)));
}

std::vector<Document> Session::KnownSearches() const {
  std::vector<Document> known = {Doc()};
  for (const FoundMotions::Entry* entry : results_.Motions().Sorted(FoundMotions::Order::kNewest))
    known.push_back(entry->motion.document);
  for (const SearchQueue::Entry& entry : queue_.List().Waiting()) known.push_back(entry.document);
  return known;
}

void Session::OpenKeyframes() {
  const bool asks = keyframes_.Begin();
  if (asks) SetView([](View& view) { view.panel = static_cast<int>(Panel::kKeyframes); });
}

void Session::TrackKeyframes() {
  const auto tracked = TrackPlan(Doc());
  if (!tracked) return workspace_.Say(Tr("Not possible: {1}.", TrError(tracked.error())));
  BeginGesture();
  if (!Set([&](Document& d) { d = *tracked; })) return;
  timeline_.Select(0);
  comparison_.ShowPlanned(Doc());
  search_.Synthesize(SearchRun::UndoStep::kMotionAndGesture);
}

void Session::RecordAsCurves() {
  const Document before = Doc();
  if (timeline_.RecordAsCurves()) provenance_.AddRecorded(before, Doc());
}

void Session::Synthesize() {
  LeaveViewer();
  const bool again = !lab_.Running() && search_.WouldRepeat() && !Layout().Locks(LockedPart::kSearch);
  if (!again) return search_.Synthesize();
  BeginGesture();
  for (const std::uint32_t seed : FreeSeeds(Doc(), KnownSearches(), 1))
    Set([seed](Document& d) { d.search.seed = seed; });
  search_.Synthesize(SearchRun::UndoStep::kMotionAndGesture);
}

void Session::ChangeGoal(const Edit& edit) {
  if (Set(edit)) live_.SearchAnew();
}

void Session::TryStyle(SearchRun::UndoStep step) {
  if (search_.TryStyle(step)) comparison_.Choose(Ghost::Kind::kEarlier);
}

void Session::TryManner(Manner manner) {
  const auto term =
      static_cast<std::size_t>(manner == Manner::kHigher ? StyleTerm::kMaxCmHeight : StyleTerm::kEffort);
  // One usual weight of effort is not seen: the acrobat's joints turn as much as before.
  const float units = manner == Manner::kHigher ? 1.0f : manner == Manner::kCalmer ? -3.0f : 3.0f;
  const float change = units * UsualWeights(Doc())[term];
  BeginGesture();
  const bool changed = Set([&](Document& d) {
    float& weight = d.task.weights[term];
    weight = std::abs(weight + change) < 0.01f * std::abs(change) ? 0.0f : weight + change;
  });
  if (changed) TryStyle(SearchRun::UndoStep::kMotionAndGesture);
}

void Session::TryMore() {
  if (queue_.AddSeeds(kQueuedSeeds, KnownSearches()) > 0 && !queue_.Busy()) queue_.Run();
}

void Session::Stop() {
  lab_.Stop();
  if (!search_.Running()) return;
  const bool shown = search_.ShowsImprovements();
  search_.Stop();
  if (shown) ShowEnd();
  if (const std::size_t count = queue_.List().Waiting().size(); count > 0)
    workspace_.Say(Tr("Stopped. {1} until you press Run queue.", WaitingWords(count)));
}

void Session::OnSearchProgress(SearchProgress progress) {
  if (lab_.Running()) return lab_.OnProgress(progress);
  if (live_.Searching() && !search_.Running()) return live_.OnProgress(progress);
  const bool shown = search_.Running() && search_.ShowsImprovements();
  if (shown && search_.Searched() != nullptr) {
    if (search_.Progress().evaluations == 0) attempts_.Begin(*search_.Searched());
    if (!Player().Calm() && frame_s_ < kSlowFrameS && Doc().timeline.size() < 2)
      attempts_.Add(progress.attempt, now_s_);
  }
  search_.OnProgress(std::move(progress));
  if (shown && !search_.Running()) ShowEnd();
}

void Session::ShowEnd() {
  attempts_.End(now_s_);
  if (Doc().timeline.size() == 1) Player().Present();
}

bool Session::Advance(double seconds) {
  if (Player().Playing()) now_s_ += seconds;
  if (!search_.Running() || !search_.ShowsImprovements()) attempts_.End(now_s_);
  frame_s_ += 0.1 * (seconds - frame_s_);
  queue_.Resume();
  timeline_.Transitions().Advance(seconds);
  planning_.Advance(seconds);
  const bool followed = live_.Advance(seconds);
  const bool improved = search_.ShowImprovement(seconds);
  const bool moved = Player().Advance(seconds);
  attempts_.Follow(Player().TimeS(), now_s_);
  const bool repeats = gait_.Advance(seconds);
  return moved || improved || followed || repeats;
}

}  // namespace gaitsmith::shell
