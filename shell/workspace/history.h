// SPDX-License-Identifier: MIT
// Past and future of a document, for Undo and Redo. Bounded in steps and in bytes: the oldest step is removed
// first. Excludes the view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::shell {

class History {
 public:
  struct Limits {
    std::size_t steps = 200;
    std::size_t bytes = std::size_t{4} << 20;  // limit of the past; a document takes a few hundred bytes
  };

  History() = default;
  explicit History(const Limits& limits) : limits_(limits) {}

  /// Begins a step with the document before a change, and forgets the undone steps.
  /// @param occasion  identifies the cause of the change, such as a drag or a search; not 0. Consecutive
  /// changes with the same occasion are one step
  void Keep(const Document& before, int occasion);

  [[nodiscard]] bool CanUndo(const Document& present) const;
  [[nodiscard]] bool CanRedo() const { return !future_.empty(); }

  /// The document one step back, with the present view; nothing at the first step. Steps without a change are
  /// skipped.
  [[nodiscard]] std::optional<Document> Back(const Document& present);
  [[nodiscard]] std::optional<Document> Forward(const Document& present);

  void Clear();

  /// Steps as payloads that DecodeLink reads, for storage. The nearest to the present come last.
  struct Stored {
    std::vector<std::string> past, future;
  };
  /// The nearest steps whose payloads fit into `letters`, those of the past first.
  [[nodiscard]] Stored Store(std::size_t letters) const;
  /// Replaces all steps. @return false: one of them is damaged, and nothing has changed
  bool Restore(const Stored&);

 private:
  using Bytes = std::vector<std::uint8_t>;
  static Bytes Packed(Document document);
  static std::optional<Document> Unpacked(const Bytes& bytes, const View& view);
  void Forget();

  Limits limits_;
  std::deque<Bytes> past_;  // the newest last
  std::vector<Bytes> future_;
  std::size_t past_bytes_ = 0;
  int occasion_ = 0;  // of the newest step; 0: the next change begins a new step
};

}  // namespace gaitsmith::shell
