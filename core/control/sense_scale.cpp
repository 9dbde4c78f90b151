// SPDX-License-Identifier: MIT
#include "core/control/sense_scale.h"

namespace gaitsmith {

SenseScale ScaleOf(const SenseSpec& spec, const Skeleton& bones, int sense) {
  if (spec.kind == SenseKind::kTimer) {
    return {SenseQuantity::kTime, 0.0f, static_cast<float>(spec.period_steps) * kStep};
  }
  if (sense < bones.joints) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(sense) + 1];
    return {SenseQuantity::kAngle, limb.min_rad, limb.max_rad};
  }
  if (sense < bones.joints + bones.endpoints) {
    return {SenseQuantity::kForce, 0.0f, spec.force_weights * bones.mass_kg * kStandardGravity};
  }
  if (sense == bones.joints + bones.endpoints) {
    return {SenseQuantity::kHeight, 0.0f, spec.height_rods * bones.longest_rod_m};
  }
  return {SenseQuantity::kVelocity, -spec.velocity_mps, spec.velocity_mps};
}

}  // namespace gaitsmith
