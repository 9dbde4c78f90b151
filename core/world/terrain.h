// SPDX-License-Identifier: MIT
// Ground that is drawn: steps, ramps, gaps, hurdles and rubble, as a line through corners.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/error.h"
#include "core/world/environment.h"

namespace gaitsmith {

/// The most corners of a ground, and where they may be [m].
inline constexpr int kMaxCorners = 64;
inline constexpr float kMaxCornerX = 200.0f;
inline constexpr float kMaxCornerY = 20.0f;
/// The first physical model that knows such ground.
inline constexpr int kFirstDrawnGround = 2;
/// The thinnest hurdle, and the narrowest gap [m]: corners are at least this far apart along the ground, or
/// one is right above the other.
inline constexpr float kLeastCornerStep = 0.01f;

/// Checks a ground: corners from left to right, at most two on top of each other.
/// @return what is wrong; `where` begins with "ground"
[[nodiscard]] Result<void> Validate(std::span<const Corner> ground);

/// The ground as faces: what is below and to the right of them, going from left to right, is solid. Before
/// the first corner and after the last one it goes on level.
class Terrain {
 public:
  struct Face {
    double x, y;    // where it begins [m]
    double length;  // [m]
    double ux, uy;  // unit direction
    /// Distance of a point from the face's line, > 0 outside [m].
    [[nodiscard]] double Above(double px, double py) const { return (py - y) * ux - (px - x) * uy; }
    /// How far along the face a point is [m].
    [[nodiscard]] double Along(double px, double py) const { return (px - x) * ux + (py - y) * uy; }
  };
  /// A corner that sticks out, and can touch a rod between its ends.
  struct Edge {
    double x, y;            // [m]
    double back_x, back_y;  // unit directions of its two faces, away from it
    double on_x, on_y;
    /// To which side of a line the ground around the edge is: 1 left, -1 right, 0 both or neither.
    /// @param ux, uy  unit direction of the line
    [[nodiscard]] int SideOfGround(double ux, double uy) const;
  };

  /// @param ground must be valid; empty: level everywhere
  explicit Terrain(std::span<const Corner> ground);

  [[nodiscard]] bool Level() const { return faces_.size() == 1; }
  /// Height of the ground [m]; at a vertical face that of its upper end.
  [[nodiscard]] double HeightAt(double x) const;
  /// How far the next corner is along the ground [m], > 0; infinity if there is none.
  /// @param side 1: to the right, -1: to the left
  [[nodiscard]] double NextCorner(double x, int side) const;
  [[nodiscard]] std::span<const Face> Faces() const { return faces_; }
  [[nodiscard]] std::span<const Edge> Edges() const { return edges_; }
  /// The faces, and the edges, that have a part between two places.
  [[nodiscard]] std::span<const Face> FacesBetween(double left, double right) const;
  [[nodiscard]] std::span<const Edge> EdgesBetween(double left, double right) const;

 private:
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
};

}  // namespace gaitsmith
