// SPDX-License-Identifier: MIT
#include "tests/spring_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/springs/lattice.h"
#include "core/world/environment.h"

namespace gaitsmith::test {

namespace {

/// Rounding error of a sum of single-precision numbers, as a share of the summands.
constexpr double kSumRounding = 4.8e-7;  // 2^-21

class SpringTrial {
 public:
  SpringTrial(const Document& document, const Motion& motion)
      : document_(document),
        motion_(motion),
        mass_kg_(static_cast<double>(motion.Bones().mass_kg)),
        reach_m_(static_cast<double>(SizeOf(document.figure))),
        fastest_mps_(reach_m_ * std::sqrt(static_cast<double>(FastestVibration(document.figure)))),
        half_(0.5 / Lattice(document.figure).substeps),
        step_s_(static_cast<double>(motion.StepS())) {
    offences_.model = document.model;
  }

  Offences Judge() {
    JudgeFrame(0);
    for (frame_ = 1; frame_ < motion_.Frames(); ++frame_) {
      JudgeNumbers(frame_);  // also of what is void
      if (motion_.TermsAt(frame_).broke_physics) continue;
      JudgeFrame(frame_);
      JudgeMomentum();
      offences_.judged = frame_;
    }
    return offences_;
  }

 private:
  void Offend(Law law, double by) {
    Offence& worst = offences_.of[static_cast<std::size_t>(law)];
    if (std::isnan(by)) by = std::numeric_limits<double>::infinity();
    if (by > worst.by) worst = {by, frame_};
  }

  void JudgeNumbers(int frame) {
    const Motion::Frame& f = motion_.At(frame);
    double infinite = 0.0;
    const auto count = [&](double number) { infinite += std::isfinite(number) ? 0.0 : 1.0; };
    for (const double number : {f.x_m, f.turn_rad}) count(number);
    for (const float number : {f.y_m, f.velocity_x_mps, f.velocity_y_mps, f.angular_momentum})
      count(static_cast<double>(number));
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const Motion::Point place = motion_.Endpoint(frame, k), force = motion_.Force(frame, k);
      for (const float number : {place.x, place.y, force.x, force.y}) count(static_cast<double>(number));
    }
    for (int j = 0; j < motion_.Connections().Actuators(); ++j) {
      count(static_cast<double>(motion_.AngleRad(frame, j)));
      count(static_cast<double>(motion_.RateRadps(frame, j)));
    }
    Offend(Law::kFinite, infinite);
  }

  void JudgeFrame(int frame) {
    JudgeNumbers(frame);
    const auto height = static_cast<double>(motion_.At(frame).y_m);
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const Motion::Point place = motion_.Endpoint(frame, k), force = motion_.Force(frame, k);
      const auto normal = static_cast<double>(force.y), tangent = std::abs(static_cast<double>(force.x));
      if (document_.environment.ground.empty()) {
        const double rounding = kSumRounding * (std::abs(height) + std::abs(static_cast<double>(place.y)));
        Offend(Law::kAboveGround, (-(height + static_cast<double>(place.y)) - rounding) / reach_m_);
      }
      // What is pushed by a wall is pushed sideways.
      if (!document_.environment.ground.empty()) continue;
      // What friction takes of a fast node's speed is the difference of two rounded numbers, in each substep:
      // its error is a share of the fastest that the node may have been.
      const double most = static_cast<double>(document_.environment.friction) * normal;
      const double impulse =
          static_cast<double>(document_.figure.nodes[static_cast<std::size_t>(k)].mass_kg) *
          (SpeedOf(frame, k) + fastest_mps_) / step_s_;
      const double least = static_cast<double>(std::numeric_limits<float>::min()) / step_s_;
      Offend(Law::kCone, (tangent - most) / std::max(tangent + impulse, least));
    }
  }

  void JudgeMomentum() {
    const int last = frame_ - 1;
    // A blow of this step shows in the velocities of the next. While the ground bears, its impulses and the
    // velocities are of different halves of a substep, so only what touches nothing is judged.
    double took_part = 0.0;
    bool touched = false;
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const Motion::Point now = motion_.Force(frame_, k), before = motion_.Force(last, k);
      touched = touched || now.y != 0.0f || before.y != 0.0f || now.x != 0.0f || before.x != 0.0f;
    }
    if (touched) return;
    // A frame's velocity has half of a substep's fall more than the substeps gave, of the tilt of its own
    // step.
    const auto gravity = static_cast<double>(document_.environment.gravity_mps2);
    double given_x = 0.0, given_y = 0.0;
    for (const auto& [step, share] : {std::pair(last, 1.0 + half_), {std::max(0, last - 1), -half_}}) {
      const auto slope =
          static_cast<double>(GroundAngle(document_.environment, static_cast<float>(step) * motion_.StepS()));
      given_x -= share * std::sin(slope) * gravity * mass_kg_ * step_s_;
      given_y -= share * std::cos(slope) * gravity * mass_kg_ * step_s_;
    }
    took_part = std::abs(given_x) + std::abs(given_y);
    for (const Push& push : document_.pushes) {
      if (push.step != last) continue;
      given_x += static_cast<double>(push.impulse_x_ns);
      given_y += static_cast<double>(push.impulse_y_ns);
      took_part +=
          std::abs(static_cast<double>(push.impulse_x_ns)) + std::abs(static_cast<double>(push.impulse_y_ns));
    }
    const Motion::Frame &now = motion_.At(frame_), &before = motion_.At(last);
    const double change_x =
        mass_kg_ * (static_cast<double>(now.velocity_x_mps) - static_cast<double>(before.velocity_x_mps));
    const double change_y =
        mass_kg_ * (static_cast<double>(now.velocity_y_mps) - static_cast<double>(before.velocity_y_mps));
    took_part += mass_kg_ * (std::abs(static_cast<double>(now.velocity_x_mps)) +
                             std::abs(static_cast<double>(now.velocity_y_mps)) + InnerSpeed());
    took_part += SpringImpulse(frame_) + SpringImpulse(last);
    if (took_part > 0.0)
      Offend(Law::kMomentum, std::hypot(change_x - given_x, change_y - given_y) / took_part);
  }

  /// Along the ground, in the last step [m/s].
  [[nodiscard]] double SpeedOf(int frame, int node) const {
    if (frame == 0) return 0.0;
    const double now = motion_.At(frame).x_m + static_cast<double>(motion_.Endpoint(frame, node).x);
    const double before =
        motion_.At(frame - 1).x_m + static_cast<double>(motion_.Endpoint(frame - 1, node).x);
    return std::abs(now - before) / step_s_;
  }

  /// What the springs pull and push in a step like this frame, at most: rounding makes the impulses on a
  /// heavy and on a light node differ [N s].
  [[nodiscard]] double SpringImpulse(int frame) const {
    double sum = 0.0;
    for (const Spring& spring : document_.figure.springs) {
      const Motion::Point from = motion_.Endpoint(frame, spring.from),
                          to = motion_.Endpoint(frame, spring.to);
      const auto length = static_cast<double>(std::hypot(to.x - from.x, to.y - from.y));
      const auto drawn = static_cast<double>(DrawnLength(document_.figure, spring));
      const double beyond = std::max(std::abs(length - drawn * static_cast<double>(spring.min_rest)),
                                     std::abs(length - drawn * static_cast<double>(spring.max_rest)));
      sum += static_cast<double>(spring.stiffness_npm) * beyond * step_s_;
    }
    return sum;
  }

  /// The fastest node from the centre of mass [m/s]: the sum of all momenta is rounded as coarsely.
  [[nodiscard]] double InnerSpeed() const {
    double fastest = 0.0;
    for (int k = 0; k < motion_.Connections().contacts; ++k) {
      const Motion::Point now = motion_.Endpoint(frame_, k), before = motion_.Endpoint(frame_ - 1, k);
      fastest = std::max(
          fastest,
          std::hypot(static_cast<double>(now.x - before.x), static_cast<double>(now.y - before.y)) / step_s_);
    }
    return fastest;
  }

  const Document& document_;
  const Motion& motion_;
  double mass_kg_, reach_m_;
  double fastest_mps_;  // of a node that swings through all of the figure
  double half_;         // of a substep, in steps
  double step_s_;
  int frame_ = 0;
  Offences offences_;
};

}  // namespace

Offences JudgeSprings(const Document& document, const Motion& motion) {
  return SpringTrial(document, motion).Judge();
}

}  // namespace gaitsmith::test
