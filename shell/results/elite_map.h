// SPDX-License-Identifier: MIT
// The result of MAP-Elites or CMA-MAE as a map of styles: the best motion for each height, slip and number of
// turns [Mouret Clune 2015].
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/evolution/elites.h"

namespace gaitsmith::shell {

class EliteMap {
 public:
  /// @param searched the document that was searched. @param state of its search (Search::Save)
  /// @return nothing if the state is not from such a search of the document
  [[nodiscard]] static std::optional<EliteMap> Of(const Document& searched,
                                                  std::span<const std::uint8_t> state);

  [[nodiscard]] const Figure& Whose() const { return searched_.figure; }
  /// The search's problem and algorithm.
  [[nodiscard]] std::string Title() const;
  /// Bins of each axis.
  [[nodiscard]] int Bins() const { return bins_; }
  /// Number of motions in all cells, and in the cells with this number of turns.
  [[nodiscard]] int Count() const;
  [[nodiscard]] int Count(int turns) const;
  /// The bins of an axis between the least and the greatest that has a motion, over the whole map.
  struct Range {
    int first, last;
    [[nodiscard]] int Count() const { return last - first + 1; }
  };
  [[nodiscard]] Range RangeOf(int axis) const { return ranges_[static_cast<std::size_t>(axis)]; }
  /// Its lower and upper end, as text; with a + if the last bin has no upper end.
  [[nodiscard]] std::string LowText(int axis) const;
  [[nodiscard]] std::string HighText(int axis) const;
  /// Identifies the map and one of its cells, to remember a picture of it.
  [[nodiscard]] std::string CellName(int height, int slip, int turns) const;
  /// The motion of a cell; null if the cell is empty. @param height, slip, turns  bins, [0, Bins())
  [[nodiscard]] const Elite* At(int height, int slip, int turns) const;
  /// The range of a bin, as text; the last bin has no upper end. @param axis 0 height [m], 1 slip [m], 2
  /// turns
  [[nodiscard]] std::string RangeText(int axis, int bin) const;
  /// The least and the greatest fitness on the map.
  [[nodiscard]] float Least() const { return least_; }
  [[nodiscard]] float Best() const { return best_; }
  /// The motion of a non-empty cell as a document.
  [[nodiscard]] Document MotionAt(int height, int slip, int turns) const;

 private:
  [[nodiscard]] float BinWidth(int axis) const {
    return searched_.search.elites.most[static_cast<std::size_t>(axis)] / static_cast<float>(bins_);
  }
  [[nodiscard]] std::size_t Index(int height, int slip, int turns) const {
    const auto bins = static_cast<std::size_t>(bins_);
    return (static_cast<std::size_t>(height) * bins + static_cast<std::size_t>(slip)) * bins +
           static_cast<std::size_t>(turns);
  }

  Document searched_;
  int bins_ = 1;
  std::vector<Elite> cells_;
  std::array<Range, 3> ranges_{};
  std::size_t sum_ = 0;  // of the state's bytes: tells two maps apart
  float least_ = 0.0f, best_ = 0.0f;
};

}  // namespace gaitsmith::shell
