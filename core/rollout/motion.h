// SPDX-License-Identifier: MIT
// A recorded motion: what a document's figure does, step by step, for drawing, printing and hashing.
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

/// Everything that determines the bits of a motion: a scene and its controllers.
struct Script {
  const Figure& figure;
  Environment environment;
  StartState start;
  std::span<const Push> pushes;             // sorted by step
  std::span<const Controller> controllers;  // for this figure; clips index into them
  std::span<const Clip> clips;  // sorted by start_step, the first at 0; if empty, the drawn pose is held
  int steps;                    // [0, kMaxSteps]
  float step_s = kStep;
  int model = 1;             // version of the physical model, [1, kModelVersion]
  Demonstration shown = {};  // what is measured, the motion does not depend on it
};

class Motion {
 public:
  /// Simulates a composite motion.
  explicit Motion(const Script&);
  /// Simulates a composite motion, reusing a known motion of the same figure, ground and start. The common
  /// part is copied from the known motion, and only the rest is simulated. The result has the same bits. A
  /// known motion of another model is not reused.
  /// @param parting everything that acts before this step acts in both motions: clips, controllers and pushes
  Motion(Motion known, int parting, const Script&);
  /// With a plant that is not a model of documents. @param recorder a PlantRecorder of this plant
  Motion(std::unique_ptr<MotionRecorder> recorder, const Script&);
  Motion(Motion known, int parting, std::unique_ptr<MotionRecorder> recorder, const Script&);
  Motion(Motion&&) noexcept;
  Motion& operator=(Motion&&) noexcept;
  ~Motion();

  /// The motion at one instant. Frame 0 is the start.
  struct Frame : Snapshot {
    int clip;              // the active clip; -1 if there is none
    int rule;              // the active rule; for a network the number of hidden nodes that fire
    std::uint64_t firing;  // bit i: input i of the network is 1; 0 for a bank
  };
  struct Point {
    float x, y;
  };
  /// What a recorder writes. Each row has `ports.contacts` endpoints, `ports.actuators` joints or `senses`
  /// senses.
  struct Log {
    PortCount ports{0, 0};
    int senses = 0;
    std::vector<Frame> frames;
    std::vector<Terms> terms;                // (frames)
    std::vector<Point> endpoints, forces;    // (frames x contacts)
    std::vector<float> angles, rates, felt;  // (frames x actuators), (frames x actuators), (frames x senses)
    std::vector<float> strains;              // (frames x actuators), or empty
    std::uint64_t hash = 0;

    /// Keeps only the first `frame_count` frames.
    void Truncate(int frame_count);
  };

  /// Measures the terms on_way and in_pose of every frame against another demonstration.
  void MeasureAgainst(const Demonstration&);

  /// Without rods for a figure of springs.
  [[nodiscard]] const Skeleton& Bones() const { return skeleton_; }
  /// Joints and endpoints, or muscles and nodes.
  [[nodiscard]] const Ports& Connections() const { return ports_; }
  [[nodiscard]] int Frames() const { return static_cast<int>(log_.frames.size()); }
  [[nodiscard]] float StepS() const { return step_s_; }
  [[nodiscard]] const Frame& At(int frame) const { return log_.frames[static_cast<std::size_t>(frame)]; }
  /// World position relative to the centre of mass [m].
  [[nodiscard]] Point Endpoint(int frame, int endpoint) const {
    return log_.endpoints[Row(frame, log_.ports.contacts) + static_cast<std::size_t>(endpoint)];
  }
  /// Contact force in the step that ended at this frame [N]: x along the ground, y away from it.
  [[nodiscard]] Point Force(int frame, int endpoint) const {
    return log_.forces[Row(frame, log_.ports.contacts) + static_cast<std::size_t>(endpoint)];
  }
  /// Of a muscle: its length over the drawn one. RateRadps: of that, [1/s].
  [[nodiscard]] float AngleRad(int frame, int joint) const {
    return log_.angles[Row(frame, log_.ports.actuators) + static_cast<std::size_t>(joint)];
  }
  /// Of all joints (frames x joints).
  [[nodiscard]] std::span<const float> AnglesRad() const { return log_.angles; }
  [[nodiscard]] float RateRadps(int frame, int joint) const {
    return log_.rates[Row(frame, log_.ports.actuators) + static_cast<std::size_t>(joint)];
  }
  /// The part of a joint's greatest torque that its muscles gave in the step that ended at this frame, [0,
  /// 1]. 0 where joints are as strong as they need to be.
  [[nodiscard]] float Strain(int frame, int joint) const {
    if (log_.strains.empty()) return 0.0f;
    return log_.strains[Row(frame, log_.ports.actuators) + static_cast<std::size_t>(joint)];
  }
  /// A sense of the active controller, normalised. 0 for senses that it does not have.
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
  Ports ports_;
  float step_s_;
  Log log_;
  std::unique_ptr<MotionRecorder> recorder_;  // holds states to resume from
};

}  // namespace gaitsmith
