// SPDX-License-Identifier: MIT
// Playback of a document's motion: time, speed, and what the drawing needs. The motion comes from core;
// nothing here computes physics.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/world/terrain.h"

namespace gaitsmith::shell {

/// A time range in which one rule of one clip was active.
struct RuleRun {
  int start_frame;
  int end_frame;
  int clip;
  int rule;
};

/// A time range in which the figure touches the ground.
struct Contact {
  int start_frame;
  int end_frame;
};

class Playback {
 public:
  /// Simulates the document. Keeps the present time unless `start_over`.
  void Load(const Document& document, bool start_over);

  /// Shows the motion of the document's plan instead, if it is solved.
  void LoadPlanned(const Document& document);

  /// Measures the shown motion against another demonstration.
  void MeasureAgainst(const Demonstration& shown) { motion_->MeasureAgainst(shown); }

  /// @return true when the picture changed
  bool Advance(double seconds);
  void Play(bool playing) { playing_ = playing; }
  /// Shows a motion that was just found: plays it from its start. If calm, stops at a moment with past poses.
  void Present();
  /// Whether nothing moves unless a person plays it, for those who asked their system for less motion.
  void SetCalm(bool calm) { calm_ = calm; }
  [[nodiscard]] bool Calm() const { return calm_; }
  void Seek(double time_s);
  /// Shows the frame nearest to this time, so that what is displayed and what is edited are the same moment.
  void SeekFrame(double time_s);
  /// Moves by whole frames and pauses playback.
  void Step(int frames);

  [[nodiscard]] bool Loaded() const { return motion_ != nullptr; }
  [[nodiscard]] const Motion& Shown() const { return *motion_; }
  [[nodiscard]] const Figure& ShownFigure() const { return shown_.figure; }
  [[nodiscard]] bool Playing() const { return playing_; }
  [[nodiscard]] double TimeS() const { return time_s_; }
  [[nodiscard]] double DurationS() const;
  [[nodiscard]] int Frame() const;
  [[nodiscard]] const Terms& TermsNow() const { return motion_->TermsAt(Frame()); }

  /// How much of its greatest torque each joint uses around now, [0, 1]: a mean of a twentieth of a second,
  /// since torques jump from step to step. Empty where joints are as strong as they need to be.
  [[nodiscard]] std::vector<float> StrainsNow() const;
  /// From this strain on a joint counts as at its limit.
  static constexpr float kAtLimit = 0.95f;

  double speed = 1.0;

  /// A point of the figure: the position along the ground in double precision, and the height.
  struct Point {
    double x_m;
    float y_m;
  };
  /// Endpoints at this time, interpolated linearly between frames.
  [[nodiscard]] std::vector<Point> EndpointsAt(double time_s) const;
  [[nodiscard]] Point CentreAt(double time_s) const;
  /// The centre of mass, smoothed over a second, for a steady camera.
  [[nodiscard]] double CameraXAt(double time_s) const;
  /// Height of the ground below that place, smoothed over a second in the same way [m]. 0 on level ground.
  [[nodiscard]] float CameraGroundAt(double time_s) const;
  /// The ground on which the motion takes place.
  [[nodiscard]] const Terrain& Ground() const { return ground_; }

  [[nodiscard]] float ReachM() const {
    return reach_m_;
  }  // greatest distance between an endpoint and the centre of mass
  /// Height of the figure at the start [m].
  [[nodiscard]] float StandingM() const { return standing_m_; }
  /// Height of the highest endpoint above CameraGroundAt, smoothed for a steady camera [m].
  struct Height {
    float now_m;
    float around_m;  // the highest within a second
  };
  [[nodiscard]] Height HeightAt(double time_s) const;
  [[nodiscard]] const std::vector<RuleRun>& Runs() const { return runs_; }
  [[nodiscard]] const std::vector<Contact>& Contacts() const { return contacts_; }
  /// Frames whose poses are far enough apart to be drawn side by side: A, B, C...
  [[nodiscard]] const std::vector<int>& PoseFrames() const { return pose_frames_; }

 private:
  void Show(const Document& document, bool start_over);
  void Measure();
  void FindRuns();
  void FindContacts();
  [[nodiscard]] float GapM(int frame, int other) const;
  void ChoosePoses();
  void SmoothCamera();
  void SmoothHeight();

  std::unique_ptr<Motion> motion_;
  Document shown_;  // the document of the motion
  Terrain ground_{std::span<const Corner>()};
  double time_s_ = 0.0;
  bool playing_ = true;
  bool calm_ = false;
  float reach_m_ = 1.0f;
  float standing_m_ = 1.0f;
  std::vector<RuleRun> runs_;
  std::vector<Contact> contacts_;
  std::vector<int> pose_frames_;
  std::vector<double> camera_x_m_;
  std::vector<float> camera_ground_m_;  // empty: level ground
  static constexpr double kHeightEveryS = 0.1;
  std::vector<Height> height_m_;  // every kHeightEveryS
};

}  // namespace gaitsmith::shell
