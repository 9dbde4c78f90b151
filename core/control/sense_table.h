// SPDX-License-Identifier: MIT
// The one table of senses: their order in the sense vector, names, units, ranges and mirror images. All code
// that counts, names, normalises or mirrors senses reads it.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/control/senses.h"
#include "core/world/environment.h"

namespace gaitsmith {

enum class SenseQuantity { kAngle, kForce, kHeight, kVelocity, kTime, kAhead, kCorner, kLength };

/// The part of the plant that has one such sense each. A mirror image exchanges senses together with these
/// parts.
enum class SensePer { kActuator, kContact, kBody };

/// The readings that are normalised to 0 and 1.
struct SenseRange {
  float at_zero, at_one;  // [rad], [N], [m], [m/s] or [s]
};

/// What becomes of readings outside the range.
enum class SenseClip { kNone, kAbove, kBoth };

/// Senses of one kind.
struct SenseGroup {
  SenseQuantity quantity;
  std::string_view name;  // followed by the number, from 1, of the actuator or contact; of muscles "length"
  std::string_view unit;  // of the range; for an actuator's position the unit of a joint
  SensePer per;
  bool reverses;  // in the mirror image, if the actuator turns the other way, s becomes 1 - s
  SenseClip clip;
  SenseRange (*range)(const SenseSpec&, const Ports&, std::size_t index);
};

/// The physical senses [Fukunaga 1994, Table 1] in the order of the sense vector, each normalised to [0, 1].
/// Forces are clipped, because impacts reach peaks of 35 times the weight.
inline constexpr std::array<SenseGroup, 4> kPhysicalSenses = {{
    {SenseQuantity::kAngle, "angle", "rad", SensePer::kActuator, true, SenseClip::kNone,
     [](const SenseSpec&, const Ports& ports, std::size_t index) {
       const auto [least, greatest] = ports.actuator_range[index];
       return SenseRange{least, greatest};
     }},
    {SenseQuantity::kForce, "force", "N", SensePer::kContact, false, SenseClip::kAbove,
     [](const SenseSpec& spec, const Ports& ports, std::size_t) {
       return SenseRange{0.0f, spec.force_weights * ports.mass_kg * kStandardGravity};
     }},
    {SenseQuantity::kHeight, "height", "m", SensePer::kBody, false, SenseClip::kNone,
     [](const SenseSpec& spec, const Ports& ports, std::size_t) {
       return SenseRange{0.0f, spec.height_rods * ports.length_m};
     }},
    {SenseQuantity::kVelocity, "rise", "m/s", SensePer::kBody, false, SenseClip::kNone,
     [](const SenseSpec& spec, const Ports&, std::size_t) {
       return SenseRange{-spec.velocity_mps, spec.velocity_mps};
     }},
}};

/// How far a controller with sight sees [m].
[[nodiscard]] inline float SightOf(const SenseSpec& spec, const Ports& ports) {
  return spec.sight_rods * ports.length_m;
}

/// What a controller with sight senses besides: by how much the ground is higher where its sight ends than
/// below the centre of mass, and how far it is to the next corner. Level ground is sensed as 0.5 and 1.
inline constexpr std::array<SenseGroup, 2> kGroundSenses = {{
    {SenseQuantity::kAhead, "ahead", "m", SensePer::kBody, false, SenseClip::kBoth,
     [](const SenseSpec&, const Ports& ports, std::size_t) {
       return SenseRange{-ports.length_m, ports.length_m};
     }},
    {SenseQuantity::kCorner, "corner", "m", SensePer::kBody, false, SenseClip::kAbove,
     [](const SenseSpec& spec, const Ports& ports, std::size_t) {
       return SenseRange{0.0f, SightOf(spec, ports)};
     }},
}};

/// All senses of a controller with sight.
inline constexpr auto kSightSenses = [] {
  std::array<SenseGroup, kPhysicalSenses.size() + kGroundSenses.size()> all = {};
  std::copy(kPhysicalSenses.begin(), kPhysicalSenses.end(), all.begin());
  std::copy(kGroundSenses.begin(), kGroundSenses.end(), all.begin() + kPhysicalSenses.size());
  return all;
}();

/// The sense of a wind-up toy: [0, period) becomes [0, 1).
inline constexpr std::array<SenseGroup, 1> kTimerSenses = {{
    {SenseQuantity::kTime, "timer", "s", SensePer::kBody, false, SenseClip::kNone,
     [](const SenseSpec& spec, const Ports&, std::size_t) {
       return SenseRange{0.0f, static_cast<float>(spec.period_steps) * kStep};
     }},
}};

[[nodiscard]] constexpr std::span<const SenseGroup> SenseGroupsOf(SenseKind kind) {
  if (kind == SenseKind::kTimer) return kTimerSenses;
  if (kind == SenseKind::kSight) return kSightSenses;
  return kPhysicalSenses;
}

/// Number of senses in a group.
[[nodiscard]] constexpr int CountOf(SensePer per, const PortCount& ports) {
  return per == SensePer::kActuator ? ports.actuators : per == SensePer::kContact ? ports.contacts : 1;
}

/// Number of values in the sense vector: 2 n + 2 physical ones for a figure of n rods, 2 more with sight, or
/// 1 for a timer.
[[nodiscard]] constexpr int SenseCount(SenseKind kind, const PortCount& ports) {
  int count = 0;
  for (const SenseGroup& group : SenseGroupsOf(kind)) count += CountOf(group.per, ports);
  return count;
}

/// Maximum number of values in a sense vector.
inline constexpr int kMaxSenses = SenseCount(SenseKind::kSight, {kMaxActuators, kMaxContacts});

/// A sense's row of the table, and which actuator or contact it belongs to.
struct SensePlace {
  const SenseGroup* group;
  int index;
};
/// @param sense in [0, SenseCount())
[[nodiscard]] SensePlace PlaceOf(SenseKind kind, const PortCount& ports, int sense);

/// "angle 1", "force 3", "height", "rise", "timer". Joints and endpoints count from 1, as in the paper.
[[nodiscard]] std::string SenseName(SenseKind kind, const PortCount& ports, int sense);

/// Converts a normalised sense to physical units.
struct SenseScale {
  SenseQuantity quantity;
  float at_zero, at_one;  // [rad], [N], [m], [m/s] or [s]

  [[nodiscard]] float Of(float sense) const { return at_zero + (at_one - at_zero) * sense; }
};
/// @param sense in [0, SenseCount())
[[nodiscard]] SenseScale ScaleOf(const SenseSpec&, const Ports&, int sense);

}  // namespace gaitsmith
