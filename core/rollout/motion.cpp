// SPDX-License-Identifier: MIT
#include "core/rollout/motion.h"

#include <algorithm>
#include <utility>

#include "core/rollout/models.h"
#include "core/rollout/motion_recorder.h"

namespace gaitsmith {

namespace {

std::unique_ptr<MotionRecorder> RecorderOf(int model) {
  return WithPlantOf(model, []<template <int> class PlantOf>() -> std::unique_ptr<MotionRecorder> {
    return std::make_unique<PlantRecorder<PlantOf>>();
  });
}

}  // namespace

void Motion::Log::Truncate(int frame_count) {
  const auto count = static_cast<std::size_t>(frame_count);
  frames.resize(count);
  terms.resize(count);
  endpoints.resize(count * static_cast<std::size_t>(ports.contacts));
  forces.resize(endpoints.size());
  angles.resize(count * static_cast<std::size_t>(ports.actuators));
  rates.resize(angles.size());
  if (!strains.empty()) strains.resize(angles.size());
  felt.resize(count * static_cast<std::size_t>(senses));
}

Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;
Motion::~Motion() = default;

Motion::Motion(std::unique_ptr<MotionRecorder> recorder, const Script& script)
    : skeleton_(script.figure),
      ports_(PortsOf(script.figure)),
      step_s_(script.step_s),
      recorder_(std::move(recorder)) {
  recorder_->Record(script, log_);
  MeasureAgainst(script.shown);
}

Motion::Motion(Motion known, int parting, std::unique_ptr<MotionRecorder> recorder, const Script& script)
    : skeleton_(script.figure),
      ports_(PortsOf(script.figure)),
      step_s_(script.step_s),
      recorder_(std::move(recorder)) {
  if (known.recorder_->Model() == recorder_->Model()) {
    recorder_ = std::move(known.recorder_);
    log_ = std::move(known.log_);
    log_.Truncate(recorder_->Rewind(std::min(parting, script.steps)));
  }
  recorder_->Record(script, log_);
  MeasureAgainst(script.shown);
}

void Motion::MeasureAgainst(const Demonstration& shown) {
  DemonstrationMeter meter(shown);
  for (int frame = 0; frame < Frames(); ++frame) {
    const Frame& now = At(frame);
    if (frame > 0) {
      meter.Add(now.x_m, static_cast<double>(now.y_m), now.turn_rad,
                [&](std::size_t joint) { return AngleRad(frame, static_cast<int>(joint)); });
    }
    meter.Put(log_.terms[static_cast<std::size_t>(frame)]);
  }
}

Motion::Motion(const Script& script) : Motion(RecorderOf(script.model), script) {}

Motion::Motion(Motion known, int parting, const Script& script)
    : Motion(std::move(known), parting, RecorderOf(script.model), script) {}

}  // namespace gaitsmith
