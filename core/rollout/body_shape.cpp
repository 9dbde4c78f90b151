// SPDX-License-Identifier: MIT
#include "core/rollout/body_shape.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"
#include "core/physics/symmetry.h"

namespace gaitsmith {

namespace {

/// A total that differs by no more than this share is kept already: rounding must not change a body.
constexpr double kSameTotal = 1e-6;

/// A gene as a share of the way to the end of the range: -1, the least, to 1, the most.
double ShareOf(Gene gene) {
  return std::max(-1.0, (static_cast<double>(gene) - kUnchangedGene) / (kGeneMax - kUnchangedGene));
}

/// A number that may be `times` as much or as little as `drawn`, at a share of the way from `now`.
double Moved(double drawn, double now, double times, double share) {
  if (drawn == 0.0) return 0.0;
  const double ratio = std::clamp(now / drawn, 1.0 / times, times);
  if (share == 0.0) return ratio == now / drawn ? now : drawn * ratio;
  return drawn * ratio * Exp(share * (share > 0.0 ? Log(times / ratio) : Log(ratio * times)));
}

/// Scales values until they add up to the total of what was drawn, each within its range.
void KeepTotal(std::vector<double>& values, const std::vector<double>& drawn, double times) {
  const double total = std::accumulate(drawn.begin(), drawn.end(), 0.0);
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  if (sum >= total * (1.0 - kSameTotal) && sum <= total * (1.0 + kSameTotal)) return;
  const auto scaled = [&](double scale, std::size_t i) {
    return std::clamp(values[i] * scale, drawn[i] / times, drawn[i] * times);
  };
  // The sum grows with the scale, and these two limits bring every value to an end of its range.
  double low = 1.0 / (times * times), high = times * times;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    double reached = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) reached += scaled(middle, i);
    (reached < total ? low : high) = middle;
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = scaled(high, i);
}

}  // namespace

BodyShape::Sharing::Sharing(std::size_t parts) : place_(parts) {
  std::iota(place_.begin(), place_.end(), std::size_t{0});
}

void BodyShape::Sharing::Share(std::size_t one, std::size_t other) {
  // All parts that share with the other join.
  std::ranges::replace(place_, std::size_t{place_[other]}, std::size_t{place_[one]});
}

void BodyShape::Sharing::Number() {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number(place_.size(), kNone);
  for (std::size_t& place : place_) {
    std::size_t& known = number[place];
    if (known == kNone) known = places_++;
    place = known;
  }
}

BodyShape::BodyShape(const BodyRange& range, const Figure& now)
    : range_(range),
      now_(now),
      rods_(range.drawn.rods.size()),
      joints_(range.drawn.rods.size()),
      sides_(range.drawn.rods.size(), Sides::kOwn) {
  FindHalves();
  FindPairs();
  // The root has no joint, so it takes no place of its own among them.
  const auto root = std::ranges::find(range_.drawn.rods, kNoParent, &Rod::parent) - range_.drawn.rods.begin();
  if (range_.drawn.Rods() > 1) joints_.Share(root == 0 ? 1 : 0, static_cast<std::size_t>(root));
  rods_.Number();
  joints_.Number();
}

std::vector<std::size_t> BodyShape::LimbAt(std::size_t rod) const {
  std::vector<std::size_t> limb = {rod};
  for (std::size_t at = 0; at < limb.size(); ++at) {
    for (std::size_t i = 0; i < range_.drawn.rods.size(); ++i) {
      if (range_.drawn.rods[i].parent == static_cast<int>(limb[at])) limb.push_back(i);
    }
  }
  return limb;
}

bool BodyShape::Alike(const std::vector<std::size_t>& one, const std::vector<std::size_t>& other,
                      bool mirrored) const {
  if (one.size() != other.size()) return false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const Rod &a = range_.drawn.rods[one[i]], &b = range_.drawn.rods[other[i]];
    const bool same_limits = mirrored ? a.min_rad == -b.max_rad && a.max_rad == -b.min_rad
                                      : a.min_rad == b.min_rad && a.max_rad == b.max_rad;
    if (a.length_m != b.length_m || a.mass_kg != b.mass_kg || !same_limits || a.parent_end != b.parent_end)
      return false;
    const auto parent = [&](const std::vector<std::size_t>& limb, const Rod& rod) {
      return std::ranges::find(limb, static_cast<std::size_t>(rod.parent)) - limb.begin();
    };
    if (parent(one, a) != parent(other, b)) return false;
  }
  return true;
}

void BodyShape::ShareJoint(std::size_t one, std::size_t other, bool mirrored) {
  if (joints_.Shares(one, other)) return;
  const bool turned = (sides_[one] != sides_[other]) != mirrored;
  for (std::size_t i = 0; i < sides_.size() && turned; ++i) {
    if (joints_.Shares(i, other) && sides_[i] != Sides::kBoth)
      sides_[i] = sides_[i] == Sides::kOwn ? Sides::kMirrored : Sides::kOwn;
  }
  joints_.Share(one, other);
  // Limbs like one in the middle turn as far to both sides, too.
  const auto alike = [&](std::size_t i) { return joints_.Shares(i, one); };
  bool both = false;
  for (std::size_t i = 0; i < sides_.size(); ++i) both = both || (alike(i) && sides_[i] == Sides::kBoth);
  for (std::size_t i = 0; i < sides_.size() && both; ++i) {
    if (alike(i)) sides_[i] = Sides::kBoth;
  }
}

/// The halves of a figure that is its own mirror image.
void BodyShape::FindHalves() {
  const auto symmetry = SymmetryOf(range_.drawn);
  if (!symmetry) return;
  const Skeleton skeleton(range_.drawn);
  const auto drawn = [&](int rod) {
    return static_cast<std::size_t>(skeleton.limbs[static_cast<std::size_t>(rod)].drawn);
  };
  const auto ends_of = [&](int rod) {
    return std::array{skeleton.limbs[static_cast<std::size_t>(rod)].start, rod + 1};
  };
  for (int rod = 0; rod < skeleton.rods; ++rod) {
    const auto [start, end] = ends_of(rod);
    const std::array image{symmetry->endpoint[static_cast<std::size_t>(start)],
                           symmetry->endpoint[static_cast<std::size_t>(end)]};
    for (int other = rod + 1; other < skeleton.rods; ++other) {
      const std::array ends = ends_of(other);
      if (ends == image || (ends[0] == image[1] && ends[1] == image[0]))
        rods_.Share(drawn(rod), drawn(other));
    }
  }
  for (int joint = 0; joint < skeleton.joints; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const int image = symmetry->joint[j];
    if (image > joint) ShareJoint(drawn(joint + 1), drawn(image + 1), symmetry->reversed[j]);
    // A joint in the middle turns as far to one side as to the other.
    if (image == joint && symmetry->reversed[j]) sides_[drawn(joint + 1)] = Sides::kBoth;
  }
}

/// Limbs at the same end of the same rod, such as two legs at a hip.
void BodyShape::FindPairs() {
  const std::vector<Rod>& rods = range_.drawn.rods;
  for (std::size_t i = 0; i < rods.size(); ++i) {
    for (std::size_t k = i + 1; k < rods.size(); ++k) {
      if (rods[i].parent == kNoParent || rods[i].parent != rods[k].parent) continue;
      const std::vector<std::size_t> one = LimbAt(i), other = LimbAt(k);
      const bool same = Alike(one, other, false);
      if (!same && !Alike(one, other, true)) continue;
      for (std::size_t part = 0; part < one.size(); ++part) {
        rods_.Share(one[part], other[part]);
        ShareJoint(one[part], other[part], !same);
      }
    }
  }
}

Figure BodyShape::FigureOf(std::span<const Gene> genes) const {
  const auto times = static_cast<double>(range_.most_times);
  const auto of_rod = [&](std::size_t rod, std::size_t number) {
    return ShareOf(genes[2 * rods_.PlaceOf(rod) + number]);
  };
  const auto of_joint = [&](std::size_t rod, bool most) {
    const bool second = sides_[rod] != Sides::kBoth && most == (sides_[rod] == Sides::kOwn);
    return ShareOf(genes[2 * (rods_.Places() + joints_.PlaceOf(rod)) + (second ? 1 : 0)]);
  };
  Figure figure = now_;
  for (const std::size_t number : {0u, 1u}) {
    float Rod::* const value = number == 0 ? &Rod::length_m : &Rod::mass_kg;
    std::vector<double> drawn, values;
    for (std::size_t i = 0; i < figure.rods.size(); ++i) {
      drawn.push_back(static_cast<double>(range_.drawn.rods[i].*value));
      values.push_back(Moved(drawn[i], static_cast<double>(now_.rods[i].*value), times, of_rod(i, number)));
    }
    KeepTotal(values, drawn, times);
    const double least = number == 0 ? 0.001 : 1e-6, most = number == 0 ? 1e3 : 1e6;  // as in Rod
    for (std::size_t i = 0; i < figure.rods.size(); ++i)
      figure.rods[i].*value = static_cast<float>(std::clamp(values[i], least, most));
  }
  for (std::size_t i = 0; i < figure.rods.size(); ++i) {
    const Rod &drawn = range_.drawn.rods[i], &now = now_.rods[i];
    if (drawn.parent == kNoParent) continue;
    const auto limit = [&](float was, float is, bool most) {
      return static_cast<float>(std::clamp(
          Moved(static_cast<double>(was), static_cast<double>(is), times, of_joint(i, most)), -kPi, kPi));
    };
    figure.rods[i].min_rad = limit(drawn.min_rad, now.min_rad, false);
    figure.rods[i].max_rad = limit(drawn.max_rad, now.max_rad, true);
  }
  return figure;
}

}  // namespace gaitsmith
