// SPDX-License-Identifier: MIT
// Compares lanes as the compiler's vectors with lanes as fixed Eigen arrays, on arithmetic like that of a
// contact sweep: sums, products, a division, comparisons and selections. The same program runs natively and
// as WASM under Node. Prints nanoseconds per lane and sweep, and the ratio. Basis of decision 12 in
// docs/design.md.
#include <Eigen/Core>
#include <chrono>
#include <cstdio>

#include "core/numeric/lane.h"

namespace {

constexpr int kWidth = 8;
constexpr int kSweeps = 400000;

struct Vectors {
  using F = gaitsmith::Lane<kWidth>::F;
  static F Clamp(F x, F limit) {
    using L = gaitsmith::Lane<kWidth>;
    return L::Max(L::Min(x, limit), -limit);
  }
  static F Positive(F x) { return gaitsmith::Lane<kWidth>::Max(x, F{}); }
  static F Splat(float s) { return gaitsmith::Lane<kWidth>::Splat(s); }
};

struct EigenArrays {
  using F = Eigen::Array<float, kWidth, 1>;
  static F Clamp(const F& x, const F& limit) {
    const F below = (x < limit).select(x, limit);
    return (below > -limit).select(below, -limit);
  }
  static F Positive(const F& x) { return (x > 0.0f).select(x, F::Zero()); }
  static F Splat(float s) { return F::Constant(s); }
};

/// Sweeps over one contact of kWidth figures. @return nanoseconds per lane and sweep
template <class Lanes>
double Measure(float& sink) {
  using F = typename Lanes::F;
  F arm = Lanes::Splat(0.3f), velocity_y = Lanes::Splat(-1.0f), velocity_x = Lanes::Splat(0.7f);
  F spin = Lanes::Splat(0.2f), normal = Lanes::Splat(0.0f), tangent = Lanes::Splat(0.0f);
  for (int lane = 0; lane < kWidth; ++lane) arm[lane] += 0.05f * static_cast<float>(lane);
  const auto start = std::chrono::steady_clock::now();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const F mass = 1.0f / (0.2f + arm * arm * 0.6f);
    const F old_normal = normal, old_tangent = tangent;
    normal = Lanes::Positive(normal - mass * (velocity_y + spin * arm + 0.01f));
    tangent = Lanes::Clamp(tangent - mass * (velocity_x - spin * arm), 0.8f * normal);
    velocity_y += 0.2f * (normal - old_normal) - 0.0981f;
    velocity_x += 0.2f * (tangent - old_tangent) + 0.01f;
    spin += 0.6f * arm * (normal - old_normal) - 0.3f * spin;
  }
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  for (int lane = 0; lane < kWidth; ++lane) sink += normal[lane] + tangent[lane] + spin[lane];
  return spent.count() / kSweeps / kWidth;
}

}  // namespace

int main() {
  float sink = 0.0f;
  double vectors = 1e9, arrays = 1e9;
  for (int turn = 0; turn < 7; ++turn) {
    vectors = std::min(vectors, Measure<Vectors>(sink));
    arrays = std::min(arrays, Measure<EigenArrays>(sink));
  }
  std::printf("compiler vectors %.3f ns, Eigen arrays %.3f ns, ratio %.2f (sink %g)\n", vectors, arrays,
              arrays / vectors, static_cast<double>(sink));
  return 0;
}
