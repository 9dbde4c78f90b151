// SPDX-License-Identifier: MIT
// How often the page's canvas is drawn. With software graphics, drawing takes processor time that a search
// needs, so slow frames become rarer while a search runs.
#pragma once

namespace gaitsmith::shell {

class FramePace {
 public:
  /// Sets the greatest frame rate, with or without a search; 0: that of the display.
  void Limit(double per_second) { limit_ms_ = per_second > 0.0 ? 1000.0 / per_second : 0.0; }

  /// Call at every frame of the display with something to draw. @return whether to draw it
  bool Due(double now_ms, bool searching);
  /// Call after a frame was handed to the browser.
  void Drawn(double now_ms);

 private:
  void Measure(double now_ms);

  double limit_ms_ = 0.0;
  double drawn_ms_ = 0.0;
  double cost_ms_ = 0.0;    // recent time from handing over a frame until it is drawn
  bool measuring_ = false;  // a frame with a fence behind it is being measured
  double begun_ms_ = 0.0;
  int looks_ = 0;
};

}  // namespace gaitsmith::shell
