// SPDX-License-Identifier: MIT
// B-splines over a stretch of time whose smoothness may break at some instants, as a motion's does where a
// foot lands [DeBoor 1978].
#pragma once

#include <array>
#include <vector>

namespace gaitsmith {

inline constexpr int kMaxDegree = 5;

/// The shares of neighbouring coefficients in a spline's value or derivative at one instant, or in a jump of
/// it between two pieces.
struct SplineShares {
  int first = 0;  // coefficient
  int count = 0;
  std::array<double, 2 * kMaxDegree + 1> share{};
};

class SplineSpace {
 public:
  /// @param degree   [0, kMaxDegree]
  /// @param breaks   of the pieces, rising, at least two; all spaces over the same breaks number their pieces
  /// alike
  /// @param order    of the derivative that may jump at each inner break, [0, degree]: 1 lets the speed jump
  SplineSpace(int degree, const std::vector<double>& breaks, const std::vector<int>& order);

  [[nodiscard]] int Size() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
  [[nodiscard]] int Degree() const { return degree_; }
  /// @param piece      whose side counts where a derivative jumps
  /// @param derivative of this order, [0, 2]
  [[nodiscard]] SplineShares At(int piece, double time, int derivative) const;
  /// What a derivative is at the beginning of a piece less what it was at the end of the piece before.
  [[nodiscard]] SplineShares JumpAt(int piece, double time, int derivative) const;
  /// The first coefficient that matters in a piece.
  [[nodiscard]] int FirstOf(int piece) const { return span_[static_cast<std::size_t>(piece)] - degree_; }
  /// Where a coefficient matters most: the mean of its inner knots.
  [[nodiscard]] double Centre(int coefficient) const;

 private:
  int degree_;
  std::vector<double> knots_;
  std::vector<int> span_;  // index of the knot where each piece begins
};

}  // namespace gaitsmith
