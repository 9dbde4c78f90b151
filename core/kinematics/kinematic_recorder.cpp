// SPDX-License-Identifier: MIT
#include "core/kinematics/kinematic_recorder.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/control/sense_table.h"
#include "core/numeric/scalar_math.h"
#include "core/rollout/models.h"
#include "core/rollout/motion_recorder.h"
#include "core/springs/lattice.h"

namespace gaitsmith {

namespace {

struct Layout {
  std::vector<double> directions;
  std::vector<WorldPoint> endpoints;
};

/// The cross product of the mean of two arms and its velocity.
double Swept(const WorldPoint& was, const WorldPoint& is, double step_s) {
  return (was.x_m * is.y_m - was.y_m * is.x_m) / step_s;
}

/// Of a figure of springs about its centre of mass.
double AngularMomentum(const Lattice& body, const Posture& before, const Posture& now, double step_s) {
  double momentum = 0.0;
  for (std::size_t node = 0; node < body.nodes; ++node)
    momentum += static_cast<double>(body.mass_kg[node]) * Swept(before.nodes[node], now.nodes[node], step_s);
  return momentum;
}

/// Lengths of the muscles over the drawn ones.
std::vector<double> LengthsOf(const Lattice& body, const Posture& posture) {
  std::vector<double> lengths;
  lengths.reserve(body.muscles);
  for (std::size_t j = 0; j < body.muscles; ++j) {
    const Lattice::Link& link = body.link[body.muscle[j].link];
    const WorldPoint &from = posture.nodes[link.from], &to = posture.nodes[link.to];
    lengths.push_back(WorldPoint{to.x_m - from.x_m, to.y_m - from.y_m}.Length() /
                      static_cast<double>(link.drawn_m));
  }
  return lengths;
}

/// Of the figure about its centre of mass, in the middle between two postures.
double AngularMomentum(const Skeleton& bones, const Posture& before, const Layout& from, const Posture& now,
                       const Layout& to, double step_s) {
  double momentum = 0.0;
  for (int rod = 0; rod < bones.rods; ++rod) {
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(rod)];
    const auto start = static_cast<std::size_t>(limb.start), end = static_cast<std::size_t>(rod) + 1;
    const auto arm = [&](const Posture& posture, const Layout& layout) {
      return WorldPoint{0.5 * (layout.endpoints[start].x_m + layout.endpoints[end].x_m) - posture.x_m,
                        0.5 * (layout.endpoints[start].y_m + layout.endpoints[end].y_m) - posture.y_m};
    };
    const WorldPoint was = arm(before, from), is = arm(now, to);
    const auto at = static_cast<std::size_t>(rod);
    const double turned = (to.directions[at] - from.directions[at]) / step_s;
    momentum += static_cast<double>(limb.mass_kg) * Swept(was, is, step_s) +
                static_cast<double>(limb.inertia_kgm2) * turned;
  }
  return momentum;
}

class KinematicRecorder final : public MotionRecorder {
 public:
  explicit KinematicRecorder(std::span<const KinematicFrame> frames) : frames_(frames) {}

  [[nodiscard]] int Model() const override { return 0; }  // of no simulation
  [[nodiscard]] int Rewind(int) override { return 0; }

  void Record(const Script& script, Motion::Log& log) override {
    const Skeleton bones(script.figure);
    const double step_s = static_cast<double>(script.step_s);
    log.ports = CountPorts(script.model, script.figure);
    log.senses = SenseCount(SenseKind::kSight, log.ports);
    std::optional<Lattice> lattice;
    if (script.figure.HasSprings()) lattice.emplace(script.figure);
    const auto positions_of = [&](const Posture& posture) {
      return lattice ? LengthsOf(*lattice, posture) : posture.angle_rad;
    };
    std::vector<Layout> layouts;
    layouts.reserve(frames_.size());
    for (const KinematicFrame& frame : frames_)
      layouts.push_back({DirectionsOf(bones, frame.posture), EndpointsOf(bones, frame.posture)});
    const Posture& first = frames_.front().posture;
    Terms terms;
    terms.start_height_m = static_cast<float>(first.y_m);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      // Nothing is known of what was before the first frame; its rates are those of the second.
      const std::size_t then = std::max<std::size_t>(i, 1);
      const Posture &before = frames_[then - 1].posture, &after = frames_[then].posture;
      const Posture& now = frames_[i].posture;
      Motion::Frame& snapshot = log.frames.emplace_back();
      snapshot.x_m = now.x_m;
      snapshot.y_m = static_cast<float>(now.y_m);
      snapshot.velocity_x_mps = static_cast<float>((after.x_m - before.x_m) / step_s);
      snapshot.velocity_y_mps = static_cast<float>((after.y_m - before.y_m) / step_s);
      snapshot.angular_momentum = static_cast<float>(
          lattice ? AngularMomentum(*lattice, before, after, step_s)
                  : AngularMomentum(bones, before, layouts[then - 1], after, layouts[then], step_s));
      snapshot.turn_rad = now.direction_rad;
      snapshot.clip = frames_[i].clip;
      snapshot.rule = frames_[i].rule;
      terms.travel_m = static_cast<float>(now.x_m - first.x_m);
      terms.max_cm_height_m = std::max(terms.max_cm_height_m, snapshot.y_m);
      terms.rotations = static_cast<float>(std::abs(now.direction_rad - first.direction_rad) / (2.0 * kPi));
      log.terms.push_back(terms);
      for (const WorldPoint& point : layouts[i].endpoints) {
        log.endpoints.push_back(
            {static_cast<float>(point.x_m - now.x_m), static_cast<float>(point.y_m - now.y_m)});
      }
      log.forces.insert(log.forces.end(), frames_[i].forces.begin(), frames_[i].forces.end());
      const std::vector<double> positions = positions_of(now), from = positions_of(before),
                                to = positions_of(after);
      for (std::size_t j = 0; j < positions.size(); ++j) {
        log.angles.push_back(static_cast<float>(positions[j]));
        log.rates.push_back(static_cast<float>((to[j] - from[j]) / step_s));
      }
      log.felt.insert(log.felt.end(), static_cast<std::size_t>(log.senses), 0.0f);
    }
  }

 private:
  std::span<const KinematicFrame> frames_;  // only while recording: there is nothing to resume from
};

}  // namespace

Motion RecordKinematic(Script script, std::span<const KinematicFrame> frames) {
  script.steps = static_cast<int>(frames.size()) - 1;
  return {std::make_unique<KinematicRecorder>(frames), script};
}

}  // namespace gaitsmith
