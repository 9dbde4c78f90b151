// SPDX-License-Identifier: MIT
// A session's timeline: the clips that are chained into one motion.
#include <algorithm>
#include <cmath>

#include "core/document/composite.h"
#include "core/document/timeline_edit.h"
#include "shell/session/session.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

/// What an edit that gives nothing back leaves selected.
Result<int> Then(const Result<void>& done, int selected) {
  if (!done) return std::unexpected(done.error());
  return selected;
}

}  // namespace

void Session::EditTimeline(const std::function<Result<int>(Document&)>& edit) {
  Document next = document_;
  auto selected = edit(next);
  // A search that it disturbs ends, and what that found last is edited with the rest.
  if (selected && DisturbsSearch(next)) {
    AbandonSearch();
    next = document_;
    selected = edit(next);
  }
  if (!selected) return Say(Tr("Not possible: {1}.", TrError(selected.error())));
  DropUnusedControllers(next, document_.timeline);
  std::optional<Controller> ghost;
  if (const auto index = ghost_.ControllerIndex())
    ghost = document_.controllers[static_cast<std::size_t>(*index)];
  const bool changed = Change([&](Document& d) {
    d.controllers = next.controllers;
    d.timeline = next.timeline;
    d.duration_steps = next.duration_steps;
    d.search.start = next.search.start;
  });
  if (!changed) return;
  SelectClip(*selected);
  if (!ghost) return;
  // Controllers may have moved up in their list.
  const auto known = AddController(next, *ghost);
  ghost_.StandFor(Ghost::Kind::kController, known.value_or(-1), GhostDocuments());
}

bool Session::DisturbsSearch(const Document& next) const {
  if (!Searching() || queued_ || !searched_) return false;
  if (next.timeline.size() != document_.timeline.size() || next.timeline.empty()) return true;
  const auto clip = std::min(static_cast<std::size_t>(searched_clip_), next.timeline.size() - 1);
  const auto genes = [clip](const Document& d) -> const Genome& {
    return d.controllers[static_cast<std::size_t>(d.timeline[clip].controller)].genes;
  };
  if (genes(next) != genes(document_)) return true;
  // A repair is scored from where the clip took over and for as long as it lasted.
  return searched_->search.in_place_of >= 0 && PartingStep(next, document_) < EndOf(document_, clip);
}

void Session::AddClip() {
  if (document_.timeline.empty()) return;
  EditTimeline([&](Document& d) {
    const auto last = static_cast<int>(d.timeline.size());
    const int controller = d.timeline[static_cast<std::size_t>(selected_clip_)].controller;
    const Stretch added{.controller = controller, .steps = d.task.duration_steps};
    return Then(InsertClips(d, {added}, d.duration_steps), last);
  });
}

void Session::RemoveClip() {
  if (document_.timeline.size() < 2) return;
  EditTimeline([&](Document& d) {
    return Then(gaitsmith::RemoveClip(d, selected_clip_),
                std::min(selected_clip_, static_cast<int>(document_.timeline.size()) - 2));
  });
}

void Session::MoveClip(int clip, int start_step) {
  EditTimeline([&](Document& d) { return Then(MoveSwitch(d, clip, start_step), selected_clip_); });
}

void Session::SetClipLength(int clip, int steps) {
  EditTimeline([&](Document& d) { return Then(gaitsmith::SetClipLength(d, clip, steps), selected_clip_); });
}

void Session::SplitClip() {
  const int step = player.Frame();
  EditTimeline([&](Document& d) {
    const auto done = gaitsmith::SplitClip(d, step);
    return Then(done, ClipAt(d, step));
  });
}

void Session::DuplicateClip() {
  EditTimeline(
      [&](Document& d) { return Then(gaitsmith::DuplicateClip(d, selected_clip_), selected_clip_ + 1); });
}

void Session::MirrorClip() {
  EditTimeline([&](Document& d) { return Then(gaitsmith::MirrorClip(d, selected_clip_), selected_clip_); });
}

void Session::ReorderClip(int to) {
  const int last = static_cast<int>(document_.timeline.size()) - 1;
  if (to < 0 || to > last || to == selected_clip_) return;
  if (Searching() && !queued_) AbandonSearch();  // its clip may be another one then
  EditTimeline([&](Document& d) { return Then(gaitsmith::ReorderClip(d, selected_clip_, to), to); });
}

void Session::LoopTimeline() {
  EditTimeline([&](Document& d) { return Then(gaitsmith::LoopTimeline(d, 2), selected_clip_); });
}

bool Session::InsertFound(const std::string& id, std::optional<int> wanted) {
  const FoundMotions::Entry* entry = found.Find(id);
  if (entry == nullptr || !entry->motion.Moves()) return false;
  // A search that the edit ends changes the results.
  const Document other = entry->motion.document;
  const std::string name = entry->motion.name;
  if (!SameTree(other.figure, document_.figure)) {
    Say(Tr("Not possible: this controller was found for a figure with other rods, {1}.",
           TrTitle(other.figure.name)));
    return false;
  }
  const auto before = document_.timeline.size();
  // A motion that is shown to its end goes on with what is added.
  const int frame = player.Frame();
  const int step = wanted                                             ? *wanted
                   : frame >= player.Shown().Frames() - kShortestClip ? document_.duration_steps
                                                                      : frame;
  EditTimeline([&](Document& d) -> Result<int> {
    std::vector<Stretch> inserted = StretchesOf(other);  // what was kept may be a composite itself
    for (Stretch& stretch : inserted) {
      Controller controller = other.controllers[static_cast<std::size_t>(stretch.controller)];
      if (!name.empty() && inserted.size() == 1) controller.name = name;
      const auto added = AddController(d, controller);
      if (!added) return std::unexpected(added.error());
      stretch.controller = *added;
    }
    const auto done = InsertClips(d, inserted, step);
    return Then(done, ClipAt(d, std::min(step + kShortestClip, d.duration_steps - 1)));
  });
  return document_.timeline.size() != before;
}

std::optional<Nearness> Session::NearnessAtHandover() {
  const int clip = selected_clip_;
  if (clip <= 0 || clip >= static_cast<int>(document_.timeline.size())) return std::nullopt;
  const Clip& one = document_.timeline[static_cast<std::size_t>(clip)];
  const Motion& motion = player.Shown();
  if (one.start_step >= motion.Frames()) return std::nullopt;
  if (nearness_.hash != motion.Hash() || nearness_.clip != clip) {
    const Nearness nearness = NearnessOf(motion, one.start_step, UsualMotion(document_, one.controller));
    nearness_ = {.hash = motion.Hash(), .clip = clip, .nearness = nearness};
  }
  return nearness_.nearness;
}

void Session::RepairClip() {
  const Controller* shown = ShownController();
  if (!CanRepair()) {
    Say(Tr("Only a clip that takes over from another one can be repaired."));
    return;
  }
  Document wanted = document_;
  wanted.senses = shown->senses;
  wanted.rules = shown->rules;
  wanted.kind = shown->kind;
  wanted.search = SearchSettings{};
  wanted.search.algorithm = Algorithm::kShc;
  wanted.search.seed = document_.search.seed;
  wanted.search.evaluations = kTryEvaluations;
  wanted.search.start = document_.timeline[static_cast<std::size_t>(selected_clip_)].controller;
  wanted.search.in_place_of = selected_clip_;
  BeginSearch(std::move(wanted));
}

}  // namespace gaitsmith::shell
