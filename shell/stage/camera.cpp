// SPDX-License-Identifier: MIT
#include "shell/stage/camera.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::shell {
namespace {

struct Extent {
  double left_m, right_m;
  float low_m;
};
Extent ExtentOf(const std::vector<Playback::Point>& endpoints) {
  Extent extent{endpoints[0].x_m, endpoints[0].x_m, endpoints[0].y_m};
  for (const Playback::Point& point : endpoints) {
    extent.left_m = std::min(extent.left_m, point.x_m);
    extent.right_m = std::max(extent.right_m, point.x_m);
    extent.low_m = std::min(extent.low_m, point.y_m);
  }
  return extent;
}

}  // namespace

float GroundRoom(float stage_height, bool buttons) {
  constexpr float kWithButtons = 104.0f;
  const float bare = std::clamp(0.178f * stage_height, std::min(62.0f, 0.17f * stage_height), 130.0f);
  return buttons ? std::max(bare, kWithButtons) : bare;
}

Camera AimCamera(const Playback& player, const Environment& world, const CameraSettings& gaze,
                 const ImRect& rect, float ground_y, const std::optional<Framing>& framing) {
  constexpr float kNumbers = 70.0f;  // height of the numbers at the top [points]
  constexpr float kLeast = 96.0f;    // of a figure on a low stage [points]
  const float above = ground_y - rect.Min.y, half = 0.5f * rect.GetHeight();
  const float tall = std::max(std::min(half, above - (framing ? framing->headroom : kNumbers)),
                              std::min(1.15f * kLeast, above - 2.0f));
  const float reach = player.ReachM();
  const float across_m = rect.GetWidth() < kPhoneWidth ? 2.0f : 5.0f;
  const Extent drawn = ExtentOf(player.EndpointsAt(0.0));
  constexpr float kBody = 0.3f;  // a body is wider than its rods [m]
  const float widest = framing ? (framing->right - framing->left) * rect.GetWidth() /
                                     (static_cast<float>(drawn.right_m - drawn.left_m) + kBody)
                               : rect.GetWidth() / (3.2f * reach);
  const float standing = std::min({tall / player.StandingM(), rect.GetWidth() / across_m, widest});
  const float room = std::max({20.0f, above - kNumbers, standing * player.StandingM()});
  const Playback::Height height = player.HeightAt(player.TimeS());
  Camera camera;
  const bool low = tall > half;
  // In a high jump two thirds of that, or a third of a low stage, of which the numbers take their part.
  const float part = std::max(1.0f, half / tall) / 1.5f;
  const float least = std::min(
      standing, std::max(standing * part, low ? kLeast / std::max(player.StandingM(), 1.5f * reach) : 0.0f));
  camera.level_m = player.CameraGroundAt(player.TimeS());
  camera.scale = gaze.zoom * std::clamp(room / std::max(height.around_m, 0.1f), least, standing);
  const Extent extent = ExtentOf(player.EndpointsAt(player.TimeS()));
  // Looks up after a figure that leaps out of the stage, but not so far that its feet are hidden.
  const float ground_room = rect.Max.y - ground_y - 8.0f;
  const float hidden =
      std::clamp(height.now_m * camera.scale - gaze.zoom * room, 0.0f,
                 std::max(0.0f, (extent.low_m - camera.level_m) * camera.scale + ground_room));

  // Leave more space behind the figure, for its past poses.
  const double width_m = static_cast<double>(rect.GetWidth() / camera.scale);
  const double margin_m = 1.35 * static_cast<double>(reach);
  const auto finite = [](double metres) { return std::isfinite(metres) ? metres : 0.0; };
  const double x = finite(player.CameraXAt(player.TimeS()));
  const double end_m = finite(player.Shown().At(player.Shown().Frames() - 1).x_m);
  if (framing) {
    const double middle_m = 0.5 * (drawn.left_m + drawn.right_m) + x - finite(player.CameraXAt(0.0));
    camera.left_m = middle_m - 0.5 * static_cast<double>(framing->left + framing->right) * width_m;
  } else if (std::abs(end_m) < margin_m) {
    camera.left_m = x - 0.5 * width_m;
  } else if (end_m < 0.0) {
    camera.left_m = std::max(std::min(x - 0.29 * width_m, margin_m - width_m), x - 0.8 * width_m);
  } else {
    camera.left_m = std::min(std::max(x - 0.71 * width_m, -margin_m), x - 0.2 * width_m);
  }
  // A figure that leaps ahead of the smooth camera stays on the stage.
  const double least_m = extent.right_m - width_m, most_m = extent.left_m;
  if (least_m < most_m) camera.left_m = std::clamp(camera.left_m, least_m, most_m);
  camera.left_m += gaze.pan_m;
  camera.origin = {rect.Min.x, ground_y + hidden};
  camera.pivot = static_cast<float>(x - camera.left_m) * camera.scale;
  const float slope = GroundAngle(world, static_cast<float>(player.TimeS()));
  camera.sine = std::sin(slope);
  camera.cosine = std::cos(slope);
  return camera;
}

}  // namespace gaitsmith::shell
