// SPDX-License-Identifier: MIT
#include "core/physics/rod_multiples.h"

namespace gaitsmith {

RodMultiples::RodMultiples(const Skeleton& skeleton) {
  const auto n = static_cast<std::size_t>(skeleton.rods);
  Table<kMaxRods> middle{};
  for (std::size_t i = 0; i < n; ++i) {
    const Skeleton::Limb& limb = skeleton.limbs[i];
    middle[i] = end[static_cast<std::size_t>(limb.start)];
    end[i + 1] = middle[i];
    middle[i][i] += 0.5 * static_cast<double>(limb.length_m);
    end[i + 1][i] += static_cast<double>(limb.length_m);
    for (std::size_t j = 0; j < n; ++j)
      mean[j] += middle[i][j] * static_cast<double>(limb.mass_kg) / static_cast<double>(skeleton.mass_kg);
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) {
      double& sum = coupling[j][k];
      sum = j == k ? static_cast<double>(skeleton.limbs[j].inertia_kgm2) : 0.0;
      for (std::size_t i = 0; i < n; ++i)
        sum += static_cast<double>(skeleton.limbs[i].mass_kg) * (middle[i][j] - mean[j]) *
               (middle[i][k] - mean[k]);
    }
  }
}

}  // namespace gaitsmith
