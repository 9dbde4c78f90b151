// SPDX-License-Identifier: MIT
// A request to a widget that does not come from a pointer: from a screen reader, a script, or a key of the
// page. The widget handles it when it is drawn next, as if it had been clicked or stepped. One request is
// handled per frame, in order.
#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

struct WidgetRequest {
  enum class Kind {
    kFocus,  // focuses the widget and scrolls it into sight
    kPress,
    kStep,  // by this many steps, as with arrow keys
    kSet,   // to this number of WidgetRange
  };

  std::string id;
  Kind kind = Kind::kFocus;
  double number = 0.0;
  bool ring = true;    // the widget shows its focus ring
  bool begins = true;  // starts a new gesture for Undo; false: continues the last one
};

class WidgetRequests {
 public:
  /// Steps add up. A number replaces a waiting one for the same widget. Any request replaces a waiting
  /// request for focus alone, since every request focuses its widget.
  void Add(WidgetRequest);

  void BeginFrame();
  /// The frame's request, or null.
  [[nodiscard]] const WidgetRequest* Due() const { return due_.id.empty() ? nullptr : &due_; }
  /// The frame's request if it is for this widget, or null.
  [[nodiscard]] const WidgetRequest* DueFor(std::string_view id) const;
  /// The request was handled, or its widget no longer exists.
  void EndFrame() { due_ = {}; }

  /// Whether requests are waiting.
  [[nodiscard]] bool Waiting() const { return !waiting_.empty(); }
  /// The widget that will be focused after all requests; empty: the focus stays.
  [[nodiscard]] std::string_view Last() const {
    return waiting_.empty() ? std::string_view() : waiting_.back().id;
  }

 private:
  std::deque<WidgetRequest> waiting_;
  WidgetRequest due_;
};

}  // namespace gaitsmith::shell
