// SPDX-License-Identifier: MIT
#include "shell/body/figure_look.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shell/body/figure_pose.h"

namespace gaitsmith::shell {
namespace {

using Side = FigureLook::Side;

/// What distinguishes a shipped figure.
struct Known {
  std::string_view figure;
  float middle_m;
  float belly = 1.0f;  // thickness of the root halfway, in its own
  Head head = Head::kNone;
  int head_rod = -1;
  float head_m = 0.0f;
};
constexpr Known kKnown[] = {
    {.figure = "Ostrich", .middle_m = 0.047f, .belly = 1.5f, .head = Head::kBeak, .head_rod = 4},
    {.figure = "Frog", .middle_m = 0.062f, .belly = 1.15f, .head = Head::kFrog, .head_rod = 6},
    {.figure = "Horse", .middle_m = 0.078f, .belly = 1.2f, .head = Head::kMuzzle, .head_rod = 1},
    {.figure = "Inchworm", .middle_m = 0.085f, .head = Head::kEye, .head_rod = 2},
    {.figure = "Mr. Star-Man", .middle_m = 0.1f},
    {.figure = "Beryl Biped", .middle_m = 0.07f, .head = Head::kBall, .head_rod = 0, .head_m = 0.19f},
    {.figure = "Acrobat", .middle_m = 0.05f, .head = Head::kBall, .head_rod = 1, .head_m = 0.125f},
    {.figure = "Kangaroo", .middle_m = 0.055f, .belly = 1.35f, .head = Head::kSnout, .head_rod = 6},
    {.figure = "Crab", .middle_m = 0.05f, .belly = 1.3f},
    {.figure = "Spider", .middle_m = 0.04f, .belly = 1.5f},
    {.figure = "Hopper", .middle_m = 0.07f, .belly = 1.1f},
};

/// Shares of a limb's radius.
constexpr float kAtStart = 1.08f, kAtEnd = 0.84f, kAtFreeEnd = 0.7f;
/// Radius of an unknown figure's middling limb, in its middling length.
constexpr float kSlender = 0.1f;
constexpr float kThinnest = 0.62f, kThickest = 2.0f;

float Median(std::vector<float> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

bool Alike(const Skeleton::Limb& a, const Skeleton::Limb& b) {
  constexpr float kSame = 1e-3f;
  return std::abs(a.length_m - b.length_m) < kSame && std::abs(a.mass_kg - b.mass_kg) < kSame;
}

/// The limbs that start where this one does and are like it, itself included, the root not.
std::vector<std::size_t> LikeLimbs(const Skeleton& bones, std::size_t limb) {
  std::vector<std::size_t> like;
  for (std::size_t other = 1; other < static_cast<std::size_t>(bones.rods); ++other) {
    if (bones.limbs[other].start == bones.limbs[limb].start && Alike(bones.limbs[other], bones.limbs[limb]))
      like.push_back(other);
  }
  return like;
}

Side SideOf(const Skeleton& bones, std::size_t limb, const FigureLook& look) {
  const auto parent = static_cast<std::size_t>(bones.limbs[limb].parent);
  if (look.limbs[parent].side != Side::kMiddle && bones.limbs[limb].start == static_cast<int>(parent) + 1)
    return look.limbs[parent].side;
  const std::vector<std::size_t> like = LikeLimbs(bones, limb);
  // Arms of a star that are also like the root are neither far nor near.
  const bool star = bones.limbs[limb].start == 0 && Alike(bones.limbs[0], bones.limbs[limb]);
  if (like.size() != 2 || star) return Side::kMiddle;
  return like.front() == limb ? Side::kFar : Side::kNear;
}

/// The greatest radius among the endpoints on which the drawn pose stands.
float SoleOf(const Skeleton& bones, const FigureLook& look) {
  const std::vector<BodyPoint> pose = DrawnEndpoints(bones, {});
  const float lowest = std::ranges::min(pose, {}, &BodyPoint::y).y;
  float sole = 0.0f;
  for (std::size_t k = 0; k < pose.size(); ++k) {
    if (pose[k].y < lowest + 0.25f * look.middle_m)
      sole = std::max(sole, k == 0 ? look.limbs[0].start_m : look.limbs[k - 1].end_m);
  }
  return sole;
}

/// The shipped heads point to the right, a mirrored one to the left.
float CrownOf(const Skeleton& bones, const FigureLook& look) {
  const std::vector<BodyPoint> pose = DrawnEndpoints(bones, {});
  const auto rod = static_cast<std::size_t>(look.head_rod);
  const float along = pose[rod + 1].x - pose[static_cast<std::size_t>(bones.limbs[rod].start)].x;
  return along < -0.05f * bones.limbs[rod].length_m ? -1.0f : 1.0f;
}

/// Of a figure of springs, in its middling spring's length.
constexpr float kKnob = 0.09f, kMuscle = 0.062f, kPassive = 0.028f;

FigureLook LookOfSprings(const Figure& figure) {
  std::vector<float> lengths, masses;
  lengths.reserve(figure.springs.size());
  masses.reserve(figure.nodes.size());
  for (const Spring& spring : figure.springs) lengths.push_back(DrawnLength(figure, spring));
  for (const Node& node : figure.nodes) masses.push_back(node.mass_kg);
  FigureLook look;
  const float length = lengths.empty() ? 1.0f : Median(lengths), mass = Median(masses);
  look.middle_m = kKnob * length;
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    const Spring& spring = figure.springs[i];
    const float radius = (spring.IsMuscle() ? kMuscle : kPassive) * length;
    look.limbs.push_back({.from = spring.from,
                          .to = spring.to,
                          .start_m = radius,
                          .end_m = radius,
                          .drawn_m = spring.IsMuscle() ? lengths[i] : 0.0f});
  }
  for (const float each : masses)
    look.knobs.push_back(look.middle_m * std::clamp(std::sqrt(each / mass), kThinnest, kThickest));
  const std::vector<BodyPoint> pose = DrawnEndpoints(figure);
  const float lowest = std::ranges::min(pose, {}, &BodyPoint::y).y;
  for (std::size_t node = 0; node < pose.size(); ++node) {
    if (pose[node].y < lowest + 0.25f * look.middle_m) look.sole_m = std::max(look.sole_m, look.knobs[node]);
  }
  return look;
}

}  // namespace

FigureLook LookOf(const Figure& figure) {
  if (figure.HasSprings()) return LookOfSprings(figure);
  const Skeleton bones(figure);
  const auto rods = static_cast<std::size_t>(bones.rods);
  std::vector<float> lengths, densities;
  std::vector<bool> free_end(rods, true);
  for (std::size_t limb = 0; limb < rods; ++limb) {
    lengths.push_back(bones.limbs[limb].length_m);
    densities.push_back(std::sqrt(bones.limbs[limb].mass_kg / bones.limbs[limb].length_m));
    if (limb > 0 && bones.limbs[limb].start > 0)
      free_end[static_cast<std::size_t>(bones.limbs[limb].start) - 1] = false;
  }
  FigureLook look;
  for (const Bar& bar : BarsOf(bones)) look.limbs.push_back({.from = bar.from, .to = bar.to});
  look.middle_m = kSlender * Median(lengths);
  float belly = 1.0f;
  for (const Known& known : kKnown) {
    if (known.figure != KindOf(figure.name)) continue;
    look.middle_m = known.middle_m;
    belly = known.belly;
    // An edited figure may have lost its head.
    const auto rod = static_cast<std::size_t>(known.head_rod);
    if (known.head_rod < 0 || rod >= rods || !free_end[rod]) continue;
    look.head = known.head;
    look.head_rod = known.head_rod;
    look.head_m = known.head_m;
  }
  const float middle_density = Median(densities);
  for (std::size_t limb = 0; limb < rods; ++limb) {
    const float own = look.middle_m * std::clamp(densities[limb] / middle_density, kThinnest, kThickest);
    FigureLook::Limb& drawn = look.limbs[limb];
    const int start = bones.limbs[limb].start;
    drawn.start_m = limb == 0 ? own : kAtStart * own;
    // A limb is not thicker than the one that it continues. The root may be far thicker.
    if (limb > 0 && start > 1) {
      drawn.start_m = std::min(look.limbs[static_cast<std::size_t>(start) - 1].end_m, 1.25f * own);
    }
    drawn.end_m = (free_end[limb] ? kAtFreeEnd : kAtEnd) * own;
    if (limb == 0 && !free_end[0]) drawn.end_m = own;
    if (limb > 0) drawn.side = SideOf(bones, limb, look);
    if (limb == 0) look.belly_m = (belly - 1.0f) * own;
  }
  if (rods > 3 && LikeLimbs(bones, 0).size() >= 3) look.hub_m = 1.35f * look.middle_m;
  look.sole_m = SoleOf(bones, look);
  if (look.head_rod >= 0) look.crown = CrownOf(bones, look);
  return look;
}

}  // namespace gaitsmith::shell
