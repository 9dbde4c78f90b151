// SPDX-License-Identifier: MIT
#include "core/spacetime/planner.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/spacetime/interior_point.h"
#include "core/spacetime/plan_guess.h"
#include "core/spacetime/transcription.h"

namespace gaitsmith {

namespace {

/// What is missed by less is met [longest rods or radians].
constexpr double kMet = 1e-3;
/// Endpoints that stand from the start may be this far from the ground in the drawn pose [longest rods].
constexpr double kStartGap = 0.01;
/// Where a motion to start from is near, so is the barrier.
constexpr double kNearBarrier = 1e-3;

/// The finest description that plans are made for.
constexpr PlanGrid kFinestGrid{.degree = 5, .pieces_per_second = 32};
/// Second derivatives that are kept at once: half a gigabyte of memory.
constexpr double kMostBends = 1.2e7;

bool TooMuchFor(const PlanLayout& layout) {
  if (layout.unknowns > kMaxPlanUnknowns) return true;
  const double shares = layout.positions.Degree() + 1, force_shares = layout.forces.Degree() + 1;
  double bends = 0.0;
  for (const PlanLayout::Phase& phase : layout.phases) {
    const double columns =
        layout.model.rods * shares + 2.0 * static_cast<double>(phase.contacts.size()) * force_shares;
    constexpr double kInstants = 7.0;  // of a piece: quadrature and equations
    bends += phase.pieces * kInstants * 0.5 * columns * columns;
  }
  return bends > kMostBends;
}

/// A motion that misses as little of the plan as it can, whatever it costs.
struct Nearest {
  PlannedMotion motion;
  std::vector<PlanMiss> misses;  // the worst first
  int iterations;
  bool cancelled;
};
Nearest FindNearest(const PlanScene& scene, const PlanWatch& watch) {
  const PlanGrid coarse;
  const PlanLayout layout(scene, coarse);
  const Eigen::VectorXd guess = GuessPlan(scene, layout);
  const Transcription program(scene, layout, guess, true);
  const auto motion_of = [&](const Eigen::VectorXd& x) {
    return PlannedMotion(scene, coarse, {x.data(), static_cast<std::size_t>(layout.unknowns)});
  };
  const Solved solved = Minimize(
      program, {.x = program.Completed(guess)}, {},
      [&](const Eigen::VectorXd& x, int iteration) { return !watch || watch(motion_of(x), iteration); });
  Nearest nearest{motion_of(solved.at.x), {}, solved.iterations, solved.end == SolveEnd::kCancelled};
  // A point at which the solver gave up says nothing about the plan.
  if (solved.end != SolveEnd::kSolved) return nearest;
  for (PlanMiss miss : program.MissesOf(solved.at.x)) {
    if (miss.amount < kMet) break;
    if (miss.part.kind != PlanPart::Kind::kJoint && miss.part.kind != PlanPart::Kind::kTurn)
      miss.amount *= layout.length_m;
    nearest.misses.push_back(miss);
  }
  return nearest;
}

}  // namespace

Result<void> CheckScene(const PlanScene& scene) {
  if (scene.environment.sway_rad != 0.0f)
    return Fail(ErrorCode::kOutOfRange, "environment.sway_rad",
                "must be 0: keyframes need ground that does not rock");
  const PlanLayout layout(scene, {});
  if (TooMuchFor(PlanLayout(scene, kFinestGrid)))
    return Fail(ErrorCode::kTooMany, "plan", "has too many rods and stances for its length");
  const PlanInstant begin = layout.At(0, 0.0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(layout.unknowns);
  x[layout.Curve(1)] = layout.start_y;
  for (int j = 0; j < layout.model.rods; ++j)
    x[layout.Curve(2 + j)] = layout.start_direction[static_cast<std::size_t>(j)];
  const bool moves = layout.start_rate_x != 0.0 || layout.start_rate_y != 0.0 || layout.start_spin != 0.0;
  for (std::size_t s = 0; s < scene.plan.stances.size(); ++s) {
    const Stance& stance = scene.plan.stances[s];
    if (stance.first_step > 0) continue;
    const std::string where = "plan.stances[" + std::to_string(s) + "]";
    if (moves)
      return Fail(ErrorCode::kStructure, where, "cannot stand from the start, where the figure moves");
    const PlanLayout::Point place = layout.EndpointAt(x, begin, stance.endpoint);
    if (layout.ground.At(place.x).value != 0.0)
      return Fail(ErrorCode::kStructure, where,
                  "cannot stand from the start, where the ground is not at height 0");
    if (place.y > kStartGap)
      return Fail(ErrorCode::kStructure, where,
                  "cannot stand from the start, where the endpoint is above the ground");
  }
  return {};
}

PlanAnswer SolvePlan(const PlanScene& scene, const PlanGrid& grid, const PlannedMotion* from,
                     const PlanWatch& watch) {
  const PlanLayout layout(scene, grid);
  const Eigen::VectorXd guess = GuessPlan(scene, layout);
  const Transcription program(scene, layout, guess);
  PlanAnswer answer;
  const auto motion_of = [&](const Eigen::VectorXd& x) {
    return PlannedMotion(scene, grid, {x.data(), static_cast<std::size_t>(layout.unknowns)});
  };
  const auto solve = [&](const Eigen::VectorXd& start, double barrier) {
    InteriorPointSettings settings;
    settings.first_barrier = barrier;
    const Solved solved = Minimize(
        program, {.x = program.Completed(start)}, settings,
        [&](const Eigen::VectorXd& x, int iteration) { return !watch || watch(motion_of(x), iteration); });
    answer.iterations += solved.iterations;
    answer.cost = solved.objective;
    answer.cancelled = solved.end == SolveEnd::kCancelled;
    if (solved.end == SolveEnd::kSolved) answer.motion = motion_of(solved.at.x);
    return answer.motion || answer.cancelled;
  };
  const auto solve_from = [&](const PlannedMotion& motion) {
    const PlanLayout old(motion.Scene(), motion.Grid());
    return solve(
        Resample(Eigen::Map<const Eigen::VectorXd>(motion.Unknowns().data(), old.unknowns), old, layout),
        kNearBarrier);
  };
  if (from != nullptr ? solve_from(*from) : solve(guess, InteriorPointSettings{}.first_barrier))
    return answer;
  // It may be stuck where the plan can be met elsewhere.
  Nearest nearest = FindNearest(scene, watch);
  answer.iterations += nearest.iterations;
  answer.cancelled = nearest.cancelled;
  answer.misses = std::move(nearest.misses);
  if (answer.cancelled || !answer.misses.empty() || solve_from(nearest.motion)) return answer;
  if (from != nullptr) static_cast<void>(solve(guess, InteriorPointSettings{}.first_barrier));
  return answer;
}

}  // namespace gaitsmith
