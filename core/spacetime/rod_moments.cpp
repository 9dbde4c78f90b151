// SPDX-License-Identifier: MIT
#include "core/spacetime/rod_moments.h"

#include "core/numeric/scalar_math.h"
#include "core/physics/rod_multiples.h"

namespace gaitsmith {

RodModel::RodModel(const Skeleton& skeleton) : rods(skeleton.rods), parent{} {
  const RodMultiples multiples(skeleton);
  const double length = static_cast<double>(skeleton.longest_rod_m),
               mass = static_cast<double>(skeleton.mass_kg);
  arm.setZero(2 * rods + 1, rods);
  coupling.setZero(rods, rods);
  beyond.setIdentity(rods, rods);
  for (int j = 0; j < rods; ++j) {
    const auto column = static_cast<std::size_t>(j);
    parent[column] = skeleton.limbs[column].parent;
    for (int k = 0; k <= rods; ++k)
      arm(k, j) = (multiples.end[static_cast<std::size_t>(k)][column] - multiples.mean[column]) / length;
    for (int k = 0; k < rods; ++k)
      coupling(k, j) = multiples.coupling[static_cast<std::size_t>(k)][column] / (mass * length * length);
  }
  for (int i = 0; i < rods; ++i) {
    const int start = skeleton.limbs[static_cast<std::size_t>(i)].start;
    arm.row(rods + 1 + i) = 0.5 * (arm.row(start) + arm.row(i + 1));
  }
  for (int j = rods - 1; j > 0; --j) beyond.row(parent[static_cast<std::size_t>(j)]) += beyond.row(j);
}

void RodMoments::Set(const Numbers& numbers) {
  const int n = model_.rods;
  numbers_ = numbers;
  cosine_.resize(n);
  sine_.resize(n);
  for (int j = 0; j < n; ++j) {
    const auto [sine, cosine] = FineSinCos(numbers[j]);
    sine_[j] = sine;
    cosine_[j] = cosine;
  }
  values_.setZero(n);
  for (int j = 0; j < n; ++j) {
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double c = cosine_[j] * cosine_[k] + sine_[j] * sine_[k];
      const double s = sine_[j] * cosine_[k] - cosine_[j] * sine_[k];
      sum += model_.coupling(j, k) * (c * numbers[2 * n + k] + s * numbers[n + k] * numbers[n + k]);
    }
    for (std::size_t at = 0; at < contacts_.size(); ++at) {
      const int force = 3 * n + 2 * static_cast<int>(at);
      sum -= model_.arm(contacts_[at], j) * (-sine_[j] * numbers[force] + cosine_[j] * numbers[force + 1]);
    }
    values_[j] = sum;
  }
}

void RodMoments::FillJacobian(Jacobian& out) const {
  const int n = model_.rods;
  out.setZero(n, Count());
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const double a = model_.coupling(j, k);
      const double c = cosine_[j] * cosine_[k] + sine_[j] * sine_[k];
      const double s = sine_[j] * cosine_[k] - cosine_[j] * sine_[k];
      const double rate = numbers_[n + k], acceleration = numbers_[2 * n + k];
      const double turn = a * (-s * acceleration + c * rate * rate);
      out(j, j) += turn;
      out(j, k) -= turn;
      out(j, n + k) += 2.0 * a * s * rate;
      out(j, 2 * n + k) += a * c;
    }
    for (std::size_t at = 0; at < contacts_.size(); ++at) {
      const int force = 3 * n + 2 * static_cast<int>(at);
      const double arm = model_.arm(contacts_[at], j);
      out(j, j) += arm * (cosine_[j] * numbers_[force] + sine_[j] * numbers_[force + 1]);
      out(j, force) = arm * sine_[j];
      out(j, force + 1) = -arm * cosine_[j];
    }
  }
}

void RodMoments::AddHessian(const RodModel::Vector& weight, Hessian& out) const {
  const int n = model_.rods;
  const auto add = [&out](int one, int two, double value) {
    out(one, two) += value;
    if (one != two) out(two, one) += value;
  };
  for (int j = 0; j < n; ++j) {
    if (weight[j] == 0.0) continue;
    for (int k = 0; k < n; ++k) {
      if (k == j) continue;  // a rod's own term is its acceleration times a constant
      const double a = weight[j] * model_.coupling(j, k);
      const double c = cosine_[j] * cosine_[k] + sine_[j] * sine_[k];
      const double s = sine_[j] * cosine_[k] - cosine_[j] * sine_[k];
      const double rate = numbers_[n + k], acceleration = numbers_[2 * n + k];
      const double bend = -a * (c * acceleration + s * rate * rate);
      add(j, j, bend);
      add(k, k, bend);
      add(j, k, -bend);
      add(j, n + k, 2.0 * a * c * rate);
      add(k, n + k, -2.0 * a * c * rate);
      add(n + k, n + k, 2.0 * a * s);
      add(j, 2 * n + k, -a * s);
      add(k, 2 * n + k, a * s);
    }
    for (std::size_t at = 0; at < contacts_.size(); ++at) {
      const int force = 3 * n + 2 * static_cast<int>(at);
      const double arm = weight[j] * model_.arm(contacts_[at], j);
      add(j, j, arm * (-sine_[j] * numbers_[force] + cosine_[j] * numbers_[force + 1]));
      add(j, force, arm * cosine_[j]);
      add(j, force + 1, arm * sine_[j]);
    }
  }
}

}  // namespace gaitsmith
