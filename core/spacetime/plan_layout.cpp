// SPDX-License-Identifier: MIT
#include "core/spacetime/plan_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numeric/scalar_math.h"
#include "core/signal/time.h"

namespace gaitsmith {

namespace {

std::vector<PlanLayout::Phase> PhasesOf(const PlanScene& scene) {
  std::vector<int> bounds{0, scene.plan.steps};
  for (const Stance& stance : scene.plan.stances) {
    bounds.push_back(stance.first_step);
    bounds.push_back(stance.last_step);
  }
  std::ranges::sort(bounds);
  const auto [end, last] = std::ranges::unique(bounds);
  bounds.erase(end, last);
  std::vector<PlanLayout::Phase> phases;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    PlanLayout::Phase& phase = phases.emplace_back(bounds[i], bounds[i + 1]);
    for (std::size_t s = 0; s < scene.plan.stances.size(); ++s) {
      const Stance& stance = scene.plan.stances[s];
      if (stance.first_step > phase.first_step || stance.last_step < phase.last_step) continue;
      phase.stances.push_back(static_cast<int>(s));
      phase.contacts.push_back(stance.endpoint);
      phase.lands |= phase.first_step > 0 && stance.first_step == phase.first_step;
    }
  }
  return phases;
}

std::vector<double> Divide(std::vector<PlanLayout::Phase>& phases, const PlanGrid& grid, double step,
                           double step_s) {
  std::vector<double> breaks{0.0};
  for (PlanLayout::Phase& phase : phases) {
    const int steps = phase.last_step - phase.first_step;
    phase.first_piece = static_cast<int>(breaks.size()) - 1;
    phase.pieces = std::max(2, static_cast<int>(std::ceil(steps * step_s * grid.pieces_per_second)));
    for (int i = 1; i <= phase.pieces; ++i)
      breaks.push_back((phase.first_step + static_cast<double>(steps) * i / phase.pieces) * step);
  }
  return breaks;
}

/// @param inner     which derivative may jump between pieces
/// @param lift, land the same where endpoints leave the ground, and where one lands
SplineSpace SpaceOf(int degree, const std::vector<PlanLayout::Phase>& phases,
                    const std::vector<double>& breaks, int lift, int land) {
  std::vector<int> order(breaks.size() - 1, degree);
  for (std::size_t i = 1; i < phases.size(); ++i)
    order[static_cast<std::size_t>(phases[i].first_piece) - 1] = phases[i].lands ? land : lift;
  return {degree, breaks, order};
}

}  // namespace

PlanLayout::PlanLayout(const PlanScene& scene, const PlanGrid& grid)
    : model(scene.skeleton),
      ground(scene.environment.ground, static_cast<double>(scene.skeleton.longest_rod_m)),
      length_m(static_cast<double>(scene.skeleton.longest_rod_m)),
      mass_kg(static_cast<double>(scene.skeleton.mass_kg)),
      time_s(std::sqrt(length_m / static_cast<double>(kStandardGravity))),
      friction(static_cast<double>(scene.environment.friction)),
      start_x(0.0),
      start_y(0.0),
      start_rate_x(static_cast<double>(scene.start.velocity_x_mps) * time_s / length_m),
      start_rate_y(static_cast<double>(scene.start.velocity_y_mps) * time_s / length_m),
      start_spin(static_cast<double>(scene.start.spin_radps) * time_s),
      phases(PhasesOf(scene)),
      breaks(Divide(phases, grid, static_cast<double>(kStep) / time_s, static_cast<double>(kStep))),
      positions(SpaceOf(grid.degree, phases, breaks, 2, 1)),
      forces(SpaceOf(grid.degree - 2, phases, breaks, 0, 0)),
      step_(static_cast<double>(kStep) / time_s) {
  const double gravity =
      static_cast<double>(scene.environment.gravity_mps2) / static_cast<double>(kStandardGravity);
  const auto [sine, cosine] = FineSinCos(static_cast<double>(scene.environment.slope_rad));
  gravity_x = -gravity * sine;
  gravity_y = -gravity * cosine;

  start_direction.push_back(static_cast<double>(scene.skeleton.start_angle_rad));
  for (int j = 1; j < model.rods; ++j) {
    const Skeleton::Limb& limb = scene.skeleton.limbs[static_cast<std::size_t>(j)];
    start_direction.push_back(start_direction[static_cast<std::size_t>(limb.parent)] +
                              static_cast<double>(limb.rest_rad));
  }
  std::vector<Point> arms(static_cast<std::size_t>(model.rods) + 1, Point{0.0, 0.0});
  double lowest = 0.0;
  for (int k = 0; k <= model.rods; ++k) {
    Point& arm = arms[static_cast<std::size_t>(k)];
    for (int j = 0; j < model.rods; ++j) {
      const auto turned = FineSinCos(start_direction[static_cast<std::size_t>(j)]);
      arm.x += model.arm(k, j) * turned.cosine;
      arm.y += model.arm(k, j) * turned.sine;
    }
    lowest = std::min(lowest, arm.y);
  }
  start_y = static_cast<double>(scene.start.drop_height_m) / length_m - lowest;

  unknowns = Curves() * positions.Size();
  for (Phase& phase : phases) {
    const int coefficients = phase.pieces + forces.Degree();
    for (std::size_t s = 0; s < phase.stances.size(); ++s) {
      phase.forces.push_back(unknowns);
      unknowns += 2 * coefficients;
    }
    for (std::size_t s = 0; phase.lands && s < phase.stances.size(); ++s) {
      phase.impulses.push_back(unknowns);
      unknowns += 2;
    }
  }
  for (const Stance& stance : scene.plan.stances) {
    stance_place.push_back(stance.first_step == 0 ? -1 : unknowns++);
    // A drawn foot may be a hair above the ground: it stands where it is.
    const Point& arm = arms[static_cast<std::size_t>(stance.endpoint)];
    stance_start.push_back({arm.x, stance.first_step == 0 ? start_y + arm.y : 0.0});
  }
}

int PlanLayout::PieceAt(double time) const {
  const auto after = std::ranges::upper_bound(breaks, time + 1e-12);
  return std::clamp(static_cast<int>(after - breaks.begin()) - 1, 0, static_cast<int>(breaks.size()) - 2);
}

PlanInstant PlanLayout::At(int piece, double time) const {
  PlanInstant at;
  while (static_cast<std::size_t>(at.phase) + 1 < phases.size() &&
         phases[static_cast<std::size_t>(at.phase) + 1].first_piece <= piece)
    ++at.phase;
  at.time = time;
  for (int order = 0; order < 3; ++order)
    at.position[static_cast<std::size_t>(order)] = positions.At(piece, time, order);
  at.force = forces.At(piece, time, 0);
  return at;
}

PlanInstant PlanLayout::Landing(int phase) const {
  const Phase& after = phases[static_cast<std::size_t>(phase)];
  PlanInstant at;
  at.phase = phase;
  at.time = TimeOf(after.first_step);
  at.position[2] = positions.JumpAt(after.first_piece, at.time, 1);
  // The value, over the same coefficients.
  const SplineShares value = positions.At(after.first_piece, at.time, 0);
  at.position[0] = {at.position[2].first, at.position[2].count};
  const auto shift = static_cast<std::size_t>(value.first - at.position[0].first);
  for (std::size_t i = 0; i < static_cast<std::size_t>(value.count); ++i)
    at.position[0].share[shift + i] = value.share[i];
  at.position[1] = {at.position[2].first, at.position[2].count};
  at.force.count = 1;
  at.force.share[0] = 1.0;
  at.impulsive = true;
  return at;
}

int PlanLayout::ForceUnknown(const PlanInstant& at, std::size_t contact) const {
  const Phase& phase = phases[static_cast<std::size_t>(at.phase)];
  if (at.impulsive) return phase.impulses[contact];
  return phase.forces[contact] + 2 * (at.force.first - forces.FirstOf(phase.first_piece));
}

double PlanLayout::ValueOf(const Eigen::VectorXd& x, int curve, const SplineShares& shares) const {
  double sum = 0.0;
  for (int i = 0; i < shares.count; ++i)
    sum += shares.share[static_cast<std::size_t>(i)] * x[Curve(curve) + shares.first + i];
  return sum;
}

RodMoments::Numbers PlanLayout::NumbersAt(const Eigen::VectorXd& x, const PlanInstant& at) const {
  const int n = model.rods;
  const std::size_t contacts = phases[static_cast<std::size_t>(at.phase)].contacts.size();
  RodMoments::Numbers numbers(3 * n + 2 * static_cast<int>(contacts));
  for (int order = 0; order < 3; ++order)
    for (int j = 0; j < n; ++j)
      numbers[order * n + j] = ValueOf(x, 2 + j, at.position[static_cast<std::size_t>(order)]);
  for (std::size_t c = 0; c < contacts; ++c) {
    const int unknown = ForceUnknown(at, c);
    double one = 0.0, other = 0.0;
    for (int i = 0; i < at.force.count; ++i) {
      one += at.force.share[static_cast<std::size_t>(i)] * x[unknown + 2 * i];
      other += at.force.share[static_cast<std::size_t>(i)] * x[unknown + 2 * i + 1];
    }
    numbers[3 * n + 2 * static_cast<int>(c)] = friction * (one - other);
    numbers[3 * n + 2 * static_cast<int>(c) + 1] = one + other;
  }
  return numbers;
}

PlanLayout::Point PlanLayout::EndpointAt(const Eigen::VectorXd& x, const PlanInstant& at,
                                         int endpoint) const {
  Point point{ValueOf(x, 0, at.position[0]), ValueOf(x, 1, at.position[0])};
  for (int j = 0; endpoint >= 0 && j < model.rods; ++j) {
    const auto [sine, cosine] = FineSinCos(ValueOf(x, 2 + j, at.position[0]));
    point.x += model.arm(endpoint, j) * cosine;
    point.y += model.arm(endpoint, j) * sine;
  }
  return point;
}

}  // namespace gaitsmith
