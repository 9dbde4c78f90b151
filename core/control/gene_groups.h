// SPDX-License-Identifier: MIT
// What the genes of a controller mean, for search operators and encodings, for every controller kind.
// Operators and encodings read only these groups.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace gaitsmith {

using Gene = std::uint16_t;
using Genome = std::vector<Gene>;

inline constexpr Gene kGeneMax = 65535;
/// A body's gene of this value leaves its part as it is.
inline constexpr Gene kUnchangedGene = 32768;

enum class GeneRole {
  /// Pairs of a low and a high end, low <= high, one pair for each sense. A pair over the whole grid (0 to
  /// kGeneMax) means that its sense is ignored.
  kIntervals,
  kList,    // independent numbers
  kNumber,  // one independent number
};

/// In the order of GeneRole.
inline constexpr std::array<std::string_view, 3> kGeneRoleNames = {"intervals", "list", "number"};

/// Neighbouring genes with one name in documents.
struct GeneGroup {
  std::string_view name;
  GeneRole role;
  std::size_t first;  // index in the genome
  std::size_t count;

  [[nodiscard]] std::span<Gene> Of(Genome& genes) const { return std::span(genes).subspan(first, count); }
  [[nodiscard]] std::span<const Gene> Of(std::span<const Gene> genes) const {
    return genes.subspan(first, count);
  }
};

/// Whether an interval limits its sense.
[[nodiscard]] constexpr bool Cares(Gene low, Gene high) { return low != 0 || high != kGeneMax; }

/// The groups of one component (a rule, a node), in the order of their genes. Together they hold all of them.
class GeneGroups {
 public:
  /// @param first index in the genome
  explicit GeneGroups(std::size_t first) : end_of_genes_(first) {}
  GeneGroups& Add(std::string_view name, GeneRole role, int count) {
    groups_[size_++] = {name, role, end_of_genes_, static_cast<std::size_t>(count)};
    end_of_genes_ += static_cast<std::size_t>(count);
    return *this;
  }
  [[nodiscard]] const GeneGroup* begin() const { return groups_.data(); }
  [[nodiscard]] const GeneGroup* end() const { return groups_.data() + size_; }

 private:
  std::array<GeneGroup, 5> groups_{};
  std::size_t size_ = 0;
  std::size_t end_of_genes_;
};

}  // namespace gaitsmith
