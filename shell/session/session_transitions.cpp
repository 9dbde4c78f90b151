// SPDX-License-Identifier: MIT
// A session's transition map: when it is worked out, and what it is good for.
#include "shell/session/session.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

void Session::CheckTransitions() {
  if (transitions_.IsOf(document_, selected_clip_)) return;
  if (transitions_.UnderWay()) host_.StopTransitionMap();
  if (TransitionSteps(document_, selected_clip_).empty()) {
    transitions_.Clear();
  } else {
    transitions_.Begin(document_, selected_clip_);
  }
  unchanged_for_s_ = 0.0;
}

void Session::FollowTransitions(double seconds) {
  constexpr double kCalmS = 0.2;  // a slider that is dragged changes every frame
  unchanged_for_s_ += seconds;
  if (!transitions_.Waits() || unchanged_for_s_ < kCalmS) return;
  if (Searching() && BelongsOnStage()) return;
  const int generation = transitions_.Start();
  host_.StartTransitionMap(transitions_.Request(), generation);
}

void Session::OnTransitions(const TransitionPart& part) { transitions_.Take(part); }

void Session::OnTransitionsFailed(int generation) {
  if (transitions_.Fail(generation))
    Say(Tr("The transition map could not be worked out to its end; what is known of it is shown."));
}

const char* Session::WhyNoSnap() const {
  if (!CanRepair()) return Tr("it takes over from no other clip");
  if (!transitions_.Any()) return Tr("there is no room to move it");
  if (transitions_.Waits() || transitions_.UnderWay()) return Tr("the transition map is not complete yet");
  if (transitions_.Best() < 0) return Tr("nothing is known of the transition map");
  const Clip& clip = document_.timeline[static_cast<std::size_t>(selected_clip_)];
  const int best = transitions_.Steps()[static_cast<std::size_t>(transitions_.Best())];
  return clip.start_step == best ? Tr("it takes over at the best moment already") : "";
}

void Session::SnapToBest() {
  if (const std::string why_not = WhyNoSnap(); !why_not.empty()) return Say(Tr("Not now: {1}.", why_not));
  MoveClip(selected_clip_, transitions_.Steps()[static_cast<std::size_t>(transitions_.Best())]);
}

}  // namespace gaitsmith::shell
