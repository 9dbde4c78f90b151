// SPDX-License-Identifier: MIT
// A motion as skeletal formats have it: bones that turn on their parents, with keys where they are needed.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/rollout/motion.h"

namespace gaitsmith::shell {

/// Bone i is rod i in walking order. Bone 0 has no parent, and its start moves.
class MovingBones {
 public:
  /// @param motion is kept as a reference
  explicit MovingBones(const Motion& motion) : motion_(motion), skeleton_(motion.Bones()) {}

  [[nodiscard]] int Count() const { return skeleton_.rods; }
  [[nodiscard]] int Frames() const { return motion_.Frames(); }
  [[nodiscard]] int ParentOf(int bone) const { return Limb(bone).parent; }  // -1 of bone 0
  /// "rod 3", with the number that the rod has in its document.
  [[nodiscard]] std::string NameOf(int bone) const;
  [[nodiscard]] double LengthM(int bone) const { return static_cast<double>(Limb(bone).length_m); }
  /// Place of the joint on the parent, from the parent's start [m]: 0 or its length. 0 of bone 0.
  [[nodiscard]] double JointM(int bone) const;

  /// Where a bone starts [m], y upwards, and the unit vector along it.
  struct Place {
    std::array<double, 2> start_m, along;
    /// A point of the world, from one that is so far along the bone and to its left [m].
    [[nodiscard]] std::array<double, 2> Of(const std::array<double, 2>& point) const {
      return {start_m[0] + along[0] * point[0] - along[1] * point[1],
              start_m[1] + along[1] * point[0] + along[0] * point[1]};
    }
  };
  [[nodiscard]] Place PlaceOf(int frame, int bone) const;

  /// Start of bone 0 above the ground [m], y upwards.
  [[nodiscard]] std::array<double, 2> Start(int frame) const;
  /// Against the parent, of bone 0 against the ground, counterclockwise [rad]. Without jumps between frames.
  [[nodiscard]] double AngleRad(int frame, int bone) const;
  /// Thickness of plain rods, as film strips and scenes have them [m].
  [[nodiscard]] double ThicknessM() const;

 private:
  [[nodiscard]] std::array<double, 2> EndpointM(int frame, int endpoint) const;
  [[nodiscard]] const Skeleton::Limb& Limb(int bone) const {
    return skeleton_.limbs[static_cast<std::size_t>(bone)];
  }

  const Motion& motion_;
  const Skeleton& skeleton_;
};

/// A value at some frames, in their order. Between two keys it is on the line between them.
struct Track {
  std::vector<int> frames;
  std::vector<std::array<double, 2>> values;  // numbers have a second value of 0
};

/// Keys from splitting at the worst frame, until no value is further than the tolerance from the line between
/// two keys. [Douglas Peucker 1973]
/// @param values of every frame, at least one
[[nodiscard]] Track KeysOf(const std::vector<std::array<double, 2>>& values, double tolerance);

/// Tolerances of a joint's angle and of the root's place. Errors add up along a limb: at the end of three
/// rods of 1 m they are 14 mm at most.
inline constexpr double kKeyAngleRad = 0.002, kKeyPlaceM = 0.002;

}  // namespace gaitsmith::shell
