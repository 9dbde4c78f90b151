// SPDX-License-Identifier: MIT
// A recorded motion: what a document's figure does, step by step, to be drawn, printed or hashed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/physics/skeleton.h"
#include "core/physics/snapshot.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

class MotionRecorder;

/// All that fixes the bits of a motion: a scene and who acts in it.
struct Script {
  const Figure& figure;
  Environment environment;
  StartState start;
  std::span<const Push> pushes;             // sorted by step
  std::span<const Controller> controllers;  // for this figure; clips index into them
  std::span<const Clip> clips;  // sorted by start_step, the first at 0; with none the drawn pose is held
  int steps;                    // [0, kMaxSteps]
  float step_s = kStep;
  int model = 1;  // version of the physical model, [1, kModelVersion]
};

class Motion {
 public:
  /// Simulates a composite motion.
  explicit Motion(const Script&);
  /// The same, where another motion of the same figure, ground and start is known: what they have in common
  /// is taken from it, and only the rest is simulated. Not a bit differs. Nothing is taken from a motion of
  /// another model.
  /// @param parting all that acts before this step acts in both motions: clips, controllers and pushes
  Motion(Motion known, int parting, const Script&);
  /// With a plant that no document can name. @param recorder a PlantRecorder of it
  Motion(std::unique_ptr<MotionRecorder> recorder, const Script&);
  Motion(Motion known, int parting, std::unique_ptr<MotionRecorder> recorder, const Script&);
  /// Of the first model.
  Motion(const Figure& figure, const Environment& environment, const StartState& start,
         std::span<const Push> pushes, std::span<const Controller> controllers, std::span<const Clip> clips,
         int steps, float step_s = kStep);
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;
  ~Motion();

  /// Everything about one instant; frame 0 is the start.
  struct Frame : Snapshot {
    int clip;              // which clip is in charge; -1 with none
    int rule;              // its active rule; of a network: hidden nodes that fire
    std::uint64_t firing;  // bit i: input i of its network is 1; of a bank 0
  };
  struct Point {
    float x, y;
  };
  /// What a recorder writes. Rows of `ports.contacts` endpoints, `ports.actuators` joints, `senses` senses.
  struct Log {
    PortCount ports{0, 0};
    int senses = 0;
    std::vector<Frame> frames;
    std::vector<Terms> terms;                // (frames)
    std::vector<Point> endpoints, forces;    // (frames x contacts)
    std::vector<float> angles, rates, felt;  // (frames x actuators), (frames x actuators), (frames x senses)
    std::uint64_t hash = 0;

    /// Forgets all but the first frames.
    void Truncate(int frame_count);
  };

  [[nodiscard]] const Skeleton& Bones() const { return skeleton_; }
  [[nodiscard]] int Frames() const { return static_cast<int>(log_.frames.size()); }
  [[nodiscard]] float StepS() const { return step_s_; }
  [[nodiscard]] const Frame& At(int frame) const { return log_.frames[static_cast<std::size_t>(frame)]; }
  /// World position relative to the centre of mass [m].
  [[nodiscard]] Point Endpoint(int frame, int endpoint) const {
    return log_.endpoints[Row(frame, log_.ports.contacts) + static_cast<std::size_t>(endpoint)];
  }
  /// Contact force in the step that led here [N]: x along the ground, y away from it.
  [[nodiscard]] Point Force(int frame, int endpoint) const {
    return log_.forces[Row(frame, log_.ports.contacts) + static_cast<std::size_t>(endpoint)];
  }
  [[nodiscard]] float AngleRad(int frame, int joint) const {
    return log_.angles[Row(frame, log_.ports.actuators) + static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] float RateRadps(int frame, int joint) const {
    return log_.rates[Row(frame, log_.ports.actuators) + static_cast<std::size_t>(joint)];
  }
  /// What the controller in charge feels, normalised; 0 for senses it does not have.
  [[nodiscard]] float Sense(int frame, int sense) const {
    return log_.felt[Row(frame, log_.senses) + static_cast<std::size_t>(sense)];
  }
  /// Terms measured from the start to this frame.
  [[nodiscard]] const Terms& TermsAt(int frame) const { return log_.terms[static_cast<std::size_t>(frame)]; }
  [[nodiscard]] std::uint64_t Hash() const { return log_.hash; }

 private:
  static std::size_t Row(int frame, int width) {
    return static_cast<std::size_t>(frame) * static_cast<std::size_t>(width);
  }

  Skeleton skeleton_;
  float step_s_;
  Log log_;
  std::unique_ptr<MotionRecorder> recorder_;  // knows states to go on from
};

}  // namespace gaitsmith
