// SPDX-License-Identifier: MIT
#include "core/spacetime/planned_motion.h"

#include <algorithm>
#include <cmath>

#include "core/spacetime/plan_layout.h"

namespace gaitsmith {

int UnknownsOf(const PlanScene& scene, const PlanGrid& grid) { return PlanLayout(scene, grid).unknowns; }

struct PlannedMotion::Content {
  PlanScene scene;
  PlanGrid grid;
  PlanLayout layout;
  Eigen::VectorXd unknowns;
};

PlannedMotion::PlannedMotion(const PlanScene& scene, const PlanGrid& grid, std::span<const double> unknowns)
    : content_(std::make_unique<Content>(Content{
          scene, grid, PlanLayout(scene, grid),
          Eigen::Map<const Eigen::VectorXd>(unknowns.data(), static_cast<Eigen::Index>(unknowns.size()))})) {}
PlannedMotion::PlannedMotion(PlannedMotion&&) noexcept = default;
PlannedMotion& PlannedMotion::operator=(PlannedMotion&&) noexcept = default;
PlannedMotion::~PlannedMotion() = default;

const PlanScene& PlannedMotion::Scene() const { return content_->scene; }
const PlanGrid& PlannedMotion::Grid() const { return content_->grid; }
std::span<const double> PlannedMotion::Unknowns() const {
  return {content_->unknowns.data(), static_cast<std::size_t>(content_->unknowns.size())};
}

double PlannedMotion::DurationS() const { return content_->layout.breaks.back() * content_->layout.time_s; }

std::vector<double> PlannedMotion::BreaksS() const {
  std::vector<double> breaks = content_->layout.breaks;
  for (double& at : breaks) at *= content_->layout.time_s;
  return breaks;
}

std::vector<PlannedMotion::Blow> PlannedMotion::Blows() const {
  const PlanLayout& layout = content_->layout;
  const double unit = layout.mass_kg * layout.length_m / layout.time_s;
  std::vector<Blow> blows;
  for (const PlanLayout::Phase& phase : layout.phases) {
    for (std::size_t c = 0; c < phase.impulses.size(); ++c) {
      const double one = content_->unknowns[phase.impulses[c]],
                   other = content_->unknowns[phase.impulses[c] + 1];
      blows.push_back({layout.TimeOf(phase.first_step) * layout.time_s,
                       phase.contacts[c],
                       {unit * layout.friction * (one - other), unit * (one + other)}});
    }
  }
  return blows;
}

PlannedMotion::Instant PlannedMotion::At(double time_s) const {
  const PlanLayout& layout = content_->layout;
  const Eigen::VectorXd& x = content_->unknowns;
  const int n = layout.model.rods;
  const double time = std::clamp(time_s / layout.time_s, 0.0, layout.breaks.back());
  const PlanInstant at = layout.At(layout.PieceAt(time), time);
  const auto& contacts = layout.phases[static_cast<std::size_t>(at.phase)].contacts;
  const double force = layout.mass_kg * layout.length_m / (layout.time_s * layout.time_s);

  Instant instant;
  instant.centre = {layout.ValueOf(x, 0, at.position[0]) * layout.length_m,
                    layout.ValueOf(x, 1, at.position[0]) * layout.length_m};
  instant.forces.resize(static_cast<std::size_t>(n) + 1, Vector{0.0, 0.0});
  const RodMoments::Numbers numbers = layout.NumbersAt(x, at);
  double left_x = layout.ValueOf(x, 0, at.position[2]) - layout.gravity_x;
  double left_y = layout.ValueOf(x, 1, at.position[2]) - layout.gravity_y;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double along = numbers[3 * n + 2 * static_cast<int>(c)],
                 up = numbers[3 * n + 2 * static_cast<int>(c) + 1];
    instant.forces[static_cast<std::size_t>(contacts[c])] = {along * force, up * force};
    left_x -= along;
    left_y -= up;
  }
  instant.force_residual = std::max(std::abs(left_x), std::abs(left_y));
  for (int k = 0; k <= n; ++k) {
    const PlanLayout::Point point = layout.EndpointAt(x, at, k);
    instant.endpoints.push_back({point.x * layout.length_m, point.y * layout.length_m});
  }
  RodMoments moments(layout.model, contacts);
  moments.Set(numbers);
  const RodModel::Vector torque = layout.model.beyond * moments.Values();
  instant.moment_residual = torque[0];
  for (int j = 0; j < n; ++j) {
    instant.direction_rad.push_back(numbers[j]);
    if (j == 0) continue;
    const Skeleton::Limb& limb = content_->scene.skeleton.limbs[static_cast<std::size_t>(j)];
    instant.angle_rad.push_back(numbers[j] - numbers[limb.parent] - static_cast<double>(limb.rest_rad));
    instant.torque_nm.push_back(torque[j] * force * layout.length_m);
  }
  return instant;
}

}  // namespace gaitsmith
