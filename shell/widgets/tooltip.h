// SPDX-License-Identifier: MIT
// What a control does, beside it: after half a second under the pointer or with the keyboard's focus, or
// while a finger stays on it. The sentences are those of shell/words/hints.h.
#pragma once

#include <string>

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

class Tooltip {
 public:
  /// Call in each frame, after all widgets.
  void Draw(Ui&, WidgetRegistry&);
  /// Waits. @return true if a frame is due, to show it
  bool Advance(double seconds);
  /// Hides it until another control is pointed at. @return false: it was not shown
  bool Hide();

 private:
  [[nodiscard]] const Widget* Chosen(const WidgetRegistry&) const;

  std::string id_;  // of the control; empty: none
  double waited_s_ = 0.0;
  bool shown_ = false;
  bool hidden_ = false;  // until another control is pointed at
  ImRect rect_;          // while shown
};

}  // namespace gaitsmith::shell
