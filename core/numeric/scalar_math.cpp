// SPDX-License-Identifier: MIT
#include "core/numeric/scalar_math.h"

#include <bit>

namespace gaitsmith {

namespace {
constexpr double kLn2High = 6.93147180369123816490e-01;  // ln 2 with 32 trailing zero bits
constexpr double kLn2Low = 1.90821492927058770002e-10;   // ln 2 - kLn2High
constexpr int kExponentBias = 1023;
constexpr int kMantissaBits = 52;

double PowerOfTwo(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kExponentBias) << kMantissaBits);
}
}  // namespace

SineCosine SinCos(float x_rad) {
  Lane<1>::F sine, cosine;
  SinCos<1>(Lane<1>::F{x_rad}, sine, cosine);
  return {sine[0], cosine[0]};
}

float Atan2(float sine, float cosine) {
  const float up = sine < 0.0f ? -sine : sine, along = cosine < 0.0f ? -cosine : cosine;
  const float more = up > along ? up : along, less = up > along ? along : up;
  if (!(more > 0.0f)) return 0.0f;
  constexpr float kTanEighth = 0.41421356f;  // of pi / 8
  constexpr float kQuarter = 0.78539816f, kHalf = 1.5707963f, kWhole = 3.1415927f;
  const float ratio = less / more;
  const bool steep = ratio > kTanEighth;
  const float r = steep ? (ratio - 1.0f) / (ratio + 1.0f) : ratio;
  const float z = r * r;
  const float series =
      (((8.05374449538e-2f * z - 1.38776856032e-1f) * z + 1.99777106478e-1f) * z - 3.33329491539e-1f) * z *
          r +
      r;
  float angle = steep ? kQuarter + series : series;
  if (up > along) angle = kHalf - angle;
  if (cosine < 0.0f) angle = kWhole - angle;
  return sine < 0.0f ? -angle : angle;
}

FineSineCosine FineSinCos(double x_rad) {
  // pi/2 in three parts. The first two have trailing zero bits, so that n * part is exact.
  constexpr double kHalfPi1 = 2 * 7.85398125648498535156e-1;
  constexpr double kHalfPi2 = 2 * 3.77489470793079817668e-8;
  constexpr double kHalfPi3 = 2 * 2.69515142907905952645e-15;
  const double scaled = x_rad * (2.0 / kPi);
  const int quadrant = static_cast<int>(scaled + (scaled < 0 ? -0.5 : 0.5));
  const double r = ((x_rad - quadrant * kHalfPi1) - quadrant * kHalfPi2) - quadrant * kHalfPi3;
  const double z = r * r;
  const double s =
      r +
      r * z *
          (((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z + 2.75573136213857245213e-6) *
                 z -
             1.98412698295895385996e-4) *
                z +
            8.33333333332211858878e-3) *
               z -
           1.66666666666666307295e-1);
  const double c =
      1.0 - 0.5 * z +
      z * z *
          (((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z - 2.75573141792967388112e-7) *
                 z +
             2.48015872888517045348e-5) *
                z -
            1.38888888888730564116e-3) *
               z +
           4.16666666666665929218e-2);
  switch (quadrant & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double Exp(double x) {
  if (!(x > -700.0)) return 0.0;
  if (x > 700.0) x = 700.0;
  // x = k ln 2 + r with |r| <= ln 2 / 2, so e^x = 2^k e^r.
  const double scaled = x * 1.4426950408889634;
  const int k = static_cast<int>(scaled + (scaled < 0 ? -0.5 : 0.5));
  const double r = (x - k * kLn2High) - k * kLn2Low;
  // Taylor series by Horner's rule. The terms after the 14th sum to less than 1e-17.
  double sum = 1.0;
  for (int term = 14; term >= 1; --term) sum = 1.0 + sum * r / term;
  return sum * PowerOfTwo(k);
}

double Log(double x) {
  // x = 2^k m with m in [sqrt(1/2), sqrt(2)), and ln m = 2 artanh((m - 1) / (m + 1)).
  const auto bits = std::bit_cast<std::uint64_t>(x);
  int k = static_cast<int>(bits >> kMantissaBits) - kExponentBias;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) |
                                   (static_cast<std::uint64_t>(kExponentBias) << kMantissaBits));
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++k;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double sum = 0.0;
  for (int odd = 25; odd >= 1; odd -= 2) sum = sum * s2 + 1.0 / odd;
  return k * kLn2High + (2.0 * s * sum + k * kLn2Low);
}

}  // namespace gaitsmith
