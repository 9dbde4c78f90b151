// SPDX-License-Identifier: MIT
// What somebody who does not point at the canvas asks of a widget: a screen reader, a script, a key of the
// page. The widget does it itself when it is drawn next, as if it had been pressed or stepped; one request a
// frame, in the order of asking.
#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

struct WidgetRequest {
  enum class Kind {
    kFocus,  // takes the keyboard, and comes into sight
    kPress,
    kStep,  // by this many steps, as by arrow keys
    kSet,   // to this number, as of WidgetRange
  };

  std::string id;
  Kind kind = Kind::kFocus;
  double number = 0.0;
  bool ring = true;    // the widget shows that it has the keyboard
  bool begins = true;  // a gesture of its own for Undo; false: more of the last one
};

class WidgetRequests {
 public:
  /// Steps add up, a number replaces one that still waits for the same widget, and whatever follows a wish
  /// for the keyboard replaces it, since every request brings the keyboard along.
  void Add(WidgetRequest);

  void BeginFrame();
  /// The frame's request, or null.
  [[nodiscard]] const WidgetRequest* Due() const { return due_.id.empty() ? nullptr : &due_; }
  /// The frame's request if it is meant for this widget, or null.
  [[nodiscard]] const WidgetRequest* DueFor(std::string_view id) const;
  /// Whatever it asked for was done, or the widget is not there any more.
  void EndFrame() { due_ = {}; }

  /// Some have not been done.
  [[nodiscard]] bool Waiting() const { return !waiting_.empty(); }
  /// The widget that will have the keyboard when all is done; empty: the one that has it.
  [[nodiscard]] std::string_view Last() const {
    return waiting_.empty() ? std::string_view() : waiting_.back().id;
  }

 private:
  std::deque<WidgetRequest> waiting_;
  WidgetRequest due_;
};

}  // namespace gaitsmith::shell
