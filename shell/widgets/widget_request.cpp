// SPDX-License-Identifier: MIT
#include "shell/widgets/widget_request.h"

#include <utility>

namespace gaitsmith::shell {

void WidgetRequests::Add(WidgetRequest request) {
  if (!waiting_.empty()) {
    WidgetRequest& last = waiting_.back();
    const bool same = last.id == request.id && last.kind == request.kind;
    const bool overtaken = last.kind == WidgetRequest::Kind::kFocus;
    if (same && request.kind == WidgetRequest::Kind::kStep) {
      last.number += request.number;
      return;
    }
    if (overtaken || (same && request.kind == WidgetRequest::Kind::kSet)) {
      request.begins |= last.begins;
      last = std::move(request);
      return;
    }
  }
  waiting_.push_back(std::move(request));
}

void WidgetRequests::BeginFrame() {
  due_ = {};
  if (waiting_.empty()) return;
  due_ = std::move(waiting_.front());
  waiting_.pop_front();
}

const WidgetRequest* WidgetRequests::DueFor(std::string_view id) const {
  return !due_.id.empty() && due_.id == id ? &due_ : nullptr;
}

}  // namespace gaitsmith::shell
