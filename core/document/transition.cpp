// SPDX-License-Identifier: MIT
#include "core/document/transition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/document/timeline_edit.h"
#include "core/physics/evaluator.h"
#include "core/physics/simulation.h"
#include "core/physics/style_meter.h"

namespace gaitsmith {

namespace {

/// What two states are compared by, one number after another, and what counts as a small difference of each.
class Features {
 public:
  explicit Features(const Motion& motion) : motion_(motion) {
    const auto joints = static_cast<std::size_t>(motion.Bones().joints);
    small_.insert(small_.end(), joints, 0.1f);               // angle [rad]
    small_.insert(small_.end(), joints, 0.5f);               // rate [rad/s]
    small_.insert(small_.end(), 2, 0.2f);                    // direction of the root
    small_.push_back(0.05f * motion.Bones().longest_rod_m);  // height [m]
    small_.insert(small_.end(), 2, 0.2f);                    // velocity [m/s]
  }
  [[nodiscard]] std::size_t Count() const { return small_.size(); }
  [[nodiscard]] float Small(std::size_t feature) const { return small_[feature]; }
  void Of(const Motion& motion, int frame, std::vector<float>& values) const {
    values.clear();
    const int joints = motion_.Bones().joints;
    for (int j = 0; j < joints; ++j) values.push_back(motion.AngleRad(frame, j));
    for (int j = 0; j < joints; ++j) values.push_back(motion.RateRadps(frame, j));
    const Motion::Frame& f = motion.At(frame);
    const double turn = f.turn_rad - 2.0 * kPi * std::floor(f.turn_rad / (2.0 * kPi));
    const SineCosine direction = SinCos(static_cast<float>(turn));
    values.insert(values.end(),
                  {direction.sine, direction.cosine, f.y_m, f.velocity_x_mps, f.velocity_y_mps});
  }

 private:
  const Motion& motion_;
  std::vector<float> small_;
};

}  // namespace

Nearness NearnessOf(const Motion& motion, int frame, const Motion& usual) {
  const Features features(usual);
  const std::size_t count = features.Count();
  std::vector<float> here, there;
  features.Of(motion, frame, here);
  // How much each number varies in the usual motion: its standard deviation.
  std::vector<double> mean(count, 0.0), square(count, 0.0);
  for (int at = 0; at < usual.Frames(); ++at) {
    features.Of(usual, at, there);
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<double>(there[i]);
      mean[i] += value / usual.Frames();
      square[i] += value * value / usual.Frames();
    }
  }
  std::vector<float> scale(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double variance = std::max(0.0, square[i] - mean[i] * mean[i]);
    scale[i] = 1.0f / std::max(features.Small(i), static_cast<float>(std::sqrt(variance)));
  }
  Nearness nearest{.distance = std::numeric_limits<float>::infinity()};
  for (int at = 0; at < usual.Frames(); ++at) {
    features.Of(usual, at, there);
    float sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
      const float off = (here[i] - there[i]) * scale[i];
      sum += off * off;
    }
    const float distance = std::sqrt(sum / static_cast<float>(count));
    if (distance < nearest.distance) nearest = {distance, at};
  }
  return nearest;
}

Motion UsualMotion(const Document& d, int controller) {
  const Clip whole{.controller = controller, .start_step = 0};
  return {d.figure, d.environment, d.start, {}, d.controllers, std::span(&whole, 1), d.task.duration_steps};
}

namespace {

Controllers<1> Decoded(const Document& d, int clip) {
  const Clip& one = d.timeline[static_cast<std::size_t>(clip)];
  const Controller& controller = d.controllers[static_cast<std::size_t>(one.controller)];
  const std::span<const Gene> genes(controller.genes);
  return DecodeControllers<1>(controller.Shape(d.figure.Rods()), controller.senses, std::span(&genes, 1),
                              JointLimits(Skeleton(d.figure)), kStep);
}

}  // namespace

TransitionMap::TransitionMap(const Document& document, int clip, int every, int after)
    : document_(document), skeleton_(document.figure), controller_(Decoded(document, clip)), after_(after) {
  std::vector<Controllers<1>> before;
  before.reserve(static_cast<std::size_t>(clip));
  for (int index = 0; index < clip; ++index) before.push_back(Decoded(document_, index));
  const auto last = static_cast<std::size_t>(clip) - 1;
  const int begun = document_.timeline[last].start_step;
  const int end = std::min(begun + 2 * (document_.timeline[last + 1].start_step - begun), kMaxSteps - 1);
  Simulation<1> simulation(skeleton_, document_.environment, document_.start, document_.pushes);
  std::size_t in_charge = 0;  // one past its index
  for (int step = 0; step <= end; ++step) {
    while (in_charge < before.size() && document_.timeline[in_charge].start_step <= step)
      simulation.Follow(before[in_charge++]);
    if (step >= begun + kShortestClip && (step - begun) % every == 0) moments_.push_back(simulation.Save());
    simulation.Step();
  }
}

float TransitionMap::ScoreFrom(const Moment<1>* moment) const {
  std::span<const Push> pushes = document_.pushes;
  if (moment == nullptr) pushes = {};
  Simulation<1> simulation(skeleton_, document_.environment, document_.start, pushes);
  if (moment != nullptr) simulation.BeginAt(*moment);
  simulation.Follow(controller_);
  StyleMeter<1> meter(skeleton_, simulation.State(), WeightedFurtherTerms(document_.task), kStep);
  for (int step = 0; step < after_; ++step) {
    simulation.Step();
    meter.Add();
  }
  Terms terms = simulation.TermsOf(0);
  meter.Put(0, terms);
  return Fitness(document_.task, terms);
}

}  // namespace gaitsmith
