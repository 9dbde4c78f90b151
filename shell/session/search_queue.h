// SPDX-License-Identifier: MIT
// Searches that wait for their turn. Each has its whole problem with it, so that nothing which is changed
// meanwhile changes it. Who runs them is not its concern.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// A document without all that its search does not depend on: two documents of the same search are equal bit
/// for bit. The controller that it begins with, if any, is the only one that stays.
[[nodiscard]] Document SearchOf(const Document&);
/// Whether two documents' searches find the same.
[[nodiscard]] bool SameSearch(const Document&, const Document&);

/// What "five seeds" queues.
inline constexpr int kQueuedSeeds = 5;

class SearchQueue {
 public:
  static constexpr std::size_t kMost = 50;

  struct Entry {
    int number;  // its own, for as long as it waits; from 1
    Document document;
  };

  [[nodiscard]] const std::vector<Entry>& Waiting() const { return waiting_; }
  [[nodiscard]] bool Full() const { return waiting_.size() >= kMost; }

  /// Behind all others. @param document valid. @return false: there is no more room
  bool Add(const Document& document);
  /// Numbers that are not waiting any more are passed over.
  void Remove(int number);
  /// Before the one that stands before it.
  void MoveUp(int number);
  void Clear();
  /// What was removed or cleared last comes back to where it was, as far as there is room.
  void BringBack();
  /// How many that would be.
  [[nodiscard]] std::size_t Removed() const { return removed_.size(); }

  /// The next one leaves the queue.
  [[nodiscard]] std::optional<Document> TakeFirst();

 private:
  struct Gone {
    std::size_t place;
    Entry entry;
  };

  std::vector<Entry> waiting_;  // the next one first
  std::vector<Gone> removed_;   // by place
  int numbers_ = 0;             // given so far
};

/// Seeds for further searches of this document: `count` of them, upwards from its own, leaving out those
/// whose search is among `others`. Fewer when there are no more.
[[nodiscard]] std::vector<std::uint32_t> FreeSeeds(const Document&, std::span<const Document> others,
                                                   int count);

}  // namespace gaitsmith::shell
