// SPDX-License-Identifier: MIT
// What MAP-Elites has found, as a map of styles: for each height, slip and number of turns the best motion
// [Mouret Clune 2015].
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/search/map_elites.h"

namespace gaitsmith::shell {

class EliteMap {
 public:
  /// @param searched the document that was searched. @param state of its search (Search::Save)
  /// @return nothing: that is no state of a MAP-Elites search of the document
  [[nodiscard]] static std::optional<EliteMap> Of(const Document& searched,
                                                  std::span<const std::uint8_t> state);

  [[nodiscard]] const Figure& Whose() const { return searched_.figure; }
  /// What was searched for, and how.
  [[nodiscard]] std::string Title() const;
  [[nodiscard]] const ElitesSettings& Settings() const { return searched_.search.elites; }
  /// Of each axis.
  [[nodiscard]] int Bins() const { return bins_; }
  /// Motions in all cells, and in those with so many turns.
  [[nodiscard]] int Count() const;
  [[nodiscard]] int Count(int turns) const;
  /// Null: nobody is there. @param height, slip, turns  bins, [0, Bins())
  [[nodiscard]] const MapElites::Elite* At(int height, int slip, int turns) const;
  /// Where the bins of an axis begin and end; the last one has no end. @param axis 0 height [m], 1 slip [m],
  /// 2 turns
  [[nodiscard]] std::string RangeText(int axis, int bin) const;
  /// The least and the greatest fitness on the map.
  [[nodiscard]] float Least() const { return least_; }
  [[nodiscard]] float Best() const { return best_; }
  /// The motion there, as a document of its own; there is one.
  [[nodiscard]] Document MotionAt(int height, int slip, int turns) const;

 private:
  [[nodiscard]] std::size_t Index(int height, int slip, int turns) const {
    const auto bins = static_cast<std::size_t>(bins_);
    return (static_cast<std::size_t>(height) * bins + static_cast<std::size_t>(slip)) * bins +
           static_cast<std::size_t>(turns);
  }

  Document searched_;
  int bins_ = 1;
  std::vector<MapElites::Elite> cells_;
  float least_ = 0.0f, best_ = 0.0f;
};

}  // namespace gaitsmith::shell
