// SPDX-License-Identifier: MIT
// W floats side by side, one per simulated figure. Lanes are the compiler's own vector types: +, -, *, / and
// comparisons act lane by lane and round each lane exactly as a single float. A batch of one and a batch of
// any size therefore give the same bits. Only Any() combines lanes.
#pragma once

#include <cstdint>

namespace gaitsmith {

/// The vector types of W lanes. The widths are listed one by one because gcc 12 drops the attribute when its
/// argument depends on W.
template <int W>
struct LaneTypes;
#define GAITSMITH_LANE_TYPES(W)                                   \
  template <>                                                     \
  struct LaneTypes<W> {                                           \
    typedef float F __attribute__((vector_size(4 * (W))));        \
    typedef double D __attribute__((vector_size(8 * (W))));       \
    typedef std::int32_t I __attribute__((vector_size(4 * (W)))); \
  }
GAITSMITH_LANE_TYPES(1);
GAITSMITH_LANE_TYPES(2);
GAITSMITH_LANE_TYPES(4);
GAITSMITH_LANE_TYPES(8);
GAITSMITH_LANE_TYPES(16);
#undef GAITSMITH_LANE_TYPES

/// @tparam W number of figures simulated side by side: 1, 2, 4, 8 or 16
template <int W>
struct Lane {
  using F = typename LaneTypes<W>::F;
  using D = typename LaneTypes<W>::D;
  using I = typename LaneTypes<W>::I;  // integers and masks: 0 or -1

  /// The same number in every lane. (s - 0 keeps the sign of zero, s + 0 would not.)
  static F Splat(float s) { return s - F{}; }

  /// @param mask 0 or -1 in each lane. As bit operations, because `mask ? yes : no` compares the mask again.
  static F Select(I mask, F yes, F no) {
    return reinterpret_cast<F>(Select(mask, reinterpret_cast<I>(yes), reinterpret_cast<I>(no)));
  }
  static I Select(I mask, I yes, I no) { return (yes & mask) | (no & ~mask); }

  /// a < b ? a : b. Ties and signed zeros give b, so the result is the same on every machine.
  static F Min(F a, F b) { return a < b ? a : b; }
  static F Max(F a, F b) { return a > b ? a : b; }
  static F Abs(F a) { return reinterpret_cast<F>(reinterpret_cast<I>(a) & 0x7fffffff); }

  /// Square roots, rounded correctly, as IEEE 754 demands of every machine.
  static F Sqrt(F a) {
    for (int lane = 0; lane < W; ++lane) a[lane] = __builtin_sqrtf(a[lane]);
    return a;
  }

  /// True when any lane of the mask (0 or -1) is set. This is integer work, so its order does not matter.
  static bool Any(I mask) {
#if defined(__clang__)
    return __builtin_reduce_or(mask) != 0;
#else
    typedef std::int64_t Pair __attribute__((vector_size(16), may_alias));
    std::int64_t any = 0;
    if constexpr (W % 4 == 0) {
      for (int i = 0; i < W / 4; ++i) {
        const Pair four = reinterpret_cast<const Pair*>(&mask)[i];
        any |= four[0] | four[1];
      }
    } else {
      for (int lane = 0; lane < W; ++lane) any |= mask[lane];
    }
    return any != 0;
#endif
  }

  /// Read or write one lane in place. The lane may be a variable.
  static float At(const F& a, int lane) { return reinterpret_cast<const float*>(&a)[lane]; }
  static std::int32_t At(const I& a, int lane) { return reinterpret_cast<const std::int32_t*>(&a)[lane]; }
  static void Put(F& a, int lane, float value) { reinterpret_cast<float*>(&a)[lane] = value; }

  static D ToDouble(F a) { return __builtin_convertvector(a, D); }
  static F ToFloat(D a) { return __builtin_convertvector(a, F); }
};

}  // namespace gaitsmith
