// SPDX-License-Identifier: MIT
// A recorded motion: what a document's figure does, step by step, for whoever draws, prints or hashes it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/physics/skeleton.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

class Motion {
 public:
  /// Simulates a composite motion.
  /// @param clips   sorted by start_step, the first at 0; with none the figure holds its drawn pose
  /// @param controllers for this figure; clips index into them
  /// @param steps   [0, kMaxSteps]
  Motion(const Figure& figure, const Environment& environment, const StartState& start,
         std::span<const Push> pushes, std::span<const Controller> controllers, std::span<const Clip> clips,
         int steps, float step_s = kStep);
  /// The same, where another motion of the same figure, ground and start is known: what they have in common
  /// is taken from it, and only the rest is simulated. Not a bit differs.
  /// @param parting all that acts before this step acts in both motions: clips, controllers and pushes
  Motion(Motion known, int parting, const Figure& figure, const Environment& environment,
         const StartState& start, std::span<const Push> pushes, std::span<const Controller> controllers,
         std::span<const Clip> clips, int steps);
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;
  ~Motion();

  /// Everything about one instant; frame 0 is the start.
  struct Frame {
    double x_m;  // centre of mass, along the ground
    float y_m;   // and above it
    float velocity_x_mps, velocity_y_mps;
    double turn_rad;                        // of the root rod, whole turns included
    float angular_momentum;                 // about the centre of mass [kg m^2/s]
    float normal_work_j, friction_work_j;   // of the ground in the step that led here
    float friction_gain_j, lifting_work_j;  // of friction, where it had the wrong sign; of lifting
    int clip;                               // which clip is in charge; -1 with none
    int rule;                               // its active rule; of a network: hidden nodes that fire
    std::uint64_t firing;                   // bit i: input i of its network is 1; of a bank 0
  };
  struct Point {
    float x, y;
  };

  [[nodiscard]] const Skeleton& Bones() const { return skeleton_; }
  [[nodiscard]] int Frames() const { return static_cast<int>(frames_.size()); }
  [[nodiscard]] float StepS() const { return step_s_; }
  [[nodiscard]] const Frame& At(int frame) const { return frames_[static_cast<std::size_t>(frame)]; }
  /// World position relative to the centre of mass [m].
  [[nodiscard]] Point Endpoint(int frame, int endpoint) const {
    return endpoints_[Row(frame, skeleton_.endpoints) + static_cast<std::size_t>(endpoint)];
  }
  /// Contact force in the step that led here [N]: x along the ground, y away from it.
  [[nodiscard]] Point Force(int frame, int endpoint) const {
    return forces_[Row(frame, skeleton_.endpoints) + static_cast<std::size_t>(endpoint)];
  }
  [[nodiscard]] float AngleRad(int frame, int joint) const {
    return angles_[Row(frame, skeleton_.joints) + static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] float RateRadps(int frame, int joint) const {
    return rates_[Row(frame, skeleton_.joints) + static_cast<std::size_t>(joint)];
  }
  /// What the controller in charge feels, normalised; 0 for senses it does not have.
  [[nodiscard]] float Sense(int frame, int sense) const {
    return senses_[Row(frame, senses_per_frame_) + static_cast<std::size_t>(sense)];
  }
  /// Terms measured from the start to this frame.
  [[nodiscard]] const Terms& TermsAt(int frame) const { return terms_[static_cast<std::size_t>(frame)]; }
  [[nodiscard]] std::uint64_t Hash() const { return hash_; }

 private:
  static std::size_t Row(int frame, int width) {
    return static_cast<std::size_t>(frame) * static_cast<std::size_t>(width);
  }

  /// States to go on from, one a second.
  struct Checkpoint;

  /// Simulates on from the last checkpoint.
  void Run(const Environment&, const StartState&, std::span<const Push>, std::span<const Controller>,
           std::span<const Clip>, int steps);
  /// Forgets all from the last checkpoint at or before a step.
  void Rewind(int step);

  Skeleton skeleton_;
  float step_s_;
  int senses_per_frame_ = 0;
  std::vector<Frame> frames_;
  std::vector<Terms> terms_;
  std::vector<Point> endpoints_, forces_;       // (frames x endpoints)
  std::vector<float> angles_, rates_, senses_;  // (frames x joints), (frames x joints), (frames x senses)
  std::uint64_t hash_ = 0;
  std::vector<Checkpoint> checkpoints_;
};

}  // namespace gaitsmith
