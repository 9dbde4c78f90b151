// SPDX-License-Identifier: MIT
#include "shell/session/transition_run.h"

#include "shell/words/language.h"

namespace gaitsmith::shell {

std::optional<float> TransitionRun::ShareAtStart() const {
  if (!scores_.Any()) return std::nullopt;
  const auto clip = static_cast<std::size_t>(workspace_.SelectedClip());
  return scores_.Share(scores_.Nearest(workspace_.Doc().timeline[clip].start_step));
}

void TransitionRun::Follow() {
  const Document& d = workspace_.Doc();
  const int clip = workspace_.SelectedClip();
  if (scores_.IsOf(d, clip)) return;
  if (scores_.UnderWay()) workspace_.TheHost().StopTransitionMap();
  if (TransitionSteps(d, clip).empty()) {
    scores_.Clear();
  } else {
    scores_.Begin(d, clip);
  }
  unchanged_for_s_ = 0.0;
}

void TransitionRun::Advance(double seconds) {
  constexpr double kSettledS = 0.2;  // a dragged slider changes every frame
  unchanged_for_s_ += seconds;
  if (!scores_.Waits() || unchanged_for_s_ < kSettledS) return;
  if (search_.Running() && search_.ShowsImprovements()) return;
  const int generation = scores_.Start();
  workspace_.TheHost().StartTransitionMap(scores_.Request(), generation);
}

void TransitionRun::OnFailed(int generation) {
  if (scores_.Fail(generation))
    workspace_.Say(Tr("The transition map could not be completed. Its finished part is shown."));
}

}  // namespace gaitsmith::shell
