// SPDX-License-Identifier: MIT
#include "core/spacetime/transcription.h"

#include <algorithm>
#include <vector>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

/// What a squared force or impulse costs against a squared torque. It settles how two feet share a load.
constexpr double kForceCost = 1e-4;
constexpr double kImpulseCost = 1e-2;
/// Of the animator's cost when what cannot be met is looked for: so little that it never pays to miss a wish.
/// With the standard smoothness; less where smoothness costs more.
constexpr double kElasticShare = 0.01, kElasticSmoothness = 0.1;

}  // namespace

Transcription::Transcription(const PlanScene& scene, const PlanLayout& layout, const Eigen::VectorXd& guess,
                             bool elastic)
    : layout_(layout),
      conditions_(scene, layout, guess, elastic),
      elastic_(elastic),
      smoothness_(static_cast<double>(scene.plan.smoothness)) {
  torques_ = layout.model.beyond.topRows(layout.model.rods);
  torques_.row(0).setZero();
  for (int j = 1; j < layout.model.rods; ++j) {
    const Skeleton::Limb& limb = scene.skeleton.limbs[static_cast<std::size_t>(j)];
    if (!(limb.min_rad < limb.max_rad)) torques_.row(j).setZero();
  }
  const auto vector_of = [](const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  };
  lower_ = vector_of(conditions_.lower);
  upper_ = vector_of(conditions_.upper);
  reach_ = vector_of(conditions_.reach);
  equations_ = static_cast<int>(ValuesAt(Eigen::VectorXd::Zero(Variables())).equations.size());
}

/// One walk over the program: its values, and with kSlopes also their first and second derivatives.
template <bool kSlopes>
struct Transcription::Pass {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd* multipliers = nullptr;
  Slopes* slopes = nullptr;
  double objective = 0.0;
  std::vector<double> equations{};

  [[nodiscard]] int Row() const { return static_cast<int>(equations.size()); }
  [[nodiscard]] double Multiplier() const { return kSlopes ? (*multipliers)[Row()] : 0.0; }
  /// The place of an entry must not depend on its value.
  void Slope(int variable, double slope) const {
    if constexpr (kSlopes) slopes->jacobian.Add(Row(), variable, slope);
  }
  void Bend(int one, int other, double value) const {
    if constexpr (kSlopes) slopes->hessian.Add(std::max(one, other), std::min(one, other), value);
  }
  void End(double value) { equations.push_back(value); }
};

namespace {

/// The numbers of an instant as sums of unknowns: which unknowns, and their shares.
class Columns {
 public:
  Columns(const PlanLayout& layout, const PlanInstant& at)
      : rods_(layout.model.rods),
        contacts_(layout.phases[static_cast<std::size_t>(at.phase)].contacts.size()),
        at_(at),
        friction_(layout.friction) {
    for (int j = 0; j < rods_; ++j)
      for (int i = 0; i < at.position[0].count; ++i)
        unknown.push_back(layout.Curve(2 + j) + at.position[0].first + i);
    for (std::size_t c = 0; c < contacts_; ++c)
      for (int i = 0; i < 2 * at.force.count; ++i) unknown.push_back(layout.ForceUnknown(at, c) + i);
  }

  std::vector<int> unknown;

  /// out = in T, where numbers = T unknowns. @param in (any, numbers)
  void Spread(const Eigen::MatrixXd& in, Eigen::MatrixXd& out) const {
    out.setZero(in.rows(), static_cast<Eigen::Index>(unknown.size()));
    const int count = at_.position[0].count;
    for (int j = 0; j < rods_; ++j)
      for (int order = 0; order < 3; ++order)
        for (int i = 0; i < count; ++i)
          out.col(j * count + i) +=
              at_.position[static_cast<std::size_t>(order)].share[static_cast<std::size_t>(i)] *
              in.col(order * rods_ + j);
    const int forces = rods_ * count;
    for (std::size_t c = 0; c < contacts_; ++c) {
      const int number = 3 * rods_ + 2 * static_cast<int>(c);
      for (int i = 0; i < at_.force.count; ++i) {
        const double share = at_.force.share[static_cast<std::size_t>(i)];
        const int column = forces + 2 * (static_cast<int>(c) * at_.force.count + i);
        out.col(column) += share * (friction_ * in.col(number) + in.col(number + 1));
        out.col(column + 1) += share * (-friction_ * in.col(number) + in.col(number + 1));
      }
    }
  }

 private:
  int rods_;
  std::size_t contacts_;
  const PlanInstant& at_;
  double friction_;
};

}  // namespace

template <bool kSlopes>
void Transcription::Go(Pass<kSlopes>& pass) const {
  const int n = layout_.model.rods;
  const Eigen::VectorXd& x = pass.x;
  Eigen::MatrixXd local, spread, turned, both;
  RodMoments::Jacobian jacobian;
  RodMoments::Hessian hessian;
  const double share = elastic_ ? kElasticShare / std::max(1.0, smoothness_ / kElasticSmoothness) : 1.0;

  const auto bend = [&](const Columns& columns) {
    local = hessian;
    columns.Spread(local, spread);
    turned = spread.transpose();
    columns.Spread(turned, both);
    for (std::size_t a = 0; a < columns.unknown.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b)
        pass.Bend(columns.unknown[a], columns.unknown[b],
                  both(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
  };

  for (const PlanInstant& at : conditions_.quadrature) {
    const auto& contacts = layout_.phases[static_cast<std::size_t>(at.phase)].contacts;
    const RodMoments::Numbers numbers = layout_.NumbersAt(x, at);
    const int count = static_cast<int>(numbers.size());
    const double weight = share * at.weight, force_cost = at.impulsive ? kImpulseCost : kForceCost;
    const auto forces = numbers.tail(count - 3 * n);
    RodMoments moments(layout_.model, contacts);
    RodModel::Vector torque = RodModel::Vector::Zero(n);
    if (!at.impulsive) {
      moments.Set(numbers);
      torque = torques_ * moments.Values();
      pass.objective +=
          weight * (torque.squaredNorm() + smoothness_ * numbers.segment(2 * n, n).squaredNorm());
    }
    pass.objective += weight * force_cost * forces.squaredNorm();
    if constexpr (kSlopes) {
      const Columns columns(layout_, at);
      hessian.setZero(count, count);
      Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(1, count);
      if (!at.impulsive) {
        moments.FillJacobian(jacobian);
        const RodMoments::Jacobian of_torque = torques_ * jacobian;
        gradient = 2.0 * weight * torque.transpose() * of_torque;
        hessian += 2.0 * weight * of_torque.transpose() * of_torque;
        moments.AddHessian(2.0 * weight * torques_.transpose() * torque, hessian);
        for (int j = 2 * n; j < 3 * n; ++j) {
          gradient(0, j) += 2.0 * weight * smoothness_ * numbers[j];
          hessian(j, j) += 2.0 * weight * smoothness_;
        }
      }
      for (int j = 3 * n; j < count; ++j) {
        gradient(0, j) += 2.0 * weight * force_cost * numbers[j];
        hessian(j, j) += 2.0 * weight * force_cost;
      }
      columns.Spread(gradient, spread);
      for (std::size_t i = 0; i < columns.unknown.size(); ++i)
        pass.slopes->gradient[columns.unknown[i]] += spread(0, static_cast<Eigen::Index>(i));
      bend(columns);
    }
  }

  for (const PlanInstant& at : conditions_.newton) {
    const auto& contacts = layout_.phases[static_cast<std::size_t>(at.phase)].contacts;
    const RodMoments::Numbers numbers = layout_.NumbersAt(x, at);
    for (int axis = 0; axis < 2; ++axis) {
      double sum = layout_.ValueOf(x, axis, at.position[2]);
      for (int i = 0; i < at.position[2].count; ++i)
        pass.Slope(layout_.Curve(axis) + at.position[2].first + i,
                   at.position[2].share[static_cast<std::size_t>(i)]);
      for (std::size_t c = 0; c < contacts.size(); ++c) {
        sum -= numbers[3 * n + 2 * static_cast<int>(c) + axis];
        const int unknown = layout_.ForceUnknown(at, c);
        for (int i = 0; i < at.force.count; ++i) {
          const double part = at.force.share[static_cast<std::size_t>(i)];
          pass.Slope(unknown + 2 * i, -part * (axis == 0 ? layout_.friction : 1.0));
          pass.Slope(unknown + 2 * i + 1, part * (axis == 0 ? layout_.friction : -1.0));
        }
      }
      if (!at.impulsive) sum -= axis == 0 ? layout_.gravity_x : layout_.gravity_y;
      pass.End(sum);
    }
    RodMoments moments(layout_.model, contacts);
    moments.Set(numbers);
    if constexpr (kSlopes) {
      const Columns columns(layout_, at);
      moments.FillJacobian(jacobian);
      local = jacobian.colwise().sum();
      columns.Spread(local, spread);
      for (std::size_t i = 0; i < columns.unknown.size(); ++i)
        pass.Slope(columns.unknown[i], spread(0, static_cast<Eigen::Index>(i)));
      hessian.setZero(numbers.size(), numbers.size());
      moments.AddHessian(RodModel::Vector::Constant(n, pass.Multiplier()), hessian);
      bend(columns);
    }
    pass.End(moments.Values().sum());
  }

  // Where an endpoint is along an axis, and how that depends on the unknowns.
  const auto locate = [&](const PlanInstant& at, int endpoint, bool along, double multiplier) {
    const SplineShares& shares = at.position[0];
    double place = layout_.ValueOf(x, along ? 0 : 1, shares);
    for (int i = 0; i < shares.count; ++i)
      pass.Slope(layout_.Curve(along ? 0 : 1) + shares.first + i, shares.share[static_cast<std::size_t>(i)]);
    if (endpoint == kCentreOfMass) return place;
    for (int j = 0; j < n; ++j) {
      const double arm = layout_.model.arm(endpoint, j);
      const auto [sine, cosine] = FineSinCos(layout_.ValueOf(x, 2 + j, shares));
      place += arm * (along ? cosine : sine);
      const double slope = arm * (along ? -sine : cosine),
                   curvature = -multiplier * arm * (along ? cosine : sine);
      const int first = layout_.Curve(2 + j) + shares.first;
      for (int a = 0; a < shares.count; ++a) {
        const double one = shares.share[static_cast<std::size_t>(a)];
        pass.Slope(first + a, slope * one);
        for (int b = 0; b <= a; ++b)
          pass.Bend(first + a, first + b, curvature * one * shares.share[static_cast<std::size_t>(b)]);
      }
    }
    return place;
  };
  // How far a point is above the cover of the ground.
  const auto rise = [&](const PlanInstant& at, int point, double multiplier) {
    if (layout_.ground.Level()) return locate(at, point, false, multiplier);
    const SplineShares& shares = at.position[0];
    const PlanLayout::Point now = layout_.EndpointAt(x, at, point);
    const PlanGround::Height cover = layout_.ground.CoverAt(now.x);
    // How the point moves along the ground with each coefficient, and how it rises over the slope.
    std::vector<int> unknowns;
    std::vector<double> along;
    const auto add = [&](int first, double slope_x, double slope_y) {
      for (int i = 0; i < shares.count; ++i) {
        const double part = shares.share[static_cast<std::size_t>(i)];
        unknowns.push_back(first + i);
        along.push_back(slope_x * part);
        pass.Slope(first + i, (slope_y - cover.slope * slope_x) * part);
      }
    };
    add(layout_.Curve(0) + shares.first, 1.0, 0.0);
    add(layout_.Curve(1) + shares.first, 0.0, 1.0);
    for (int j = 0; j < n; ++j) {
      const double arm = layout_.model.arm(point, j);
      const auto [sine, cosine] = FineSinCos(layout_.ValueOf(x, 2 + j, shares));
      const int first = layout_.Curve(2 + j) + shares.first;
      add(first, -arm * sine, arm * cosine);
      const double curvature = multiplier * arm * (-sine + cover.slope * cosine);
      for (int a = 0; a < shares.count; ++a)
        for (int b = 0; b <= a; ++b)
          pass.Bend(first + a, first + b,
                    curvature * shares.share[static_cast<std::size_t>(a)] *
                        shares.share[static_cast<std::size_t>(b)]);
    }
    for (std::size_t a = 0; a < unknowns.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b)
        pass.Bend(unknowns[a], unknowns[b], -multiplier * cover.bend * along[a] * along[b]);
    return now.y - cover.value;
  };
  const auto give = [&](int first) {
    if (first < 0) return 0.0;
    pass.Slope(first, -1.0);
    pass.Slope(first + 1, 1.0);
    return x[first + 1] - x[first];
  };

  for (const PlanConditions::Pin& pin : conditions_.pins) {
    const auto stance = static_cast<std::size_t>(pin.stance);
    const int endpoint = [&] {
      const PlanLayout::Phase& phase = layout_.phases[static_cast<std::size_t>(pin.at.phase)];
      const auto found = std::ranges::find(phase.stances, pin.stance);
      return phase.contacts[static_cast<std::size_t>(found - phase.stances.begin())];
    }();
    const int gives = conditions_.stance_give[stance];
    const int place = layout_.stance_place[stance];
    if (pin.x) {
      double along = locate(pin.at, endpoint, true, pass.Multiplier());
      if (place < 0) {
        along -= layout_.stance_start[stance].x;
      } else {
        along -= x[place];
        pass.Slope(place, -1.0);
      }
      along += give(gives);
      pass.End(along);
    }
    double up = locate(pin.at, endpoint, false, pass.Multiplier()) - layout_.stance_start[stance].y;
    if (place >= 0 && !layout_.ground.Level()) {
      const PlanGround::Height ground = layout_.ground.At(x[place]);
      up -= ground.value;
      pass.Slope(place, -ground.slope);
    }
    up += give(gives < 0 ? -1 : gives + 2);
    pass.End(up);
  }
  for (const PlanConditions::Clearance& clearance : conditions_.clearances) {
    const double height = rise(clearance.at, clearance.point, pass.Multiplier());
    pass.Slope(clearance.height, -1.0);
    pass.End(height - x[clearance.height]);
  }
  for (const PlanConditions::Limit& limit : conditions_.limits) {
    const int outer = layout_.Curve(3 + limit.joint) + limit.coefficient;
    const int inner = layout_.Curve(2 + layout_.model.parent[static_cast<std::size_t>(limit.joint) + 1]) +
                      limit.coefficient;
    pass.Slope(outer, 1.0);
    pass.Slope(inner, -1.0);
    double off = x[outer] - x[inner];
    if (limit.angle >= 0) {
      pass.Slope(limit.angle, -1.0);
      off -= x[limit.angle];
    } else {
      off -= layout_.start_direction[static_cast<std::size_t>(limit.joint) + 1] -
             layout_.start_direction[static_cast<std::size_t>(
                 layout_.model.parent[static_cast<std::size_t>(limit.joint) + 1])];
    }
    pass.End(off);
  }
  for (const PlanConditions::Line& line : conditions_.lines) {
    double off = -line.value;
    for (int i = 0; i < line.shares.count; ++i) {
      const double part = line.shares.share[static_cast<std::size_t>(i)];
      const int at = layout_.Curve(line.curve) + line.shares.first + i;
      off += part * x[at];
      pass.Slope(at, part);
      if (line.less < 0) continue;
      const int less = layout_.Curve(line.less) + line.shares.first + i;
      off -= part * x[less];
      pass.Slope(less, -part);
    }
    off += give(line.give);
    pass.End(off);
  }
  for (const PlanConditions::Aim& aim : conditions_.aims) {
    double off = locate(aim.at, aim.endpoint, aim.x, pass.Multiplier()) - aim.value;
    off += give(aim.give);
    pass.End(off);
  }
  for (const PlanConditions::Give& one : conditions_.gives) {
    for (int i = 0; i < 2; ++i) {
      pass.objective += x[one.first + i];
      if constexpr (kSlopes) pass.slopes->gradient[one.first + i] += 1.0;
    }
  }
}

NonlinearProgram::Values Transcription::ValuesAt(const Eigen::VectorXd& x) const {
  Pass<false> pass{x};
  pass.equations.reserve(static_cast<std::size_t>(equations_));
  Go(pass);
  return {pass.objective, Eigen::Map<Eigen::VectorXd>(pass.equations.data(),
                                                      static_cast<Eigen::Index>(pass.equations.size()))};
}

void Transcription::SlopesAt(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers,
                             Slopes& out) const {
  out.gradient = Eigen::VectorXd::Zero(Variables());
  out.jacobian.Clear();
  out.hessian.Clear();
  Pass<true> pass{x, &multipliers, &out};
  pass.equations.reserve(static_cast<std::size_t>(equations_));
  Go(pass);
}

Eigen::VectorXd Transcription::Completed(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(Variables());
  x.head(layout_.unknowns) = unknowns.head(layout_.unknowns);
  for (const PlanConditions::Clearance& clearance : conditions_.clearances) {
    const PlanLayout::Point point = layout_.EndpointAt(x, clearance.at, clearance.point);
    x[clearance.height] = point.y - layout_.ground.CoverAt(point.x).value;
  }
  for (const PlanConditions::Limit& limit : conditions_.limits) {
    if (limit.angle < 0) continue;
    const int parent = layout_.model.parent[static_cast<std::size_t>(limit.joint) + 1];
    x[limit.angle] = x[layout_.Curve(3 + limit.joint) + limit.coefficient] -
                     x[layout_.Curve(2 + parent) + limit.coefficient];
  }
  return x;
}

std::vector<PlanMiss> Transcription::MissesOf(const Eigen::VectorXd& x) const {
  std::vector<PlanMiss> misses;
  misses.reserve(conditions_.gives.size());
  for (const PlanConditions::Give& give : conditions_.gives)
    misses.push_back({give.part, x[give.first] + x[give.first + 1]});
  std::ranges::sort(misses,
                    [](const PlanMiss& one, const PlanMiss& other) { return one.amount > other.amount; });
  return misses;
}

}  // namespace gaitsmith
