// SPDX-License-Identifier: MIT
// Requests to widgets from a screen reader, a script, or a key on the page. A widget handles a request when
// it is next drawn, as if it had been clicked or stepped. One request is handled per frame, in order.
#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

struct WidgetRequest {
  enum class Kind {
    kFocus,  // focuses the widget and scrolls it into view
    kPress,
    kStep,  // by this many steps, as with arrow keys
    kSet,   // to this number in WidgetRange
  };

  std::string id;
  Kind kind = Kind::kFocus;
  double number = 0.0;
  bool ring = true;    // the widget shows its focus ring
  bool begins = true;  // starts a new gesture for Undo; false: continues the last one
};

class WidgetRequests {
 public:
  /// Consecutive steps add up, and a number replaces a pending one for the same widget. Every request
  /// replaces a pending kFocus, since all requests focus their widget.
  void Add(WidgetRequest);

  void BeginFrame();
  /// The frame's request, or null.
  [[nodiscard]] const WidgetRequest* Due() const { return due_.id.empty() ? nullptr : &due_; }
  /// The frame's request if it is for this widget, or null.
  [[nodiscard]] const WidgetRequest* DueFor(std::string_view id) const;
  /// Drops the frame's request, handled or not.
  void EndFrame() { due_ = {}; }

  /// Whether requests are waiting.
  [[nodiscard]] bool Waiting() const { return !waiting_.empty(); }
  /// The widget that all pending requests will leave focused; empty: no change.
  [[nodiscard]] std::string_view Last() const {
    return waiting_.empty() ? std::string_view() : waiting_.back().id;
  }

 private:
  std::deque<WidgetRequest> waiting_;
  WidgetRequest due_;
};

}  // namespace gaitsmith::shell
