// SPDX-License-Identifier: MIT
#include "core/physics/mechanism.h"

#include "core/numeric/scalar_math.h"
#include "core/physics/rod_multiples.h"
#include "core/world/environment.h"

namespace gaitsmith {

namespace {

/// Joint limits are this firm, in effective inertias. Firmer ones lose no less energy, and ten times firmer
/// ones gain some.
constexpr float kStopFirmness = 1000.0f;

}  // namespace

Mechanism::Mechanism(const Skeleton& skeleton) : Skeleton(skeleton) {
  const auto n = static_cast<std::size_t>(rods);
  const RodMultiples multiples(*this);
  for (std::size_t j = 0; j < n; ++j) {
    centre[j] = static_cast<float>(multiples.mean[j]);
    for (std::size_t k = 0; k < n; ++k) coupling[j][k] = static_cast<float>(multiples.coupling[j][k]);
  }
  // A limb's own end is its index + 1. The root has its start as well.
  for (std::size_t i = n; i-- > 0;) {
    beyond[i] |= 1 << (i + 1);
    if (i > 0) beyond[static_cast<std::size_t>(limbs[i].parent)] |= beyond[i];
  }
  beyond[0] |= 1;
}

Mechanism::Mechanism(const Figure& figure) : Mechanism(Skeleton(figure)) {
  const auto n = static_cast<std::size_t>(rods);
  // The inertia that a joint feels in the drawn pose, the root free: M_jj - M_j0^2 / M_00.
  std::array<double, kMaxRods> direction{};
  for (std::size_t i = 1; i < n; ++i)
    direction[i] =
        direction[static_cast<std::size_t>(limbs[i].parent)] + static_cast<double>(limbs[i].rest_rad);
  const auto inertia = [&](std::size_t one, std::size_t two) {
    double sum = 0.0;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        if ((beyond[one] >> (a + 1) & beyond[two] >> (b + 1) & 1) == 0) continue;
        const auto turned = static_cast<float>(direction[a] - direction[b]);
        sum += static_cast<double>(coupling[a][b]) * static_cast<double>(SinCos(turned).cosine);
      }
    }
    return sum;
  };
  const double whole = inertia(0, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const double mixed = inertia(i, 0);
    const auto effective = static_cast<float>(inertia(i, i) - mixed * mixed / whole);
    const Rod& rod = figure.rods[static_cast<std::size_t>(limbs[i].drawn)];
    torque_nm[i] = rod.strength * mass_kg * kStandardGravity * longest_rod_m;
    firmness[i] = rod.stiffness * effective;
    stop_firmness[i] = kStopFirmness * effective;
  }
}

}  // namespace gaitsmith
