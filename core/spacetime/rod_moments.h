// SPDX-License-Identifier: MIT
// The moment that joints must give each rod, so that the figure moves as it does, with derivatives. With the
// centre of mass and the absolute directions alpha of the rods as coordinates, the equation of rod j is
//   R_j = sum_k A_jk [cos(alpha_j - alpha_k) alpha_k'' + sin(alpha_j - alpha_k) alpha_k'^2] - moments of
//   forces,
// its sum over all rods is the change of angular momentum less the moment of all forces, and its sum over the
// rods beyond a joint is that joint's torque.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "core/physics/skeleton.h"

namespace gaitsmith {

/// A figure in the units of a plan: mass 1, longest rod 1, standard gravity 1.
struct RodModel {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRods, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                               kMaxEndpoints + kMaxRods, kMaxRods>;

  explicit RodModel(const Skeleton&);

  int rods;
  std::array<int, kMaxRods> parent;  // -1 for the root
  Matrix arm;       // endpoints, then middles of rods, from the centre of mass, as multiples of directions
                    // (endpoints + rods, rods)
  Matrix coupling;  // A (rods, rods)
  Matrix beyond;    // 1 for the rods beyond each joint, by its outer rod; all for the root (rods, rods)
};

class RodMoments {
 public:
  static constexpr int kMaxNumbers = 3 * kMaxRods + 2 * kMaxEndpoints;
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxNumbers, 1>;
  using Jacobian =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxRods, kMaxNumbers>;
  using Hessian =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxNumbers, kMaxNumbers>;

  /// @param contacts endpoints that forces act on; must outlive this
  RodMoments(const RodModel& model, std::span<const int> contacts) : model_(model), contacts_(contacts) {}

  /// Directions, then rates, then accelerations of all rods, then the force on each contact, along and up.
  [[nodiscard]] int Count() const { return 3 * model_.rods + 2 * static_cast<int>(contacts_.size()); }

  void Set(const Numbers& numbers);
  [[nodiscard]] const RodModel::Vector& Values() const { return values_; }
  /// (rods, Count())
  void FillJacobian(Jacobian& out) const;
  /// Adds sum_j weight_j times the second derivatives of R_j; both triangles. (Count(), Count())
  void AddHessian(const RodModel::Vector& weight, Hessian& out) const;

 private:
  const RodModel& model_;
  std::span<const int> contacts_;
  Numbers numbers_;
  RodModel::Vector values_, cosine_, sine_;
};

}  // namespace gaitsmith
