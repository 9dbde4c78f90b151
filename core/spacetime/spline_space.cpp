// SPDX-License-Identifier: MIT
#include "core/spacetime/spline_space.h"

namespace gaitsmith {

SplineSpace::SplineSpace(int degree, const std::vector<double>& breaks, const std::vector<int>& order)
    : degree_(degree) {
  const std::size_t pieces = breaks.size() - 1;
  knots_.assign(static_cast<std::size_t>(degree) + 1, breaks.front());
  for (std::size_t i = 0; i < pieces; ++i) {
    span_.push_back(static_cast<int>(knots_.size()) - 1);
    const bool last = i + 1 == pieces;
    const int times = last ? degree + 1 : degree + 1 - order[i];
    knots_.insert(knots_.end(), static_cast<std::size_t>(times), breaks[i + 1]);
  }
}

SplineShares SplineSpace::At(int piece, double time, int derivative) const {
  const int span = span_[static_cast<std::size_t>(piece)];
  const auto knot = [&](int i) { return knots_[static_cast<std::size_t>(i)]; };
  SplineShares at{span - degree_, degree_ + 1};
  if (derivative > degree_) return at;
  // The basis of a lower degree, by Cox and de Boor's recursion.
  const int lower = degree_ - derivative;
  std::array<double, kMaxDegree + 2> basis{};
  basis[0] = 1.0;
  for (int d = 1; d <= lower; ++d) {
    double carried = 0.0;
    for (int i = 0; i < d; ++i) {
      const double left = knot(span + 1 - d + i), right = knot(span + 1 + i);
      const double part = basis[static_cast<std::size_t>(i)] / (right - left);
      basis[static_cast<std::size_t>(i)] = carried + (right - time) * part;
      carried = (time - left) * part;
    }
    basis[static_cast<std::size_t>(d)] = carried;
  }
  // A derivative's coefficients are differences of the spline's own.
  for (int d = lower + 1; d <= degree_; ++d) {
    double carried = 0.0;
    for (int i = 0; i < d; ++i) {
      const double left = knot(span + 1 - d + i), right = knot(span + 1 + i);
      const double part = d * basis[static_cast<std::size_t>(i)] / (right - left);
      basis[static_cast<std::size_t>(i)] = carried - part;
      carried = part;
    }
    basis[static_cast<std::size_t>(d)] = carried;
  }
  for (int i = 0; i <= degree_; ++i)
    at.share[static_cast<std::size_t>(i)] = basis[static_cast<std::size_t>(i)];
  return at;
}

SplineShares SplineSpace::JumpAt(int piece, double time, int derivative) const {
  const SplineShares before = At(piece - 1, time, derivative), after = At(piece, time, derivative);
  SplineShares jump{before.first, after.first + after.count - before.first};
  for (int i = 0; i < before.count; ++i)
    jump.share[static_cast<std::size_t>(i)] -= before.share[static_cast<std::size_t>(i)];
  const auto shift = static_cast<std::size_t>(after.first - before.first);
  for (std::size_t i = 0; i < static_cast<std::size_t>(after.count); ++i)
    jump.share[shift + i] += after.share[i];
  return jump;
}

double SplineSpace::Centre(int coefficient) const {
  if (degree_ == 0) {
    const auto at = static_cast<std::size_t>(coefficient);
    return 0.5 * (knots_[at] + knots_[at + 1]);
  }
  double sum = 0.0;
  const auto before = static_cast<std::size_t>(coefficient);
  for (std::size_t i = 1; i <= static_cast<std::size_t>(degree_); ++i) sum += knots_[before + i];
  return sum / degree_;
}

}  // namespace gaitsmith
