// SPDX-License-Identifier: MIT
// Counter-based random numbers: a stream depends on its key alone. Proposal j of individual i is therefore
// the same on any thread, at any time, however often it is computed. The generator is SplitMix64
// [Steele et al. 2014]. The distributions are our own, because those of the standard library differ between
// vendors.
#pragma once

#include <cstdint>

namespace gaitsmith {

class RandomStream {
 public:
  /// A separate stream for every (seed, individual, proposal).
  RandomStream(std::uint64_t seed, std::uint64_t individual, std::uint64_t proposal)
      : state_(Mix(Mix(Mix(seed + kStride) + individual + kStride) + proposal + kStride)) {}

  std::uint64_t Next() { return Mix(state_ += kStride); }

  /// Uniform integer in [0, bound), bound > 0, by multiplication with rejection, free of bias [Lemire 2019].
  std::uint32_t Below(std::uint32_t bound) {
    const std::uint32_t reject_below = (0u - bound) % bound;
    for (;;) {
      const std::uint64_t product = (Next() >> 32) * bound;
      if (static_cast<std::uint32_t>(product) >= reject_below)
        return static_cast<std::uint32_t>(product >> 32);
    }
  }

  /// True with probability p, p in [0, 1].
  bool Chance(double p) { return Uniform() < p; }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1p-53; }

  /// A uniform point of the 16-bit gene grid.
  std::uint16_t Gene() { return static_cast<std::uint16_t>(Next() >> 48); }

  /// Approximately standard normal: the sum of twelve uniform numbers (Irwin-Hall), with mean 0, variance 1
  /// and magnitude at most 6. It uses additions only.
  double Normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += Uniform();
    return sum;
  }

 private:
  static constexpr std::uint64_t kStride = 0x9e3779b97f4a7c15ULL;
  static std::uint64_t Mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace gaitsmith
