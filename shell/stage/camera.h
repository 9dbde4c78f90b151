// SPDX-License-Identifier: MIT
// Maps ground coordinates [m] to canvas points. The ground is the x axis of a frame that a slope tilts.
#pragma once

#include <imgui.h>

#include <cmath>
#include <optional>

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct Camera {
  double left_m = 0.0;        // ground coordinate at the stage's left edge, at zero slope
  float level_m = 0.0f;       // height of the ground on which the camera stands
  float scale = 88.0f;        // points per metre
  ImVec2 origin{0.0f, 0.0f};  // the stage's left edge at level_m
  float pivot = 0.0f;         // centre of the slope's rotation, from the left edge [points]
  float sine = 0.0f;          // sine of the slope's angle, uphill to the right
  float cosine = 1.0f;

  /// Subtracts left_m in double precision, so that the picture does not jitter a kilometre from the origin.
  /// Clamps very distant and NaN positions to a point far off the stage, where drawing is harmless.
  [[nodiscard]] ImVec2 ToScreen(double x_m, float y_m) const {
    const float along = static_cast<float>(x_m - left_m) * scale - pivot;
    const float above = (y_m - level_m) * scale;
    return {Bounded(origin.x + pivot + along * cosine - above * sine),
            Bounded(origin.y - along * sine - above * cosine)};
  }

  struct Place {
    double x_m;  // along the ground
    float y_m;   // above it
  };
  /// The place that ToScreen draws at this point.
  [[nodiscard]] Place ToMetres(ImVec2 point) const {
    const float right = point.x - origin.x - pivot, up = origin.y - point.y;
    const float along = right * cosine + up * sine, above = up * cosine - right * sine;
    return {left_m + static_cast<double>((along + pivot) / scale), level_m + above / scale};
  }

 private:
  static float Bounded(float points) {
    constexpr float kFar = 1e6f;
    return std::fmax(-kFar, std::fmin(points, kFar));  // fmin returns kFar for a NaN
  }
};

/// The part of the world that the camera shows.
struct CameraSettings {
  float zoom = 1.0f;
  double pan_m = 0.0;  // offset of the camera from the figure
};

/// The part of the stage in which a standing figure is shown whole, beside what the stage says about it.
struct Framing {
  float headroom;     // height at the top that the figure leaves free [points]
  float left, right;  // its ends, as shares of the stage's width
};

/// Height of the ground below the ground line [points]. @param buttons  the stage has a row of buttons there
[[nodiscard]] float GroundRoom(float stage_height, bool buttons);

/// The standing figure takes half of the stage's height, if its width and the numbers at the top allow. The
/// camera follows smoothly. It backs off for high jumps until the figure would take a third, then looks up.
/// Where a drawn ground rises or falls, the camera rises and falls with it.
/// @param rect that the figure must stay in. @param ground_y of the ground line on the canvas [points]
[[nodiscard]] Camera AimCamera(const Playback&, const Environment&, const CameraSettings&, const ImRect& rect,
                               float ground_y, const std::optional<Framing>& = {});

}  // namespace gaitsmith::shell
