// SPDX-License-Identifier: MIT
// The frame rate of the page's canvas. Software rendering takes processor time from a search, so slow frames
// are drawn less often while one runs.
#pragma once

namespace gaitsmith::shell {

class FramePace {
 public:
  /// Limits the frame rate [1/s], with or without a search; 0: that of the display.
  void Limit(double per_second) { limit_ms_ = per_second > 0.0 ? 1000.0 / per_second : 0.0; }

  /// Call at every display frame when there is something to draw. @return whether to draw it
  bool Due(double now_ms, bool searching);
  /// Call after a frame was handed to the browser.
  void Drawn(double now_ms);

 private:
  void Measure(double now_ms);

  double limit_ms_ = 0.0;
  double drawn_ms_ = 0.0;
  double cost_ms_ = 0.0;    // smoothed time from handing over a frame until it is drawn
  bool measuring_ = false;  // the fence of a frame is pending
  double begun_ms_ = 0.0;
  int polls_ = 0;
};

}  // namespace gaitsmith::shell
