// SPDX-License-Identifier: MIT
#include "shell/workspace/history.h"

#include <algorithm>
#include <utility>

#include "core/document/binary.h"
#include "core/document/link.h"

namespace gaitsmith::shell {

History::Bytes History::Packed(Document document) {
  document.view = {};
  return EncodeBinary(document);
}

std::optional<Document> History::Unpacked(const Bytes& bytes, const View& view) {
  auto document = DecodeBinary(bytes);
  if (!document) return std::nullopt;
  document->view = view;
  return std::move(*document);
}

void History::Keep(const Document& before, int occasion) {
  if (occasion == occasion_) return;
  occasion_ = occasion;
  future_.clear();
  Bytes bytes = Packed(before);
  if (!past_.empty() && past_.back() == bytes) return;  // the previous step changed nothing
  past_bytes_ += bytes.size();
  past_.push_back(std::move(bytes));
  Forget();
}

void History::Forget() {
  // The last step stays however large it is, so that one step can always be undone.
  while (past_.size() > limits_.steps || (past_.size() > 1 && past_bytes_ > limits_.bytes)) {
    past_bytes_ -= past_.front().size();
    past_.pop_front();
  }
}

bool History::CanUndo(const Document& present) const {
  if (past_.empty()) return false;
  return past_.size() > 1 || past_.back() != Packed(present);
}

std::optional<Document> History::Back(const Document& present) {
  occasion_ = 0;
  Bytes now = Packed(present);
  while (!past_.empty()) {
    const Bytes before = std::move(past_.back());
    past_bytes_ -= before.size();
    past_.pop_back();
    if (before == now) continue;
    future_.push_back(std::move(now));
    return Unpacked(before, present.view);
  }
  return std::nullopt;
}

std::optional<Document> History::Forward(const Document& present) {
  if (future_.empty()) return std::nullopt;
  occasion_ = 0;
  const Bytes after = std::move(future_.back());
  future_.pop_back();
  past_.push_back(Packed(present));
  past_bytes_ += past_.back().size();
  return Unpacked(after, present.view);
}

void History::Clear() {
  past_.clear();
  future_.clear();
  past_bytes_ = 0;
  occasion_ = 0;
}

History::Stored History::Store(std::size_t letters) const {
  Stored stored;
  const auto take = [&letters](const auto& steps, std::vector<std::string>& payloads) {
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      std::string payload = ToBase64Url(*step);
      if (payload.size() > letters) break;
      letters -= payload.size();
      payloads.push_back(std::move(payload));
    }
    std::ranges::reverse(payloads);
  };
  take(past_, stored.past);
  take(future_, stored.future);
  return stored;
}

bool History::Restore(const Stored& stored) {
  History restored(limits_);
  const auto read = [](const std::vector<std::string>& payloads, auto& steps) {
    for (const std::string& payload : payloads) {
      const auto document = DecodeLink(payload);
      if (!document) return false;
      steps.push_back(Packed(*document));
    }
    return true;
  };
  if (!read(stored.past, restored.past_) || !read(stored.future, restored.future_)) return false;
  for (const Bytes& step : restored.past_) restored.past_bytes_ += step.size();
  restored.Forget();
  *this = std::move(restored);
  return true;
}

}  // namespace gaitsmith::shell
