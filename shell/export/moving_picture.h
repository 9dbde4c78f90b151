// SPDX-License-Identifier: MIT
// A motion in a picture whose view follows the figure, as films have it (web/share/film.js): its scale, its
// view and the marks on its ground.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/world/terrain.h"
#include "shell/export/bone_shapes.h"
#include "shell/export/following_view.h"
#include "shell/export/moving_bones.h"

namespace gaitsmith::shell {

class MovingPicture {
 public:
  static constexpr int kWidth = 640, kHeight = 360;
  static constexpr double kGroundY = 292.0;  // of level ground [px]

  /// @param motion is kept as a reference @param loops the motion ends as it begins: then the view moves
  /// evenly, and marks fit into the way
  MovingPicture(const Document& document, const Motion& motion, bool loops);

  /// The length of a metre [px].
  [[nodiscard]] double Scale() const { return scale_; }
  [[nodiscard]] double Seconds() const { return 0.01 * (bones_.Frames() - 1); }
  [[nodiscard]] const MovingBones& Bones() const { return bones_; }

  /// Where a place of the world is in a frame [px].
  [[nodiscard]] std::array<double, 2> PlaceAt(int frame, const std::array<double, 2>& place_m) const;
  /// Where the ground begins in a frame [px]: its own coordinates are those of Surface and Marks.
  [[nodiscard]] std::array<double, 2> GroundAt(int frame) const;

  /// Keys of bone 0's start [px], y downwards, and of a bone's angle [degrees], clockwise.
  [[nodiscard]] Track PlaceKeys() const;
  [[nodiscard]] Track AngleKeys(int bone) const;
  /// Keys of GroundAt.
  [[nodiscard]] Track GroundKeys() const;

  /// Shapes in the order of drawing. Their outlines are in pixels, with y downwards.
  [[nodiscard]] const std::vector<BoneShape>& Shapes() const { return shapes_; }

  /// The ground's line from left to right, and its marks, as far as the view comes [px].
  [[nodiscard]] std::vector<std::array<double, 2>> Surface() const;
  /// Below all of it [px].
  [[nodiscard]] double Bottom() const;
  struct Mark {
    double x, y;       // on the ground [px]
    std::string text;  // such as "2 m"; empty in a loop
  };
  [[nodiscard]] std::vector<Mark> Marks() const;

 private:
  [[nodiscard]] std::array<double, 2> Reach() const;

  MovingBones bones_;
  Terrain ground_;
  FollowingView view_;
  bool loops_;
  double sole_m_;  // how far the figure's outline reaches below the endpoints on which it stands
  std::vector<BoneShape> shapes_;
  double scale_ = 1.0, tick_m_ = 1.0;
};

}  // namespace gaitsmith::shell
