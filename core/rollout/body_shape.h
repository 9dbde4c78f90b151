// SPDX-License-Identifier: MIT
// Bodies as genes: the lengths and masses of a figure's rods and the limits of its joints, for searches that
// may change them. Whatever the genes are, the tree and the drawn angles stay, each number stays within a
// factor of what was drawn, the total length and the total mass stay, and parts that were alike stay alike.
#pragma once

#include <span>
#include <vector>

#include "core/control/gene_groups.h"
#include "core/physics/figure.h"

namespace gaitsmith {

/// The bodies that a search may try.
struct BodyRange {
  Figure drawn;             // its rods are the middle of the range; valid
  float most_times = 1.0f;  // the most that a number may be multiplied or divided by, (1, 10]
};

class BodyShape {
 public:
  /// @param now the body of genes that are all kUnchangedGene, of the tree that was drawn; brought into the
  /// range
  BodyShape(const BodyRange& range, const Figure& now);

  /// Two for each rod, length and mass, and two for each joint, its limits. Rods that are alike share theirs,
  /// and so do joints.
  [[nodiscard]] std::size_t Genes() const { return 2 * (rods_.Places() + joints_.Places()); }
  /// @param genes Genes() of them
  [[nodiscard]] Figure FigureOf(std::span<const Gene> genes) const;

 private:
  /// Which parts share genes.
  class Sharing {
   public:
    explicit Sharing(std::size_t parts = 0);
    void Share(std::size_t one, std::size_t other);
    [[nodiscard]] bool Shares(std::size_t one, std::size_t other) const {
      return place_[one] == place_[other];
    }
    /// Numbers the places without gaps. Call it last.
    void Number();
    [[nodiscard]] std::size_t PlaceOf(std::size_t part) const { return place_[part]; }
    [[nodiscard]] std::size_t Places() const { return places_; }

   private:
    std::vector<std::size_t> place_;
    std::size_t places_ = 0;
  };
  /// How the limits of a joint follow from its two genes.
  enum class Sides { kOwn, kMirrored, kBoth };

  void FindHalves();
  void FindPairs();
  /// A rod and all that hangs on it, the nearest first.
  [[nodiscard]] std::vector<std::size_t> LimbAt(std::size_t rod) const;
  /// Whether two limbs are alike, or mirror each other.
  [[nodiscard]] bool Alike(const std::vector<std::size_t>& one, const std::vector<std::size_t>& other,
                           bool mirrored) const;
  void ShareJoint(std::size_t one, std::size_t other, bool mirrored);

  BodyRange range_;
  Figure now_;
  Sharing rods_;
  Sharing joints_;            // by the rod that they turn
  std::vector<Sides> sides_;  // of each rod's joint
};

}  // namespace gaitsmith
