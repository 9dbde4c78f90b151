// SPDX-License-Identifier: MIT
// Measures the drawing time of frames with GPU fences, without blocking.
#include "shell/host/frame_pace.h"

#include <algorithm>

extern "C" {  // see page.library.js
void gs_fence_frame();
bool gs_frame_is_drawn();
void gs_forget_fence();
}

namespace gaitsmith::shell {

void FramePace::Measure(double now_ms) {
  if (!measuring_) return;
  ++polls_;
  const double cost_ms = now_ms - begun_ms_;
  // A lost context never signals the fence, and an idle page does not poll it.
  constexpr double kGivenUpMs = 1000.0;
  if (!gs_frame_is_drawn() && cost_ms < kGivenUpMs) return;
  gs_forget_fence();
  measuring_ = false;
  if (polls_ > 1 && cost_ms >= kGivenUpMs) return;
  // A frame that is ready by the display's next frame counts as instant.
  constexpr double kNewest = 0.25;
  cost_ms_ += kNewest * ((polls_ > 1 ? cost_ms : 0.0) - cost_ms_);
}

bool FramePace::Due(double now_ms, bool searching) {
  Measure(now_ms);
  // A single late frame does not count as a slow machine.
  constexpr double kSlowMs = 20.0;
  constexpr double kShare = 0.15;           // greatest share of time spent drawing
  constexpr double kMaxIntervalMs = 200.0;  // greatest interval between frames
  const double throttled_ms =
      searching && cost_ms_ > kSlowMs ? std::min(cost_ms_ / kShare, kMaxIntervalMs) : 0.0;
  constexpr double kEarlyMs = 2.0;  // tolerance for the browser's uneven frame times
  return now_ms - drawn_ms_ >= std::max(limit_ms_, throttled_ms) - kEarlyMs;
}

void FramePace::Drawn(double now_ms) {
  drawn_ms_ = now_ms;
  if (measuring_) return;
  gs_fence_frame();
  measuring_ = true;
  begun_ms_ = now_ms;
  polls_ = 0;
}

}  // namespace gaitsmith::shell
