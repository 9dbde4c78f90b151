// SPDX-License-Identifier: MIT
#include "core/rollout/curve_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/physics/joint_response.h"

namespace gaitsmith {

namespace {

/// Sweeps over the knots that keep them within the joint's limits. Few are at a limit, so few sweeps suffice.
constexpr int kSweeps = 100;

/// The angle over time of a joint with no limits whose target is one knot's share of a curve; a column for
/// each knot. The angles of any curve are the sums of these, because a joint's answer is linear.
Eigen::MatrixXd AnswersOf(int frames, const CurveShape& shape, const SenseSpec& senses) {
  const KnotTimes times(shape.knots, senses);
  const double tau_s = static_cast<double>(senses.tau_min_s), step_s = static_cast<double>(kStep);
  const double decay = Exp(-step_s / tau_s);
  Eigen::MatrixXd answers = Eigen::MatrixXd::Zero(frames, shape.knots);
  Eigen::VectorXd angle = Eigen::VectorXd::Zero(shape.knots), rate = angle, target = angle;
  for (int frame = 1; frame < frames; ++frame) {
    const KnotTimes::Mix mix = times.ValueAt(frame - 1 + JointCurves<1>::kMidStep);
    target.setZero();
    for (std::size_t i = 0; i < 4; ++i) target[static_cast<Eigen::Index>(mix.knot[i])] += mix.weight[i];
    // As MoveJoints, without limits.
    const Eigen::VectorXd off = angle - target;
    const Eigen::VectorXd pull = (rate + off / tau_s) * step_s;
    angle = target + (off + pull) * decay;
    rate = (rate - pull / tau_s) * decay;
    answers.row(frame) = angle;
  }
  return answers;
}

}  // namespace

CurveFit FitCurves(std::span<const float> angles_rad, const Skeleton& figure, const CurveShape& shape,
                   const SenseSpec& senses, std::span<const FreeJoint> from) {
  const auto joints = static_cast<std::size_t>(shape.joints);
  const int frames = joints == 0 ? 0 : static_cast<int>(angles_rad.size() / joints);
  const Eigen::MatrixXd answers = AnswersOf(frames, shape, senses);
  Eigen::MatrixXd normal = answers.transpose() * answers;
  // Knots that no frame depends on stay near the middle.
  normal.diagonal().array() += 1e-6;
  const Eigen::LLT<Eigen::MatrixXd> solver(normal);

  const auto tau_s = static_cast<double>(senses.tau_min_s);
  CurveFit fit{Genome(shape.Genes())};
  double squares = 0.0;
  for (int joint = 0; joint < shape.joints; ++joint) {
    const Skeleton::Limb& limb = figure.limbs[static_cast<std::size_t>(joint) + 1];
    // What the curve has to add to how the joint moves by itself towards 0.
    FreeJoint alone = from.empty() ? FreeJoint{} : from[static_cast<std::size_t>(joint)];
    Eigen::VectorXd wanted(frames);
    for (int frame = 0; frame < frames; ++frame) {
      if (frame > 0) alone.Advance(0.0, tau_s);
      wanted[frame] = static_cast<double>(
          angles_rad[static_cast<std::size_t>(frame) * joints + static_cast<std::size_t>(joint)]);
      wanted[frame] -= alone.angle_rad;
    }
    const Eigen::VectorXd right = answers.transpose() * wanted;
    const auto low = static_cast<double>(limb.min_rad), high = static_cast<double>(limb.max_rad);
    Eigen::VectorXd knots = solver.solve(right).cwiseMax(low).cwiseMin(high);
    // Coordinate descent on a convex function within a box.
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (Eigen::Index k = 0; k < knots.size(); ++k) {
        const double slope = normal.row(k).dot(knots) - right[k];
        knots[k] = std::clamp(knots[k] - slope / normal(k, k), low, high);
      }
    }
    for (int knot = 0; knot < shape.knots; ++knot) {
      Gene& gene = fit.genes[shape.Angle(knot, joint)];
      gene = Encode(static_cast<float>(knots[knot]), limb.min_rad, limb.max_rad);
      knots[knot] = static_cast<double>(Decode(gene, limb.min_rad, limb.max_rad));
    }
    const Eigen::VectorXd off = answers * knots - wanted;
    fit.worst_rad = std::max(fit.worst_rad, off.cwiseAbs().maxCoeff());
    squares += off.squaredNorm();
    FreeJoint& end = fit.end.emplace_back(from.empty() ? FreeJoint{} : from[static_cast<std::size_t>(joint)]);
    const KnotTimes times(shape.knots, senses);
    for (int frame = 1; frame < frames; ++frame) {
      const KnotTimes::Mix mix = times.ValueAt(frame - 1 + JointCurves<1>::kMidStep);
      double target = 0.0;
      for (std::size_t i = 0; i < 4; ++i)
        target += mix.weight[i] * knots[static_cast<Eigen::Index>(mix.knot[i])];
      end.Advance(target, tau_s);
    }
  }
  if (shape.joints > 0) fit.typical_rad = std::sqrt(squares / (shape.joints * static_cast<double>(frames)));
  return fit;
}

}  // namespace gaitsmith
