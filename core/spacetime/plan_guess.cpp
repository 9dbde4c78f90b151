// SPDX-License-Identifier: MIT
#include "core/spacetime/plan_guess.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

/// Values at some instants, eased from one to the next.
class Eased {
 public:
  explicit Eased(double first) : knots_{{0.0, first}} {}
  /// In any order.
  void Add(double time, double value) {
    const auto after = std::ranges::find_if(knots_, [time](const Knot& knot) { return knot.time > time; });
    knots_.insert(after, {time, value});
  }
  [[nodiscard]] double At(double time) const {
    const auto after = std::ranges::find_if(knots_, [time](const Knot& knot) { return knot.time > time; });
    if (after == knots_.end()) return knots_.back().value;
    if (after == knots_.begin()) return knots_.front().value;
    const Knot &from = *(after - 1), &to = *after;
    const double s = (time - from.time) / (to.time - from.time);
    return from.value + (to.value - from.value) * s * s * (3.0 - 2.0 * s);
  }

 private:
  struct Knot {
    double time, value;
  };
  std::vector<Knot> knots_;
};

class Guess {
 public:
  Guess(const PlanScene& scene, const PlanLayout& layout)
      : scene_(scene), layout_(layout), turn_(layout.start_direction[0]), along_(layout.start_x) {
    for (int j = 1; j < layout.model.rods; ++j)
      bend_.emplace_back(static_cast<double>(scene.skeleton.limbs[static_cast<std::size_t>(j)].rest_rad));
    for (const Keyframe& keyframe : scene.plan.keyframes) {
      const double time = layout.TimeOf(keyframe.step);
      if (keyframe.turned)
        turn_.Add(time, layout.start_direction[0] + static_cast<double>(keyframe.turn_rad));
      for (std::size_t j = 0; j < keyframe.pose_rad.size(); ++j)
        bend_[j].Add(time, static_cast<double>(scene.skeleton.limbs[j + 1].rest_rad) +
                               static_cast<double>(keyframe.pose_rad[j]));
    }
    LayRoot();
    for (const Keyframe& keyframe : scene.plan.keyframes) {
      const double time = layout.TimeOf(keyframe.step);
      const auto mark =
          std::ranges::find_if(keyframe.marks, [](const Mark& one) { return one.axes != MarkAxes::kUp; });
      if (mark != keyframe.marks.end())
        along_.Add(time, static_cast<double>(mark->x_m) / layout.length_m - ArmAt(time, mark->endpoint).x);
    }
    for (std::size_t s = 0; s < scene.plan.stances.size(); ++s) {
      const Stance& stance = scene.plan.stances[s];
      const double time = layout.TimeOf(stance.first_step);
      double x = layout.stance_place[s] < 0 ? layout.stance_start[s].x
                                            : along_.At(time) + ArmAt(time, stance.endpoint).x;
      for (const Keyframe& keyframe : scene.plan.keyframes)
        for (const Mark& mark : keyframe.marks)
          if (mark.endpoint == stance.endpoint && mark.axes != MarkAxes::kUp &&
              keyframe.step >= stance.first_step && keyframe.step <= stance.last_step)
            x = static_cast<double>(mark.x_m) / layout.length_m;
      stance_x_.push_back(x);
    }
  }

  Eigen::VectorXd Make() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(layout_.unknowns);
    for (int i = 0; i < layout_.positions.Size(); ++i) {
      const double time = layout_.positions.Centre(i);
      const PlanLayout::Point centre = CentreAt(time);
      x[layout_.Curve(0) + i] = centre.x;
      x[layout_.Curve(1) + i] = centre.y;
      const std::vector<double> directions = DirectionsAt(time);
      for (int j = 0; j < layout_.model.rods; ++j)
        x[layout_.Curve(2 + j) + i] = directions[static_cast<std::size_t>(j)];
    }
    double standing = 0.0;
    for (const PlanLayout::Phase& phase : layout_.phases)
      if (!phase.contacts.empty()) standing += LastOf(phase) - FirstOf(phase);
    const double load = standing > 0.0 ? -layout_.gravity_y * layout_.breaks.back() / standing : 0.0;
    for (const PlanLayout::Phase& phase : layout_.phases) {
      const double each = 0.5 * load / std::max<double>(1.0, static_cast<double>(phase.contacts.size()));
      for (const int first : phase.forces)
        x.segment(first, 2 * (phase.pieces + layout_.forces.Degree())).setConstant(each);
      for (const int first : phase.impulses) x.segment(first, 2).setConstant(0.1);
    }
    for (std::size_t s = 0; s < stance_x_.size(); ++s)
      if (layout_.stance_place[s] >= 0) x[layout_.stance_place[s]] = stance_x_[s];
    return x;
  }

 private:
  /// While both ends of the root stand, it lies as it does at the start, or as a keyframe says, or as it is
  /// nearest to.
  void LayRoot() {
    const Eased asked = turn_;
    for (const PlanLayout::Phase& phase : layout_.phases) {
      const auto stands = [&phase](int endpoint) {
        return std::ranges::find(phase.contacts, endpoint) != phase.contacts.end();
      };
      if (!stands(0) || !stands(1)) continue;
      double direction = phase.first_step == 0 ? layout_.start_direction[0]
                                               : asked.At(0.5 * (FirstOf(phase) + LastOf(phase)));
      for (const Keyframe& keyframe : scene_.plan.keyframes) {
        if (keyframe.turned && keyframe.step >= phase.first_step && keyframe.step <= phase.last_step)
          direction = layout_.start_direction[0] + static_cast<double>(keyframe.turn_rad);
      }
      direction = kPi * std::round(direction / kPi);
      turn_.Add(FirstOf(phase), direction);
      turn_.Add(LastOf(phase), direction);
    }
  }

  [[nodiscard]] double FirstOf(const PlanLayout::Phase& phase) const {
    return layout_.TimeOf(phase.first_step);
  }
  [[nodiscard]] double LastOf(const PlanLayout::Phase& phase) const {
    return layout_.TimeOf(phase.last_step);
  }

  [[nodiscard]] std::vector<double> DirectionsAt(double time) const {
    std::vector<double> directions{turn_.At(time)};
    for (std::size_t j = 0; j < bend_.size(); ++j)
      directions.push_back(directions[static_cast<std::size_t>(layout_.model.parent[j + 1])] +
                           bend_[j].At(time));
    return directions;
  }

  /// An endpoint from the centre of mass.
  [[nodiscard]] PlanLayout::Point ArmAt(double time, int endpoint) const {
    PlanLayout::Point arm{0.0, 0.0};
    if (endpoint == kCentreOfMass) return arm;
    const std::vector<double> directions = DirectionsAt(time);
    for (int j = 0; j < layout_.model.rods; ++j) {
      const auto [sine, cosine] = FineSinCos(directions[static_cast<std::size_t>(j)]);
      arm.x += layout_.model.arm(endpoint, j) * cosine;
      arm.y += layout_.model.arm(endpoint, j) * sine;
    }
    return arm;
  }

  /// The centre of mass over the feet that stand in a phase.
  [[nodiscard]] PlanLayout::Point Over(const PlanLayout::Phase& phase, double time) const {
    PlanLayout::Point sum{0.0, 0.0};
    for (std::size_t c = 0; c < phase.contacts.size(); ++c) {
      const PlanLayout::Point arm = ArmAt(time, phase.contacts[c]);
      sum.x += stance_x_[static_cast<std::size_t>(phase.stances[c])] - arm.x;
      sum.y -= arm.y;
    }
    const auto count = static_cast<double>(phase.contacts.size());
    return {sum.x / count, sum.y / count};
  }

  [[nodiscard]] PlanLayout::Point CentreAt(double time) const {
    const auto& phases = layout_.phases;
    const auto now = std::ranges::find_if(
        phases, [&](const PlanLayout::Phase& phase) { return time <= LastOf(phase) + 1e-9; });
    const std::size_t at =
        now == phases.end() ? phases.size() - 1 : static_cast<std::size_t>(now - phases.begin());
    const PlanLayout::Phase& phase = phases[at];
    if (!phase.contacts.empty()) return Over(phase, time);
    const double from = FirstOf(phase), to = LastOf(phase), s = (time - from) / (to - from);
    const double fall = -layout_.gravity_y;
    const PlanLayout::Point begin =
        at > 0 ? Over(phases[at - 1], from) : PlanLayout::Point{layout_.start_x, layout_.start_y};
    if (at + 1 == phases.size()) {  // to the end of the motion
      const double rise = at > 0 ? 0.5 * fall * (to - from) : layout_.start_rate_y;
      const double speed = at > 0 ? 0.0 : layout_.start_rate_x;
      const double since = time - from;
      return {begin.x + speed * since, begin.y + rise * since - 0.5 * fall * since * since};
    }
    const PlanLayout::Point end = Over(phases[at + 1], to);
    return {begin.x + (end.x - begin.x) * s,
            begin.y + (end.y - begin.y) * s + 0.5 * fall * (time - from) * (to - time)};
  }

  const PlanScene& scene_;
  const PlanLayout& layout_;
  Eased turn_;
  std::vector<Eased> bend_;
  Eased along_;
  std::vector<double> stance_x_;
};

}  // namespace

Eigen::VectorXd GuessPlan(const PlanScene& scene, const PlanLayout& layout) {
  return Guess(scene, layout).Make();
}

Eigen::VectorXd Resample(const Eigen::VectorXd& unknowns, const PlanLayout& from, const PlanLayout& to) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(to.unknowns);
  // The place of a coefficient's centre in the pieces of a phase of the old layout.
  const auto within = [&](std::size_t phase, double time) {
    const PlanLayout::Phase& old = from.phases[phase];
    return from.At(std::clamp(from.PieceAt(time), old.first_piece, old.first_piece + old.pieces - 1), time);
  };
  for (int curve = 0; curve < to.Curves(); ++curve) {
    for (int i = 0; i < to.positions.Size(); ++i) {
      const double time = to.positions.Centre(i);
      x[to.Curve(curve) + i] = from.ValueOf(unknowns, curve, from.At(from.PieceAt(time), time).position[0]);
    }
  }
  for (std::size_t p = 0; p < to.phases.size(); ++p) {
    const PlanLayout::Phase &old = from.phases[p], &phase = to.phases[p];
    for (std::size_t c = 0; c < phase.forces.size(); ++c) {
      const int first = to.forces.FirstOf(phase.first_piece);
      for (int i = 0; i < phase.pieces + to.forces.Degree(); ++i) {
        const PlanInstant at = within(p, to.forces.Centre(first + i));
        const int unknown = from.ForceUnknown(at, c);
        for (int edge = 0; edge < 2; ++edge) {
          double sum = 0.0;
          for (int k = 0; k < at.force.count; ++k)
            sum += at.force.share[static_cast<std::size_t>(k)] * unknowns[unknown + 2 * k + edge];
          x[phase.forces[c] + 2 * i + edge] = sum;
        }
      }
      for (std::size_t edge = 0; phase.lands && edge < 2; ++edge)
        x[phase.impulses[c] + static_cast<int>(edge)] = unknowns[old.impulses[c] + static_cast<int>(edge)];
    }
  }
  for (std::size_t s = 0; s < to.stance_place.size(); ++s)
    if (to.stance_place[s] >= 0) x[to.stance_place[s]] = unknowns[from.stance_place[s]];
  return x;
}

}  // namespace gaitsmith
