// SPDX-License-Identifier: MIT
#include "shell/session/plan_run.h"

#include <algorithm>
#include <utility>

#include "core/document/parts.h"
#include "core/planning/plan_draft.h"
#include "shell/words/language.h"
#include "shell/words/plan_words.h"

namespace gaitsmith::shell {

namespace {

constexpr double kPlanSettledS = 0.12;  // a dragged slider changes every frame

/// Whether the motion is the one that a plan before was played as.
bool IsPlayed(const Document& d) {
  return d.controllers.size() == 1 && d.timeline.size() == 1 && d.controllers[0].name == "planned";
}

/// Whether the plan has such a part. Reports come from another program.
bool Has(const Plan& plan, const PlanPart& part) {
  using Kind = PlanPart::Kind;
  const auto within = [](int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
  };
  if (part.kind == Kind::kStanceX || part.kind == Kind::kStanceY)
    return within(part.index, plan.stances.size());
  if (!within(part.index, plan.keyframes.size())) return false;
  const Keyframe& keyframe = plan.keyframes[static_cast<std::size_t>(part.index)];
  switch (part.kind) {
    case Kind::kJoint:
      return within(part.which, keyframe.pose_rad.size());
    case Kind::kMarkX:
    case Kind::kMarkY:
      return within(part.which, keyframe.marks.size());
    default:
      return part.kind == Kind::kTurn;
  }
}

}  // namespace

bool PlanRun::SamePlan(const Document& a, const Document& b) {
  return SameWishes(a.plan, b.plan) && SameParts(a, b, {Part::kFigure, Part::kEnvironment, Part::kStart});
}

void PlanRun::Follow(bool opened) {
  const Document& d = workspace_.Doc();
  if (d.plan.Empty() && state_ == State::kNone) return;
  if (!opened && SamePlan(d, asked_)) return;
  if (Working()) Stop();
  const bool planned = !d.plan.solved.unknowns.empty();
  if (opened) settled_ = planned ? d : Document{};
  // Undo brings a motion back together with what it was planned for. A solution that is still there after an
  // edit of the body or the world is of what was before.
  const bool of_this = planned && (d.plan.solved != asked_.plan.solved || SamePlan(d, settled_));
  asked_ = d;
  if ((d.plan.Empty() || opened) && comparison_.Other().Source() == Ghost::Kind::kPlanned) comparison_.Stop();
  if (d.plan.Empty())
    state_ = State::kNone;
  else if (of_this || (opened && planned))
    state_ = State::kKept;
  else
    Wait();
}

void PlanRun::Wait() {
  state_ = State::kWaits;
  unchanged_for_s_ = 0.0;
}

void PlanRun::Again() {
  asked_ = workspace_.Doc();
  if (!asked_.plan.Empty()) Wait();
}

void PlanRun::Stop() {
  if (state_ == State::kWorks) workspace_.TheHost().StopPlan();
  if (Working()) state_ = State::kFailed;
}

void PlanRun::Advance(double seconds) {
  unchanged_for_s_ += seconds;
  if (state_ != State::kWaits || unchanged_for_s_ < kPlanSettledS) return;
  if (search_.Running() && search_.ShowsImprovements()) return;
  if (workspace_.Layout().Locks(LockedPart::kTimeline) ||
      workspace_.Layout().Locks(LockedPart::kController)) {
    state_ = State::kNone;  // what is found could not be taken
    return;
  }
  if (const auto planned = CanBePlanned(asked_); !planned) {
    state_ = State::kImpossible;
    fault_ = planned.error().Sentence();
    return workspace_.Say(Words());
  }
  // From the last motion, if the same endpoints stand in it one after another.
  Document request = asked_;
  if (settled_.plan.stances.size() == asked_.plan.stances.size()) {
    if (request.plan.solved.unknowns.empty()) request.plan.solved = settled_.plan.solved;
    DropStaleSolution(request);
  } else {
    request.plan.solved = {};
  }
  state_ = State::kWorks;
  report_ = {};
  fine_ = false;
  workspace_.TheHost().StartPlan(request, ++generation_);
}

void PlanRun::OnReport(int generation, PlanReport report) {
  if (generation != generation_ || state_ != State::kWorks) return;
  report_ = std::move(report);
  std::erase_if(report_.misses, [&](const PlanMiss& miss) { return !Has(asked_.plan, miss.part); });
  switch (report_.stage) {
    case PlanReport::Stage::kRelaxing:
      // What relaxes after that are corrections of what is played, not the plan.
      if (fine_) return;
      return comparison_.ShowPlanned(report_.document);
    case PlanReport::Stage::kFine:
      fine_ = true;
      workspace_.Report(Words());
      [[fallthrough]];
    case PlanReport::Stage::kCoarse:
      return comparison_.ShowPlanned(report_.document);
    case PlanReport::Stage::kRefused:
      state_ = State::kRefused;
      return workspace_.Say(Words());
    case PlanReport::Stage::kPlayed:
      break;
  }
  state_ = State::kDone;
  const Document& played = report_.document;
  constexpr int kRest = 50;  // steps in which one sees where it ends
  const bool again = IsPlayed(workspace_.Doc());
  const bool changed = workspace_.Change([&](Document& d) {
    const int duration = again ? d.duration_steps : played.plan.steps + kRest;
    CopyParts(played,
              {Part::kControllers, Part::kTimeline, Part::kSearchStart, Part::kTakeover, Part::kPlan,
               Part::kLineage},
              d);
    d.duration_steps = std::max(duration, played.plan.steps);
  });
  if (!changed) {
    state_ = State::kFailed;
    return;
  }
  asked_ = settled_ = workspace_.Doc();
  comparison_.ShowPlanned(asked_);
  if (!again) workspace_.Player().Present();
  workspace_.Report(Words());
}

void PlanRun::OnFailed(int generation) {
  if (generation != generation_ || state_ != State::kWorks) return;
  state_ = State::kFailed;
  workspace_.Say(Words());
}

const PlanMiss* PlanRun::Culprit() const {
  return state_ == State::kRefused && !report_.misses.empty() ? &report_.misses.front() : nullptr;
}

std::string PlanRun::Words() const {
  switch (state_) {
    case State::kNone:
      return "";
    case State::kKept:
      return Tr("The motion is as it was planned.");
    case State::kWaits:
      return Tr("Planning begins.");
    case State::kWorks:
      if (report_.stage == PlanReport::Stage::kFine || fine_) return Tr("Planned. The simulator tries it.");
      return Tr("Planning: step {1}", std::to_string(report_.iterations));
    case State::kDone:
      return PlayedWords(report_);
    case State::kRefused:
      return Culprit() == nullptr ? Tr("No motion was found that does all this.")
                                  : MissWords(*Culprit(), asked_.plan);
    case State::kImpossible:
      return Tr("This cannot be planned: {1}.", fault_);
    case State::kFailed:
      return Tr("Planning broke off. Change anything to try again.");
  }
  return "";
}

}  // namespace gaitsmith::shell
