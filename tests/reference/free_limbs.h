// SPDX-License-Identifier: MIT
// An independent model of a figure whose limbs move freely, in double precision and by other methods than
// core's: world positions of rods by walking the tree, the mass matrix by turning what is beyond each joint
// about it, the change of momenta by differences of the kinetic energy, time by fourth-order Runge-Kutta.
#pragma once

#include <Eigen/Core>

#include "core/physics/limb_state.h"
#include "core/physics/skeleton.h"

namespace gaitsmith::test {

class FreeLimbs {
 public:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;
  explicit FreeLimbs(const Skeleton& bones) : bones_(bones) {}

  /// Direction of the root, then the joint angles [rad] (rods).
  [[nodiscard]] Vector Place(const LimbState<1>&) const;
  /// Momenta of the root and of each joint, as the state carries them [kg m^2/s] (rods).
  [[nodiscard]] Vector Momenta(const LimbState<1>&) const;

  /// Mass matrix, seen from the centre of mass [kg m^2] (rods, rods).
  [[nodiscard]] Matrix Mass(const Vector& place) const;
  [[nodiscard]] double KineticEnergy(const Vector& place, const Vector& speed) const {
    return 0.5 * speed.dot(Mass(place) * speed);
  }
  /// How the kinetic energy changes with each coordinate at constant speeds [N m] (rods).
  [[nodiscard]] Vector Bias(const Vector& place, const Vector& speed) const;
  /// Kinetic energy of the limbs and of the centre of mass, and its height times gravity [J].
  [[nodiscard]] double Energy(const LimbState<1>&, double gravity_mps2) const;

  struct Moment {
    Vector place, momenta;
  };
  /// Where free limbs are after some time. @param steps of Runge-Kutta
  [[nodiscard]] Moment Fly(Moment from, double seconds, int steps) const;

 private:
  [[nodiscard]] Moment ChangeAt(const Moment&) const;

  Skeleton bones_;
};

}  // namespace gaitsmith::test
