// SPDX-License-Identifier: MIT
// Packs numbers into the fewest bits that their range needs, and unpacks them. The least significant bit
// comes first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gaitsmith {

class BitWriter {
 public:
  /// @param bits [0, 64]; value must fit
  void Put(std::uint64_t value, int bits) {
    for (int i = 0; i < bits; ++i) {
      if (used_ == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | (((value >> i) & 1u) << used_));
      used_ = (used_ + 1) % 8;
    }
  }
  /// An index into a table that may grow. An index below 2^bits - 1 takes `bits` bits. A larger one is
  /// written as `bits` ones and its excess in 8 more bits.
  /// @param index [0, LongestTable(bits))
  void PutIndex(std::size_t index, int bits) {
    const std::size_t escape = (std::size_t{1} << bits) - 1;
    Put(std::min(index, escape), bits);
    if (index >= escape) Put(index - escape, 8);
  }
  [[nodiscard]] const std::vector<std::uint8_t>& Bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  int used_ = 0;  // bits used in the last byte, 0 when it is full
};

class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// The next bits as a number. Past the end it reads zeros, and Overrun() becomes true.
  std::uint64_t Take(int bits) {
    std::uint64_t value = 0;
    for (int i = 0; i < bits; ++i, ++at_) {
      if (at_ / 8 >= bytes_.size()) {
        overrun_ = true;
        continue;
      }
      value |= static_cast<std::uint64_t>((bytes_[at_ / 8] >> (at_ % 8)) & 1u) << i;
    }
    return value;
  }
  /// Reads an index that BitWriter::PutIndex wrote.
  std::size_t TakeIndex(int bits) {
    const std::size_t escape = (std::size_t{1} << bits) - 1;
    const auto index = static_cast<std::size_t>(Take(bits));
    return index < escape ? index : escape + static_cast<std::size_t>(Take(8));
  }
  [[nodiscard]] bool Overrun() const { return overrun_; }
  /// True when every byte has been read and the unread bits of the last byte are zero.
  [[nodiscard]] bool AtEnd() {
    const std::size_t left = bytes_.size() * 8 - (overrun_ ? bytes_.size() * 8 : at_);
    return !overrun_ && left < 8 && Take(static_cast<int>(left)) == 0;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool overrun_ = false;
};

/// Rows of the longest table whose indices PutIndex can write with this number of bits.
[[nodiscard]] constexpr std::size_t LongestTable(int bits) { return (std::size_t{1} << bits) - 1 + 256; }

/// Bits needed to distinguish `count` values.
[[nodiscard]] constexpr int BitsFor(std::uint64_t count) {
  int bits = 0;
  while (bits < 64 && (std::uint64_t{1} << bits) < count) ++bits;
  return bits;
}

}  // namespace gaitsmith
