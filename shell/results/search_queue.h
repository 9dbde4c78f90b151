// SPDX-License-Identifier: MIT
// Waiting searches. Each holds a copy of its whole problem, so later edits do not change it. QueueRun runs
// them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// A copy reduced to what its search depends on, so that documents with the same search are equal bit for
/// bit. Keeps only the controller to start from, if any.
[[nodiscard]] Document SearchOf(const Document&);
/// Whether two documents' searches find the same motion.
[[nodiscard]] bool SameSearch(const Document&, const Document&);

/// Number of searches that "five seeds" queues.
inline constexpr int kQueuedSeeds = 5;

class SearchQueue {
 public:
  static constexpr std::size_t kMax = 50;

  struct Entry {
    int number;  // unique among waiting searches; from 1
    Document document;
  };

  /// Called after every change of the list.
  std::function<void()> on_change;

  [[nodiscard]] const std::vector<Entry>& Waiting() const { return waiting_; }
  [[nodiscard]] bool Full() const { return waiting_.size() >= kMax; }

  /// Adds a document at the end. @param document valid. @return false: the queue is full
  bool Add(const Document& document);
  /// Adds the searches of an earlier visit. One of them may have been running then, so they may be one more
  /// than kMax. Further ones are ignored.
  void Restore(std::span<const Document> searches);
  /// Ignores numbers that no longer wait.
  void Remove(int number);
  /// Swaps a search with the one before it.
  void MoveUp(int number);
  void Clear();
  /// Restores the searches removed or cleared last to their places, as far as there is room.
  void BringBack();
  /// Number of searches that BringBack would restore.
  [[nodiscard]] std::size_t Removed() const { return removed_.size(); }

  /// Removes and returns the next search.
  [[nodiscard]] std::optional<Document> TakeFirst();

 private:
  void Notify() const {
    if (on_change) on_change();
  }
  struct Gone {
    std::size_t place;
    Entry entry;
  };

  std::vector<Entry> waiting_;  // the next one first
  std::vector<Gone> removed_;   // by place
  int numbers_ = 0;             // last number assigned
};

/// Seeds for `count` further searches of this document, counting up from its own and skipping those whose
/// search is among `others`. May be fewer at the end of the range.
[[nodiscard]] std::vector<std::uint32_t> FreeSeeds(const Document&, std::span<const Document> others,
                                                   int count);

}  // namespace gaitsmith::shell
