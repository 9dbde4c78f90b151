// SPDX-License-Identifier: MIT
#include "core/gait/likeness.h"

#include <algorithm>
#include <cmath>

#include "core/world/environment.h"

namespace gaitsmith {

namespace {

constexpr std::size_t kOfBody = 3;      // height, and velocity of the centre of mass
constexpr std::size_t kOfEndpoint = 5;  // place and velocity about the centre of mass, and whether it bears
/// Contact flickers, so it is averaged over this many steps before and after.
constexpr int kFlicker = 3;

double Share(const Motion& motion, int frame, int endpoint, int first, int last) {
  int bears = 0, looked = 0;
  for (int i = std::max(first, frame - kFlicker); i <= std::min(last, frame + kFlicker); ++i, ++looked)
    bears += motion.Force(i, endpoint).y > 0.0f ? 1 : 0;
  return static_cast<double>(bears) / looked;
}

}  // namespace

Likeness::Likeness(const Motion& motion, int first, int last, const LimbPairs& pairs)
    : frames_(static_cast<std::size_t>(last - first) + 1),
      width_(kOfBody + kOfEndpoint * static_cast<std::size_t>(motion.Connections().contacts)) {
  const auto length_m = static_cast<double>(motion.Bones().longest_rod_m);
  const double time_s = std::sqrt(length_m / static_cast<double>(kStandardGravity));
  const double rate = time_s / length_m;
  state_.reserve(frames_ * width_);
  later_.reserve(frames_ * width_);
  const auto row = [&](int frame, std::vector<double>& into, auto&& endpoint_of) {
    const Motion::Frame& at = motion.At(frame);
    into.push_back(static_cast<double>(at.y_m) / length_m);
    into.push_back(static_cast<double>(at.velocity_x_mps) * rate);
    into.push_back(static_cast<double>(at.velocity_y_mps) * rate);
    const int before = std::max(frame - 1, 0);
    const double step_s = static_cast<double>(motion.StepS());
    for (int k = 0; k < motion.Connections().contacts; ++k) {
      const int endpoint = endpoint_of(k);
      const Motion::Point now = motion.Endpoint(frame, endpoint), was = motion.Endpoint(before, endpoint);
      into.push_back(static_cast<double>(now.x) / length_m);
      into.push_back(static_cast<double>(now.y) / length_m);
      into.push_back(static_cast<double>(now.x - was.x) / step_s * rate);
      into.push_back(static_cast<double>(now.y - was.y) / step_s * rate);
      into.push_back(Share(motion, frame, endpoint, first, last));
    }
  };
  for (int frame = first; frame <= last; ++frame) {
    row(frame, state_, [](int k) { return k; });
    row(frame, later_, [&](int k) { return pairs.endpoint[static_cast<std::size_t>(k)]; });
  }
  double squares = 0.0;
  std::size_t places = 0;
  for (std::size_t column = 0; column < width_; ++column) {
    double sum = 0.0, square = 0.0;
    for (std::size_t i = 0; i < frames_; ++i) sum += state_[i * width_ + column];
    const double mean = sum / static_cast<double>(frames_);
    for (std::size_t i = 0; i < frames_; ++i) {
      const double off = state_[i * width_ + column] - mean;
      square += off * off;
      state_[i * width_ + column] = off;
      later_[i * width_ + column] -= mean;
    }
    // Height, and the two coordinates of each endpoint.
    const bool place = column == 0 || (column >= kOfBody && (column - kOfBody) % kOfEndpoint < 2);
    if (!place) continue;
    squares += square / static_cast<double>(frames_);
    ++places;
  }
  liveliness_ = std::sqrt(squares / static_cast<double>(places));
}

double Likeness::After(int lag) const {
  const std::size_t shift = static_cast<std::size_t>(lag) * width_;
  double apart = 0.0, now = 0.0, then = 0.0;
  for (std::size_t i = 0; i + shift < state_.size(); ++i) {
    const double one = state_[i], other = later_[i + shift];
    apart += (one - other) * (one - other);
    now += one * one;
    then += other * other;
  }
  return now + then > 0.0 ? 1.0 - apart / (now + then) : 1.0;
}

}  // namespace gaitsmith
