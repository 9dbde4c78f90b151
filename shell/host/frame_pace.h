// SPDX-License-Identifier: MIT
// How often the page's canvas is drawn. Where graphics are software they take the processors that a search
// needs, so while one runs, slow frames become rarer.
#pragma once

namespace gaitsmith::shell {

class FramePace {
 public:
  /// Draws no more often than this, search or not; 0: as often as the display does.
  void Limit(double per_second) { limit_ms_ = per_second > 0.0 ? 1000.0 / per_second : 0.0; }

  /// Call it at every frame of the display that there is something to draw in. @return whether it may be
  /// drawn
  bool Due(double now_ms, bool searching);
  /// A frame was just handed to the browser.
  void Drawn(double now_ms);

 private:
  void Measure(double now_ms);

  double limit_ms_ = 0.0;
  double drawn_ms_ = 0.0;
  double cost_ms_ = 0.0;    // from handing a frame over until it is drawn, of late
  bool measuring_ = false;  // a frame, with a fence behind it
  double begun_ms_ = 0.0;
  int looks_ = 0;
};

}  // namespace gaitsmith::shell
