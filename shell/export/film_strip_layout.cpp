// SPDX-License-Identifier: MIT
// Frames, cells and scale of a film strip.
#include "shell/export/film_strip_layout.h"

#include <algorithm>
#include <cmath>

#include "core/world/ground_view.h"
#include "shell/export/moving_bones.h"

namespace gaitsmith::shell {

namespace {

constexpr double kStripWidth = 1200.0;
constexpr double kInnerWidth = kStripWidth - 2.0 * kStripMargin;
constexpr int kMaxColumns = 9;
constexpr double kCellGap = 10.0;
constexpr double kCellPadding = 9.0;
constexpr double kHeadroom = 16.0;          // above the highest pose [px]
constexpr double kTallestSharedPx = 330.0;  // height of the tallest pose on a common ground [px]
constexpr double kTallestOwnPx = 210.0;     // height of the tallest pose on separate grounds [px]
constexpr double kSmallestSharedPx = 84.0;  // poses below this height get separate grounds [px]
constexpr double kMinGapShare = 0.06;       // between neighbours, as a share of a pose's width
constexpr double kMinTickPx = 58.0;         // space for the label of a mark [px]

std::vector<int> FramesOf(const Motion& motion, const FilmStripOptions& options) {
  const int last = motion.Frames() - 1;
  const auto frame_at = [&](double seconds) {
    const double step = std::floor(seconds / static_cast<double>(motion.StepS()) + 0.5);
    return static_cast<int>(std::clamp(step, 0.0, static_cast<double>(last)));
  };
  const int from = frame_at(options.from_s), to = std::max(from, frame_at(options.to_s));
  const int poses = std::clamp(options.poses, kMinPoses, kMaxPoses);
  std::vector<int> frames;
  frames.reserve(static_cast<std::size_t>(poses));
  for (int i = 0; i < poses; ++i)
    frames.push_back(from + ((to - from) * i * 2 + poses - 1) / (2 * (poses - 1)));
  return frames;
}

PoseBounds BoundsOf(const Motion& motion, int frame, double half_rod_m) {
  const Motion::Frame& at = motion.At(frame);
  PoseBounds bounds{1e300, -1e300, 1e300, -1e300};
  for (int k = 0; k < motion.Connections().contacts; ++k) {
    const Motion::Point point = motion.Endpoint(frame, k);
    const double x = at.x_m + static_cast<double>(point.x);
    const double y = static_cast<double>(at.y_m) + static_cast<double>(point.y);
    bounds = {std::min(bounds.left, x - half_rod_m), std::max(bounds.right, x + half_rod_m),
              std::min(bounds.bottom, y - half_rod_m), std::max(bounds.top, y + half_rod_m)};
  }
  return bounds;
}

/// Whether no pose overlaps the previous one, and all move in one direction.
bool StandApart(const std::vector<PoseBounds>& poses) {
  const double way = poses.back().left > poses.front().left ? 1.0 : -1.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PoseBounds& left = way > 0.0 ? poses[i - 1] : poses[i];
    const PoseBounds& right = way > 0.0 ? poses[i] : poses[i - 1];
    if (right.left - left.right < kMinGapShare * (right.right - right.left)) return false;
  }
  return true;
}

}  // namespace

double RoundLength(double scale, double least_px) {
  double length = 0.01;
  for (int grow = 0; length * scale < least_px && grow < 40; ++grow) length *= grow % 3 == 1 ? 2.5 : 2.0;
  return length;
}

StripLayout LayOutStrip(const Motion& motion, const Terrain& ground, const FilmStripOptions& options) {
  StripLayout layout{};
  layout.frames = FramesOf(motion, options);
  layout.width = kStripWidth;
  const double rod_m = MovingBones(motion).ThicknessM();

  std::vector<PoseBounds> poses;
  double widest = 0.0, tall = 0.0;
  for (const int frame : layout.frames) {
    poses.push_back(BoundsOf(motion, frame, 0.5 * rod_m));
    widest = std::max(widest, poses.back().right - poses.back().left);
    tall = std::max(tall, poses.back().top - poses.back().bottom);
  }
  const auto [least, most] = std::minmax(poses.front().left, poses.back().left);
  const double span = most - least + widest;
  // Above the lowest ground in view.
  const double shared_level = LowestBetween(ground, least, least + span);
  double top = 0.0;
  std::vector<double> levels;
  for (const PoseBounds& pose : poses) {
    const double middle = 0.5 * (pose.left + pose.right);
    levels.push_back(LowestBetween(ground, middle - 0.5 * widest, middle + 0.5 * widest));
    top = std::max(top, pose.top - std::min(shared_level, levels.back()));
  }
  // The rods' edge, not their axis, touches the ground.
  top = std::max(top + 0.5 * rod_m, 1e-6);
  const double shared = std::min((kInnerWidth - 2.0 * kCellPadding) / span, kTallestSharedPx / top);
  layout.own_ground = !StandApart(poses) || shared * tall < kSmallestSharedPx;
  const auto count = static_cast<int>(poses.size());
  const int rows = layout.own_ground ? (count + kMaxColumns - 1) / kMaxColumns : 1;
  const int columns = layout.own_ground ? (count + rows - 1) / rows : 1;
  const double cell_width = (kInnerWidth - (columns - 1) * kCellGap) / columns;
  layout.scale =
      layout.own_ground ? std::min((cell_width - 2.0 * kCellPadding) / widest, kTallestOwnPx / top) : shared;
  layout.rod_px = rod_m * layout.scale;
  layout.tick_m = RoundLength(layout.scale, kMinTickPx);

  const double ground_at = kHeadroom + top * layout.scale;
  const double cell_height = ground_at + kStripCaption;
  for (int i = 0; i < (layout.own_ground ? count : 1); ++i) {
    const int row = i / columns;
    // Centres a short last row.
    const int in_row = std::min(columns, count - row * columns);
    const double indent = layout.own_ground ? 0.5 * (columns - in_row) * (cell_width + kCellGap) : 0.0;
    const double x = kStripMargin + indent + (i % columns) * (cell_width + kCellGap);
    const double y = kStripHeader + row * (cell_height + kCellGap);
    const PoseBounds& pose = poses[static_cast<std::size_t>(i)];
    const double middle = layout.own_ground ? 0.5 * (pose.left + pose.right) : least + 0.5 * span;
    const double left_m = middle - 0.5 * cell_width / layout.scale;
    const double level_m = layout.own_ground ? levels[static_cast<std::size_t>(i)] : shared_level;
    layout.cells.push_back({x, y, cell_width, cell_height, y + ground_at, left_m, level_m});
  }
  layout.height = kStripHeader + rows * (cell_height + kCellGap) - kCellGap + kStripMargin;
  return layout;
}

}  // namespace gaitsmith::shell
