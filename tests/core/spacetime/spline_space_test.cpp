// SPDX-License-Identifier: MIT
#include "core/spacetime/spline_space.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <vector>

namespace gaitsmith::test {

namespace {

using Catch::Matchers::WithinAbs;

const std::vector<double> kBreaks{0.0, 0.3, 1.0, 1.4, 2.5};

double SumOf(const SplineShares& shares, const std::vector<double>& coefficients) {
  double sum = 0.0;
  const auto first = static_cast<std::size_t>(shares.first);
  for (std::size_t i = 0; i < static_cast<std::size_t>(shares.count); ++i)
    sum += shares.share[i] * coefficients[first + i];
  return sum;
}

std::vector<double> SomeCoefficients(const SplineSpace& space) {
  std::vector<double> coefficients;
  coefficients.reserve(static_cast<std::size_t>(space.Size()));
  for (int i = 0; i < space.Size(); ++i) coefficients.push_back(std::sin(1.7 * i) + 0.1 * i);
  return coefficients;
}

}  // namespace

TEST_CASE("the shares of a spline's value add up to one, those of its derivatives to none", "[spacetime]") {
  for (const int degree : {0, 1, 3, 5}) {
    const SplineSpace space(degree, kBreaks, std::vector<int>(4, degree));
    CHECK(space.Size() == 4 + degree);
    for (int piece = 0; piece < 4; ++piece) {
      const double time =
          0.5 * (kBreaks[static_cast<std::size_t>(piece)] + kBreaks[static_cast<std::size_t>(piece) + 1]);
      for (int order = 0; order < 3; ++order) {
        const double sum = SumOf(space.At(piece, time, order),
                                 std::vector<double>(static_cast<std::size_t>(space.Size()), 1.0));
        CHECK_THAT(sum, WithinAbs(order == 0 ? 1.0 : 0.0, 1e-12));
      }
    }
  }
}

TEST_CASE("a spline's derivatives are those of its values", "[spacetime]") {
  const SplineSpace space(5, kBreaks, {5, 2, 1, 5});
  const std::vector<double> c = SomeCoefficients(space);
  constexpr double kH = 1e-5;
  for (int piece = 0; piece < 4; ++piece) {
    const double time =
        0.6 * kBreaks[static_cast<std::size_t>(piece)] + 0.4 * kBreaks[static_cast<std::size_t>(piece) + 1];
    for (int order = 0; order < 2; ++order) {
      const double slope =
          (SumOf(space.At(piece, time + kH, order), c) - SumOf(space.At(piece, time - kH, order), c)) /
          (2 * kH);
      CHECK_THAT(SumOf(space.At(piece, time, order + 1), c), WithinAbs(slope, 1e-5));
    }
  }
}

TEST_CASE("a spline is smooth but for the breaks it was made with", "[spacetime]") {
  const SplineSpace space(5, kBreaks, {5, 2, 1, 5});
  const std::vector<double> c = SomeCoefficients(space);
  const auto jump = [&](int piece, int order) {
    return std::abs(SumOf(space.JumpAt(piece, kBreaks[static_cast<std::size_t>(piece)], order), c));
  };
  for (int order = 0; order < 3; ++order) CHECK(jump(1, order) < 1e-9);
  for (int order = 0; order < 2; ++order) CHECK(jump(2, order) < 1e-9);
  CHECK(jump(2, 2) > 1e-2);
  CHECK(jump(3, 0) < 1e-9);
  CHECK(jump(3, 1) > 1e-2);
}

TEST_CASE("a spline whose coefficients are their centres is time itself", "[spacetime]") {
  const SplineSpace space(3, kBreaks, {3, 2, 1, 3});
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(space.Size()));
  for (int i = 0; i < space.Size(); ++i) centres.push_back(space.Centre(i));
  CHECK_THAT(SumOf(space.At(1, 0.77, 0), centres), WithinAbs(0.77, 1e-12));
  CHECK_THAT(SumOf(space.At(3, 2.0, 1), centres), WithinAbs(1.0, 1e-12));
}

}  // namespace gaitsmith::test
