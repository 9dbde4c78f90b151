// SPDX-License-Identifier: MIT
#include "shell/session/timeline_editor.h"

#include <algorithm>

#include "core/document/joints.h"
#include "core/document/parts.h"
#include "core/document/recording.h"
#include "core/document/timeline_edit.h"
#include "core/numeric/scalar_math.h"
#include "shell/words/language.h"
#include "shell/words/motion_name.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr std::string_view kEdited = ", edited";

void MarkEdited(std::string& words) {
  if (words.ends_with(kEdited)) return;
  words = Shortened(words, kMaxNameBytes - kEdited.size()) + std::string(kEdited);
}

/// Whether a search has written the title.
bool NamesSeed(std::string_view title) {
  const std::size_t space = title.rfind(' ');
  return space != std::string_view::npos && title.substr(0, space).ends_with(", seed") &&
         title.find_first_not_of("0123456789", space + 1) == std::string_view::npos;
}

/// The clip to select after an edit that returns no clip.
Result<int> Then(const Result<void>& done, int selected) {
  if (!done) return std::unexpected(done.error());
  return selected;
}

}  // namespace

bool TimelineEditor::ChangeController(const std::function<void(Controller&)>& edit) {
  if (ShownController() == nullptr) return false;
  const ControllerKind kind = ShownController()->kind;
  const SenseKind senses = ShownController()->senses.kind;
  if (search_.Improves(Selected())) search_.Abandon();
  // The end of a search shows its best controller, which may be of another kind than the edited one.
  if (ShownController()->kind != kind || ShownController()->senses.kind != senses) return false;
  return workspace_.Change([&](Document& d) {
    const Clip& clip = d.timeline[static_cast<std::size_t>(Selected())];
    Controller& controller = d.controllers[static_cast<std::size_t>(clip.controller)];
    const Controller before = controller;
    edit(controller);
    if (controller.rules == before.rules && controller.genes == before.genes) return;
    if (d.kind == controller.kind && d.rules == before.rules) d.rules = controller.rules;
    if (NamesSeed(d.title)) MarkEdited(d.title);  // that seed does not find the edited controller
    MarkEdited(controller.name);
  });
}

bool TimelineEditor::Edit(const std::function<Result<int>(Document&)>& edit) {
  Document next = workspace_.Doc();
  auto selected = edit(next);
  // Ends a search that the edit disturbs; the search's last result is part of what is edited.
  if (selected && search_.IsDisturbedBy(next)) {
    search_.Abandon();
    next = workspace_.Doc();
    selected = edit(next);
  }
  if (!selected) {
    workspace_.Say(Tr("Not possible: {1}.", TrError(selected.error())));
    return false;
  }
  DropUnusedControllers(next, workspace_.Doc().timeline);
  const auto compared = comparison_.ComparedController();
  const bool changed = workspace_.Change([&](Document& d) {
    CopyParts(next, {Part::kControllers, Part::kTimeline, Part::kDuration, Part::kSearchStart}, d);
  });
  if (!changed) return false;
  Select(*selected);
  if (compared) comparison_.FindAgain(*compared);
  return true;
}

void TimelineEditor::AddClip() {
  if (workspace_.Doc().timeline.empty()) return;
  Edit([&](Document& d) {
    const auto last = static_cast<int>(d.timeline.size());
    const int controller = d.timeline[static_cast<std::size_t>(Selected())].controller;
    const Stretch added{.controller = controller, .steps = d.task.duration_steps};
    return Then(InsertClips(d, {added}, d.duration_steps), last);
  });
}

void TimelineEditor::RemoveClip() {
  if (workspace_.Doc().timeline.size() < 2) return;
  Edit([&](Document& d) {
    return Then(gaitsmith::RemoveClip(d, Selected()),
                std::min(Selected(), static_cast<int>(workspace_.Doc().timeline.size()) - 2));
  });
}

void TimelineEditor::MoveClip(int clip, int start_step) {
  Edit([&](Document& d) { return Then(MoveSwitch(d, clip, start_step), Selected()); });
}

void TimelineEditor::SetClipLength(int clip, int steps) {
  Edit([&](Document& d) { return Then(gaitsmith::SetClipLength(d, clip, steps), Selected()); });
}

void TimelineEditor::SplitClip() {
  const int step = workspace_.Player().Frame();
  Edit([&](Document& d) {
    const auto done = gaitsmith::SplitClip(d, step);
    return Then(done, ClipAt(d, step));
  });
}

void TimelineEditor::DuplicateClip() {
  Edit([&](Document& d) { return Then(gaitsmith::DuplicateClip(d, Selected()), Selected() + 1); });
}

void TimelineEditor::MirrorClip() {
  const bool mirrored = Edit([&](Document& d) -> Result<int> {
    const Document before = d;
    if (const auto done = gaitsmith::MirrorClip(d, Selected()); !done) return Then(done, 0);
    const auto clip = static_cast<std::size_t>(Selected());
    const int original = before.timeline[clip].controller;
    const int image = d.timeline[clip].controller;
    // The image of "Run left" is "Run right". Names that a person gave become "..., mirrored".
    const std::string& name = before.controllers[static_cast<std::size_t>(original)].name;
    if (d.controllers.size() > before.controllers.size() && name == MotionName(before, original))
      d.controllers[static_cast<std::size_t>(image)].name = MotionName(d, image, before.controllers);
    return Selected();
  });
  if (mirrored) workspace_.Report(Tr("Mirrored: clip {1} goes the other way.", Selected() + 1));
}

void TimelineEditor::ReorderClip(int to) {
  const int last = static_cast<int>(workspace_.Doc().timeline.size()) - 1;
  if (to < 0 || to > last || to == Selected()) return;
  if (search_.Running() && !search_.RunsQueued())
    search_.Abandon();  // its clip may be another one afterwards
  Edit([&](Document& d) { return Then(gaitsmith::ReorderClip(d, Selected(), to), to); });
}

void TimelineEditor::Repeat() {
  Edit([&](Document& d) { return Then(gaitsmith::LoopTimeline(d, 2), Selected()); });
}

bool TimelineEditor::RecordAsCurves() {
  if (search_.Running() && !search_.RunsQueued()) search_.Abandon();
  const auto recording = gaitsmith::RecordAsCurves(workspace_.Doc(), kMaxRules);
  if (!recording) {
    workspace_.Say(Tr("Not possible: {1}.", TrError(recording.error())));
    return false;
  }
  const auto metres = [&] {
    const Motion& motion = workspace_.Player().Shown();
    return Fixed(motion.TermsAt(motion.Frames() - 1).travel_m, 2) + " m";
  };
  const Document original = workspace_.Doc();
  const std::string before = metres();
  if (!workspace_.Change([&](Document& d) { d = recording->document; })) return false;
  Select(0);
  comparison_.ShowBeside(original);
  constexpr double kDegreesPerRad = 180.0 / kPi;
  workspace_.Report(Tr(
      "Recorded: the joints' angles differ by {1}°, at most {2}°. It travels {3}, where it went {4} before.",
      Fixed(recording->typical_rad * kDegreesPerRad, 1), Fixed(recording->worst_rad * kDegreesPerRad, 1),
      metres(), before));
  return true;
}

bool TimelineEditor::InsertFound(const std::string& id, std::optional<int> wanted) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr || !entry->motion.Moves()) return false;
  // A copy: a search that the edit ends changes the results.
  const Document other = entry->motion.document;
  const std::string name = entry->motion.name;
  if (!SameTree(other.figure, workspace_.Doc().figure)) {
    workspace_.Say(
        Tr("Not possible: this controller was found for another figure, {1}.", TrTitle(other.figure.name)));
    return false;
  }
  const auto before = workspace_.Doc().timeline.size();
  // If the motion was played to its end, playback continues into the new clip.
  const int frame = workspace_.Player().Frame();
  const int step = wanted ? *wanted
                   : frame >= workspace_.Player().Shown().Frames() - kShortestClip
                       ? workspace_.Doc().duration_steps
                       : frame;
  Edit([&](Document& d) -> Result<int> {
    std::vector<Stretch> inserted = StretchesOf(other);  // a saved motion may be a composite itself
    for (Stretch& stretch : inserted) {
      Controller controller = other.controllers[static_cast<std::size_t>(stretch.controller)];
      if (!name.empty() && inserted.size() == 1) {
        controller.name = name;
      } else if (controller.name == MotionName(other, stretch.controller)) {
        controller.name = MotionName(other, stretch.controller, d.controllers);
      }
      const auto added = AddController(d, controller);
      if (!added) return std::unexpected(added.error());
      stretch.controller = *added;
    }
    const auto done = InsertClips(d, inserted, step);
    return Then(done, ClipAt(d, std::min(step + kShortestClip, d.duration_steps - 1)));
  });
  if (workspace_.Doc().timeline.size() == before) return false;
  // A chain moves as its document does: in one model, with one figure.
  if (!SameJoints(other, workspace_.Doc()))
    workspace_.Say(
        Tr("This motion was found with joints of another strength. It may move differently here."));
  return true;
}

void TimelineEditor::SetDuration(int steps) {
  workspace_.Change([&](Document& d) {
    d.task.duration_steps = steps;
    if (d.timeline.size() < 2) d.duration_steps = steps;
  });
}

bool TimelineEditor::MapComplete() const {
  const TransitionScores& map = transitions_.Scores();
  return map.Any() && !map.Waits() && !map.UnderWay() && map.Best() >= 0;
}

const char* TimelineEditor::WhyNoSnap() const {
  const TransitionScores& map = transitions_.Scores();
  if (!CanRepair()) return Tr("The first clip takes over from no other clip.");
  if (!map.Any()) return Tr("There is no room to move this clip.");
  if (map.Waits() || map.UnderWay()) return Tr("The transition map is not complete yet.");
  if (map.Best() < 0) return Tr("The transition map has no data.");
  const int start = workspace_.Doc().timeline[static_cast<std::size_t>(Selected())].start_step;
  const int good = map.NearestGood(start);
  if (good < 0) return Tr("There is no good moment for this switch.");
  return good == map.Nearest(start) ? Tr("The switch is at a good moment already.") : "";
}

void TimelineEditor::SnapToBest() {
  if (const std::string why_not = WhyNoSnap(); !why_not.empty()) return workspace_.Say(why_not);
  const TransitionScores& map = transitions_.Scores();
  const int start = workspace_.Doc().timeline[static_cast<std::size_t>(Selected())].start_step;
  const int good = map.Steps()[static_cast<std::size_t>(map.NearestGood(start))];
  const bool moved = Edit([&](Document& d) { return Then(MoveSwitch(d, Selected(), good), Selected()); });
  if (!moved) return;
  workspace_.Report(
      Tr("Switch moved to {1} s, the nearest good moment.", Fixed(static_cast<float>(good) * kStep, 2)));
}

}  // namespace gaitsmith::shell
