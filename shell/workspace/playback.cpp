// SPDX-License-Identifier: MIT
// Time, interpolation, and the choice of the poses drawn behind the figure.
#include "shell/workspace/playback.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/document/composite.h"
#include "core/document/joints.h"
#include "core/planning/plan_playback.h"
#include "core/planning/plan_recorder.h"
#include "core/world/ground_view.h"

namespace gaitsmith::shell {

void Playback::Load(const Document& document, bool start_over) {
  motion_ = std::make_unique<Motion>(motion_ ? SimulateAnew(document, shown_, std::move(*motion_))
                                             : Simulate(document));
  Show(document, start_over);
}

void Playback::LoadPlanned(const Document& document) {
  if (document.plan.solved.unknowns.empty()) return Load(document, false);
  motion_ = std::make_unique<Motion>(RecordPlanned(document, SolvedMotion(document)));
  Show(document, false);
}

void Playback::Show(const Document& document, bool start_over) {
  shown_ = document;
  ground_ = Terrain(document.environment.ground);
  if (start_over || time_s_ > DurationS()) time_s_ = 0.0;
  Measure();
  FindRuns();
  FindContacts();
  ChoosePoses();
  SmoothCamera();
  SmoothHeight();
}

double Playback::DurationS() const {
  return static_cast<double>(motion_->Frames() - 1) * static_cast<double>(motion_->StepS());
}

int Playback::Frame() const {
  const int frame = static_cast<int>(time_s_ / static_cast<double>(motion_->StepS()) + 1e-6);
  return std::clamp(frame, 0, motion_->Frames() - 1);
}

bool Playback::Advance(double seconds) {
  if (!playing_ || motion_ == nullptr || motion_->Frames() < 2) return false;
  time_s_ += seconds * speed;
  if (time_s_ >= DurationS()) time_s_ = std::fmod(time_s_, DurationS());
  return true;
}

void Playback::Present() {
  constexpr double kStillS = 3.0;
  playing_ = !calm_;
  Seek(calm_ ? std::min(kStillS, 0.5 * DurationS()) : 0.0);
}

void Playback::Seek(double time_s) { time_s_ = std::clamp(time_s, 0.0, DurationS()); }

void Playback::SeekFrame(double time_s) {
  const auto step_s = static_cast<double>(motion_->StepS());
  Seek(std::round(time_s / step_s) * step_s);
}

void Playback::Step(int frames) {
  playing_ = false;
  Seek((Frame() + frames) * static_cast<double>(motion_->StepS()));
}

namespace {

struct Between {
  int frame;
  float share;  // share of the next frame
};

Between At(const Motion& motion, double time_s) {
  const double position =
      std::clamp(time_s / static_cast<double>(motion.StepS()), 0.0, motion.Frames() - 1.0);
  const int frame = std::min(static_cast<int>(position), std::max(0, motion.Frames() - 2));
  return {frame, motion.Frames() < 2 ? 0.0f : static_cast<float>(position - frame)};
}

}  // namespace

Playback::Point Playback::CentreAt(double time_s) const {
  const auto [frame, share] = At(*motion_, time_s);
  const Motion::Frame& a = motion_->At(frame);
  const Motion::Frame& b = motion_->At(std::min(frame + 1, motion_->Frames() - 1));
  return {a.x_m + (b.x_m - a.x_m) * static_cast<double>(share), a.y_m + (b.y_m - a.y_m) * share};
}

std::vector<Playback::Point> Playback::EndpointsAt(double time_s) const {
  const auto [frame, share] = At(*motion_, time_s);
  const int next = std::min(frame + 1, motion_->Frames() - 1);
  const Point centre = CentreAt(time_s);
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(motion_->Connections().contacts));
  for (int k = 0; k < motion_->Connections().contacts; ++k) {
    const Motion::Point a = motion_->Endpoint(frame, k);
    const Motion::Point b = motion_->Endpoint(next, k);
    points.push_back({centre.x_m + static_cast<double>(a.x + (b.x - a.x) * share),
                      centre.y_m + a.y + (b.y - a.y) * share});
  }
  return points;
}

Playback::Height Playback::HeightAt(double time_s) const {
  const double at = std::clamp(time_s / kHeightEveryS, 0.0, static_cast<double>(height_m_.size() - 1));
  const auto i = static_cast<std::size_t>(at);
  const float share = static_cast<float>(at) - static_cast<float>(i);
  const Height &a = height_m_[i], &b = height_m_[std::min(i + 1, height_m_.size() - 1)];
  return {a.now_m + (b.now_m - a.now_m) * share, a.around_m + (b.around_m - a.around_m) * share};
}

double Playback::CameraXAt(double time_s) const {
  const auto [frame, share] = At(*motion_, time_s);
  const auto i = static_cast<std::size_t>(frame);
  const double a = camera_x_m_[i];
  const double b = camera_x_m_[std::min(i + 1, camera_x_m_.size() - 1)];
  return a + (b - a) * static_cast<double>(share);
}

float Playback::CameraGroundAt(double time_s) const {
  if (camera_ground_m_.empty()) return 0.0f;
  const auto [frame, share] = At(*motion_, time_s);
  const auto i = static_cast<std::size_t>(frame);
  const float a = camera_ground_m_[i];
  const float b = camera_ground_m_[std::min(i + 1, camera_ground_m_.size() - 1)];
  return a + (b - a) * share;
}

std::vector<float> Playback::StrainsNow() const {
  constexpr int kAround = 2;  // frames
  if (!HasLimitedJoints(shown_)) return {};
  const int first = std::max(1, Frame() - kAround), last = std::min(Frame() + kAround, motion_->Frames() - 1);
  std::vector<float> strains(static_cast<std::size_t>(motion_->Bones().joints), 0.0f);
  for (int joint = 0; joint < motion_->Bones().joints; ++joint) {
    float& strain = strains[static_cast<std::size_t>(joint)];
    for (int frame = first; frame <= last; ++frame)
      strain += motion_->Strain(frame, joint) / static_cast<float>(last - first + 1);
  }
  return strains;
}

void Playback::Measure() {
  // Keeps a motion that explodes from shrinking the figure to nothing [m].
  constexpr float kFarthest = 1000.0f;
  const int endpoints = motion_->Connections().contacts;
  reach_m_ = 0.05f;
  for (int frame = 0; frame < motion_->Frames(); frame += 5) {
    for (int k = 0; k < endpoints; ++k) {
      const Motion::Point p = motion_->Endpoint(frame, k);
      reach_m_ = std::max(reach_m_, std::sqrt(p.x * p.x + p.y * p.y));
    }
  }
  reach_m_ = std::min(reach_m_, kFarthest);
  const Motion::Point first = motion_->Endpoint(0, 0);
  float low = first.y, high = first.y;
  for (int k = 1; k < endpoints; ++k) {
    low = std::min(low, motion_->Endpoint(0, k).y);
    high = std::max(high, motion_->Endpoint(0, k).y);
  }
  standing_m_ = std::max(high - low, 0.05f);
}

void Playback::FindRuns() {
  runs_.clear();
  for (int frame = 0; frame < motion_->Frames(); ++frame) {
    const Motion::Frame& f = motion_->At(frame);
    if (f.clip < 0) continue;
    if (runs_.empty() || runs_.back().clip != f.clip || runs_.back().rule != f.rule) {
      runs_.push_back({frame, frame, f.clip, f.rule});
    }
    runs_.back().end_frame = frame + 1;
  }
}

void Playback::FindContacts() {
  contacts_.clear();
  bool before = false;
  for (int frame = 0; frame < motion_->Frames(); ++frame) {
    bool touches = false;
    for (int k = 0; k < motion_->Connections().contacts && !touches; ++k)
      touches = motion_->Force(frame, k).y > 0.0f;
    if (touches && !before) contacts_.push_back({frame, frame});
    if (touches) contacts_.back().end_frame = frame + 1;
    before = touches;
  }
}

// Free ground between two poses [m]; negative where their limbs would overlap.
float Playback::GapM(int frame, int other) const {
  const auto moved = static_cast<float>(motion_->At(other).x_m - motion_->At(frame).x_m);
  const float side = moved < 0.0f ? -1.0f : 1.0f;
  float leading = 0.0f, trailing = 0.0f;
  for (int k = 0; k < motion_->Connections().contacts; ++k) {
    leading = std::max(leading, side * motion_->Endpoint(frame, k).x);
    trailing = std::max(trailing, -side * motion_->Endpoint(other, k).x);
  }
  return side * moved - leading - trailing;
}

// Keeps a pose if it is clear of the pose before, and at the latest when the centre has moved by both widths.
// A figure on the spot keeps only its first pose.
void Playback::ChoosePoses() {
  pose_frames_.assign(1, 0);
  for (int frame = 1; frame < motion_->Frames(); ++frame) {
    const int last = pose_frames_.back();
    const double moved =
        std::abs(motion_->At(frame).x_m - motion_->At(last).x_m) / static_cast<double>(reach_m_);
    if (moved >= 2.0 || (moved >= 1.3 && GapM(last, frame) > 0.05f * reach_m_)) pose_frames_.push_back(frame);
  }
}

namespace {

/// The mean of the values up to `window` places away from each.
std::vector<double> Smoothed(const std::vector<double>& values, int window) {
  const auto count = static_cast<int>(values.size());
  std::vector<double> sums(values.size() + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  std::vector<double> smooth;
  smooth.reserve(values.size());
  for (int i = 0; i < count; ++i) {
    const int low = std::max(0, i - window);
    const int high = std::min(count, i + window + 1);
    smooth.push_back((sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)]) /
                     (high - low));
  }
  return smooth;
}

}  // namespace

void Playback::SmoothCamera() {
  const int window = std::max(1, static_cast<int>(0.6f / motion_->StepS()));
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(motion_->Frames()));
  for (int frame = 0; frame < motion_->Frames(); ++frame) values.push_back(motion_->At(frame).x_m);
  camera_x_m_ = Smoothed(values, window);
  camera_ground_m_.clear();
  if (ground_.Level()) return;
  for (double& value : values) value = HeightBelow(ground_, value);
  for (const double height : Smoothed(values, window)) camera_ground_m_.push_back(static_cast<float>(height));
}

// What is highest around a moment rises before the figure does.
void Playback::SmoothHeight() {
  constexpr float kHighest = 50.0f;  // in reaches; a motion that explodes has no end
  constexpr std::size_t kSecond = 10;
  const int each = std::max(1, static_cast<int>(kHeightEveryS / static_cast<double>(motion_->StepS())));
  std::vector<float> tops;
  for (int frame = 0; frame < motion_->Frames(); ++frame) {
    if (frame % each == 0) tops.push_back(0.0f);
    const float ground_m =
        camera_ground_m_.empty() ? 0.0f : camera_ground_m_[static_cast<std::size_t>(frame)];
    for (int k = 0; k < motion_->Connections().contacts; ++k)
      tops.back() = std::max(tops.back(), motion_->At(frame).y_m + motion_->Endpoint(frame, k).y - ground_m);
    tops.back() = std::min(tops.back(), kHighest * reach_m_);
  }
  const auto around = [](const std::vector<float>& values, std::size_t i, std::size_t reach) {
    const std::size_t first = i < reach ? 0 : i - reach;
    return std::span(values).subspan(first, std::min(values.size(), i + reach + 1) - first);
  };
  const auto mean = [](std::span<const float> values) {
    return std::accumulate(values.begin(), values.end(), 0.0f) / static_cast<float>(values.size());
  };
  std::vector<float> highest;
  highest.reserve(tops.size());
  for (std::size_t i = 0; i < tops.size(); ++i) highest.push_back(std::ranges::max(around(tops, i, kSecond)));
  height_m_.clear();
  height_m_.reserve(tops.size());
  for (std::size_t i = 0; i < tops.size(); ++i)
    height_m_.push_back({mean(around(tops, i, 3)), mean(around(highest, i, kSecond / 2))});
}

}  // namespace gaitsmith::shell
