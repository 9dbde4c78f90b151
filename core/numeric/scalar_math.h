// SPDX-License-Identifier: MIT
// Our own sin, cos, exp and log. Libraries differ in the last bit, and motions with contacts are chaotic: a
// difference of one bit becomes a different motion within seconds. These functions use only + - * / and
// integer operations, so they give the same bits on every compiler, optimisation level and browser.
// tests/core/numeric/scalar_math_test checks the error bounds below.
#pragma once

#include <cstdint>

#include "core/numeric/lane.h"

namespace gaitsmith {

inline constexpr double kPi = 3.14159265358979323846;

/// sin(x) and cos(x), x in radians. For |x| <= 8192 the absolute error is below 1.2e-7. For larger x, NaN and
/// infinity the result is meaningless but the call is safe. Argument reduction after [Cody Waite 1980],
/// polynomials of [Moshier 1992] (single precision).
template <int W>
inline void SinCos(typename Lane<W>::F x, typename Lane<W>::F& sine, typename Lane<W>::F& cosine) {
  using F = typename Lane<W>::F;
  using I = typename Lane<W>::I;
  constexpr float kTwoOverPi = 0.636619772367581f;
  constexpr float kRound = 12582912.0f;  // 1.5 * 2^23: adding it leaves the nearest integer in the low bits
  // pi/2 in three parts. The first two have trailing zero bits, so that n * part is exact for |n| < 2^13.
  constexpr float kHalfPi1 = 1.5703125f;
  constexpr float kHalfPi2 = 4.837512969970703125e-4f;
  constexpr float kHalfPi3 = 7.549789948768648e-8f;

  const F shifted = x * kTwoOverPi + kRound;
  const F n = shifted - kRound;
  const I quadrant = reinterpret_cast<I>(shifted);
  const F r = ((x - n * kHalfPi1) - n * kHalfPi2) - n * kHalfPi3;
  const F z = r * r;
  const F s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
  const F c = ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
              0.5f * z + 1.0f;

  // Quadrants 1 and 3 swap sine and cosine. Sine is negative in quadrants 2 and 3, cosine in 1 and 2.
  const I swap = (quadrant & 1) != 0;
  const I sine_sign = (quadrant & 2) << 30;
  const I cosine_sign = ((quadrant + 1) & 2) << 30;
  sine = reinterpret_cast<F>(reinterpret_cast<I>(swap ? c : s) ^ sine_sign);
  cosine = reinterpret_cast<F>(reinterpret_cast<I>(swap ? s : c) ^ cosine_sign);
}

/// Turns a direction by a small angle [rad], using a series. For |angle| <= 0.5 the absolute error is below
/// 2e-7.
template <int W>
inline void Turn(typename Lane<W>::F angle, typename Lane<W>::F& sine, typename Lane<W>::F& cosine) {
  using F = typename Lane<W>::F;
  const F z = angle * angle;
  const F s = angle * (1.0f - z * (1.0f / 6.0f) * (1.0f - z * (1.0f / 20.0f) * (1.0f - z * (1.0f / 42.0f))));
  const F c = 1.0f - z * 0.5f * (1.0f - z * (1.0f / 12.0f) * (1.0f - z * (1.0f / 30.0f)));
  const F turned = sine * c + cosine * s;
  cosine = cosine * c - sine * s;
  sine = turned;
}

/// What a turn by a small angle adds to a direction, as Turn, but accurate however small [rad].
template <int W>
inline void TurnedBy(typename Lane<W>::F angle, typename Lane<W>::F sine, typename Lane<W>::F cosine,
                     typename Lane<W>::F& more_sine, typename Lane<W>::F& more_cosine) {
  using F = typename Lane<W>::F;
  const F z = angle * angle;
  const F s = angle * (1.0f - z * (1.0f / 6.0f) * (1.0f - z * (1.0f / 20.0f) * (1.0f - z * (1.0f / 42.0f))));
  const F less = z * 0.5f * (1.0f - z * (1.0f / 12.0f) * (1.0f - z * (1.0f / 30.0f)));
  more_sine = cosine * s - sine * less;
  more_cosine = -(sine * s) - cosine * less;
}

/// sin and cos of an accumulated angle in double precision [rad]. Whole turns are removed first.
template <int W>
inline void SinCosOfTurn(typename Lane<W>::D turn, typename Lane<W>::F& sine, typename Lane<W>::F& cosine) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to the nearest integer
  const typename Lane<W>::D whole = (turn * (0.5 / kPi) + kRound) - kRound;
  SinCos<W>(Lane<W>::ToFloat(turn - whole * (2.0 * kPi)), sine, cosine);
}

struct SineCosine {
  float sine;
  float cosine;
};

/// SinCos for one number.
[[nodiscard]] SineCosine SinCos(float x_rad);

/// The angle of a direction [rad], (-pi, pi]; of (0, 0) it is 0. The absolute error is below 5e-7 for
/// directions of any length. Polynomial of [Moshier 1992] (single precision).
[[nodiscard]] float Atan2(float sine, float cosine);

struct FineSineCosine {
  double sine;
  double cosine;
};

/// sin(x) and cos(x) in double precision. For |x| <= 8192 the absolute error is below 1e-15. Polynomials of
/// [Moshier 1992]. @param x_rad finite, |x| <= 3e9
[[nodiscard]] FineSineCosine FineSinCos(double x_rad);

/// e^x. For |x| <= 700 the relative error is below 1e-15. Below -700 the result is 0, above 700 it is e^700.
[[nodiscard]] double Exp(double x);

/// Natural logarithm of x in [1e-300, 1e300]. The absolute error is below 1e-14.
[[nodiscard]] double Log(double x);

}  // namespace gaitsmith
