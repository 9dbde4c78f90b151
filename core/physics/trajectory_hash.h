// SPDX-License-Identifier: MIT
// A 64-bit fingerprint of a motion: every position of every step, bit by bit. Equal hashes mean equal
// motions. Each link contains the hash, so that a page can detect a replay that differs.
#pragma once

#include <bit>
#include <cstdint>

namespace gaitsmith {

class TrajectoryHash {
 public:
  void Add(float value) { AddWord(value == value ? std::bit_cast<std::uint32_t>(value) : kNotANumber); }
  void Add(double value) { AddWord(value == value ? std::bit_cast<std::uint64_t>(value) : kNotANumber); }
  [[nodiscard]] std::uint64_t Value() const { return hash_; }

 private:
  /// Processors differ in the bits of NaN. All NaNs count as this one.
  static constexpr std::uint64_t kNotANumber = 0x7ff8000000000000ULL;

  /// FNV-1a [Fowler Noll Vo 1991] over 64-bit words, with a shift that carries high bits down.
  void AddWord(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x00000100000001b3ULL;
    hash_ ^= hash_ >> 29;
  }
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace gaitsmith
