// SPDX-License-Identifier: MIT
#include "core/rollout/motion.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/physics/simulation.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/style_meter.h"

namespace gaitsmith {

namespace {

constexpr int kCheckpointSteps = 100;

/// Bit i: input i of the network is 1.
std::uint64_t FiringBits(const MotionState<1>& s) {
  static_assert(kMaxInputs <= 64);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kMaxInputs; ++i) bits |= std::uint64_t{s.network.input[i][0] > 0.0f} << i;
  return bits;
}

}  // namespace

struct Motion::Checkpoint {
  Moment<1> moment;  // before a clip that begins here takes over
  StyleMeter<1>::Sums sums;
  TrajectoryHash hash;
  int clip;
};

Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;
Motion::~Motion() = default;

Motion::Motion(const Figure& figure, const Environment& environment, const StartState& start,
               std::span<const Push> pushes, std::span<const Controller> controllers,
               std::span<const Clip> clips, int steps, float step_s)
    : skeleton_(figure), step_s_(step_s), senses_per_frame_(SenseCount(SenseKind::kPhysical, figure.Rods())) {
  Run(environment, start, pushes, controllers, clips, steps);
}

Motion::Motion(Motion known, int parting, const Figure& figure, const Environment& environment,
               const StartState& start, std::span<const Push> pushes, std::span<const Controller> controllers,
               std::span<const Clip> clips, int steps)
    : Motion(std::move(known)) {
  skeleton_ = Skeleton(figure);
  senses_per_frame_ = SenseCount(SenseKind::kPhysical, figure.Rods());
  Rewind(std::min(parting, steps));
  Run(environment, start, pushes, controllers, clips, steps);
}

void Motion::Rewind(int step) {
  while (!checkpoints_.empty() && checkpoints_.back().moment.step > step) checkpoints_.pop_back();
  const std::size_t frames =
      checkpoints_.empty() ? 0 : static_cast<std::size_t>(checkpoints_.back().moment.step) + 1;
  frames_.resize(frames);
  terms_.resize(frames);
  endpoints_.resize(frames * static_cast<std::size_t>(skeleton_.endpoints));
  forces_.resize(endpoints_.size());
  angles_.resize(frames * static_cast<std::size_t>(skeleton_.joints));
  rates_.resize(angles_.size());
  senses_.resize(frames * static_cast<std::size_t>(senses_per_frame_));
}

void Motion::Run(const Environment& environment, const StartState& start, std::span<const Push> pushes,
                 std::span<const Controller> controllers, std::span<const Clip> clips, int steps) {
  const auto limits = JointLimits(skeleton_);
  std::vector<Controllers<1>> decoded;
  decoded.reserve(clips.size());
  for (const Clip& clip : clips) {
    const Controller& controller = controllers[static_cast<std::size_t>(clip.controller)];
    const std::span<const Gene> genes(controller.genes);
    decoded.push_back(DecodeControllers<1>(controller.Shape(skeleton_.rods), controller.senses,
                                           std::span(&genes, 1), limits, step_s_));
  }

  Simulation<1> simulation(skeleton_, environment, start, pushes, step_s_);
  const MotionState<1>& s = simulation.State();
  StyleMeter<1> meter(skeleton_, s, kAllFurtherTerms, step_s_);
  TrajectoryHash hash;
  int clip = -1;
  const auto record = [&] {
    const auto* network =
        clip < 0 ? nullptr : std::get_if<Network<1>>(&decoded[static_cast<std::size_t>(clip)]);
    const std::uint64_t firing = network == nullptr ? 0 : FiringBits(s);
    // Hidden nodes are the last inputs.
    const int rule = network == nullptr
                         ? s.rule[0]
                         : std::popcount(firing >> (network->Shape().touches + network->Shape().joints));
    frames_.push_back({s.distance_m[0], s.height_m[0], s.velocity_x[0], s.velocity_y[0], s.turn_rad[0],
                       s.angular_momentum[0], s.ground.normal_work_j[0], s.ground.friction_work_j[0],
                       s.ground.friction_gain_j[0], s.lifting_work_j[0], clip, rule, firing});
    meter.Put(0, terms_.emplace_back(simulation.TermsOf(0)));
    for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton_.endpoints); ++k) {
      const float x = s.PoseNow().endpoint_x[k][0], y = s.PoseNow().endpoint_y[k][0];
      endpoints_.push_back({s.cosine[0] * x - s.sine[0] * y, s.sine[0] * x + s.cosine[0] * y});
      forces_.push_back({s.last_tangent[k][0] / step_s_, s.last_normal[k][0] / step_s_});
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton_.joints); ++j) {
      angles_.push_back(s.angle_rad[j][0]);
      rates_.push_back(s.rate_radps[j][0]);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(senses_per_frame_); ++i)
      senses_.push_back(s.senses[i][0]);
  };

  const auto take_over = [&](int step) {
    while (clip + 1 < static_cast<int>(clips.size()) &&
           clips[static_cast<std::size_t>(clip) + 1].start_step <= step) {
      ++clip;
      simulation.Follow(decoded[static_cast<std::size_t>(clip)]);
    }
  };
  if (checkpoints_.empty()) {
    take_over(0);
    record();
  } else {
    const Checkpoint& last = checkpoints_.back();
    clip = last.clip;
    simulation.Restore(last.moment, clip < 0 ? nullptr : &decoded[static_cast<std::size_t>(clip)]);
    meter.Restore(last.sums);
    hash = last.hash;
    checkpoints_.pop_back();
  }
  for (int step = static_cast<int>(frames_.size()) - 1; step < steps; ++step) {
    if (step % kCheckpointSteps == 0 && step > 0)
      checkpoints_.push_back({simulation.Save(), meter.Save(), hash, clip});
    take_over(step);
    simulation.Step();
    meter.Add();
    simulation.AddTo(hash, 0);
    record();
  }
  hash_ = hash.Value();
}

}  // namespace gaitsmith
