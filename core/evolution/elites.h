// SPDX-License-Identifier: MIT
// The grid of MAP-Elites [Mouret Clune 2015]: in each cell of a grid over style the fittest genome whose
// motion has this style.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/search/search.h"

namespace gaitsmith {

struct Elite {
  Genome genome;  // empty until a motion falls into this cell
  Score score;
};

class Elites {
 public:
  explicit Elites(const ElitesSettings&);

  /// bins^3 cells. The index of a cell is (height bin * bins + slip bin) * bins + rotations bin.
  [[nodiscard]] const std::vector<Elite>& Cells() const { return cells_; }
  /// Keeps a genome if it is the fittest of its style. Void motions have none.
  void Add(const Genome&, const Score&);
  /// The cell of a motion. @return the number of cells if it is void or its style is not finite
  [[nodiscard]] std::size_t CellOf(const Score&) const;
  /// Indices of the cells that hold a motion.
  [[nodiscard]] std::vector<std::size_t> Filled() const;
  [[nodiscard]] std::vector<float> Fitness() const;
  void Save(BitWriter&) const;
  /// @return false if these cannot be elites; they may then have been loaded in part
  [[nodiscard]] bool Load(BitReader&, std::size_t genes);

 private:
  ElitesSettings settings_;
  std::vector<Elite> cells_;
};

/// Whether an algorithm's result is a grid of elites.
[[nodiscard]] constexpr bool KeepsElites(Algorithm algorithm) {
  return algorithm == Algorithm::kMapElites || algorithm == Algorithm::kCmaMae;
}

/// The elites of a saved state of MAP-Elites or CMA-MAE (Search::Save), for those who only look at them.
/// @return nothing if it is not one of a search with these settings
[[nodiscard]] std::optional<Elites> ElitesOf(const SearchSettings&, std::size_t genes,
                                             std::span<const std::uint8_t> state);

}  // namespace gaitsmith
