// SPDX-License-Identifier: MIT
#include "core/spacetime/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "core/spacetime/newton_system.h"

namespace gaitsmith {

namespace {

// Constants of [Waechter 2006], with its names.
constexpr double kKappaEpsilon = 10.0, kKappaMu = 0.2;
constexpr double kTauMin = 0.99, kKappaSigma = 1e10, kSMax = 100.0;
constexpr double kGammaTheta = 1e-5, kGammaPhi = 1e-8, kDelta = 1.0, kSTheta = 1.1, kSPhi = 2.3, kEta = 1e-4;
constexpr double kKappa1 = 1e-2;  // how far inside its bounds a start is pushed
constexpr int kMostCorrections = 4;
constexpr double kLeastStep = 1e-8;
constexpr double kAcceptable = 3e-2;  // of the slopes, where no step makes it better
constexpr int kMostRepairs = 40;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Solver {
 public:
  Solver(const NonlinearProgram& program, const InteriorPointSettings& settings)
      : program_(program),
        settings_(settings),
        lower_(program.Lower()),
        upper_(program.Upper()),
        reach_(program.Reach()),
        variables_(program.Variables()),
        equations_(program.Equations()),
        system_(variables_, equations_),
        mu_(settings.first_barrier) {}

  Solved Run(PrimalDual start, const std::function<bool(const Eigen::VectorXd&, int)>& watch) {
    Begin(std::move(start));
    SolveEnd end = SolveEnd::kTooLong;
    int iteration = 0;
    for (; iteration < settings_.most_iterations; ++iteration) {
      if (watch && !watch(at_.x, iteration)) {
        end = SolveEnd::kCancelled;
        break;
      }
      program_.SlopesAt(at_.x, at_.multipliers, slopes_);
      if (ErrorOf(0.0) <= settings_.tolerance) {
        end = SolveEnd::kSolved;
        break;
      }
      LowerBarrier();
      if (Step()) continue;
      // Near the minimum rounding hides whether a step makes it better.
      if (now_.equations.lpNorm<Eigen::Infinity>() <= settings_.tolerance) {
        if (SinkBarrier()) continue;
        if (ErrorOf(0.0) <= kAcceptable) {
          end = SolveEnd::kSolved;
          break;
        }
      }
      if (!Repair()) {
        end = SolveEnd::kStuck;
        break;
      }
    }
    return {end, at_, iteration, now_.objective, now_.equations.lpNorm<Eigen::Infinity>()};
  }

 private:
  [[nodiscard]] bool HasLower(int i) const { return lower_[i] > -kInfinity; }
  [[nodiscard]] bool HasUpper(int i) const { return upper_[i] < kInfinity; }

  void Begin(PrimalDual start) {
    at_ = std::move(start);
    for (int i = 0; i < variables_; ++i) {
      const double range = upper_[i] - lower_[i];
      if (HasLower(i)) {
        const double room =
            std::min(kKappa1 * std::max(1.0, std::abs(lower_[i])), HasUpper(i) ? kKappa1 * range : kInfinity);
        at_.x[i] = std::max(at_.x[i], lower_[i] + std::min(room, mu_));
      }
      if (HasUpper(i)) {
        const double room =
            std::min(kKappa1 * std::max(1.0, std::abs(upper_[i])), HasLower(i) ? kKappa1 * range : kInfinity);
        at_.x[i] = std::min(at_.x[i], upper_[i] - std::min(room, mu_));
      }
    }
    if (at_.lower.size() != variables_ || at_.upper.size() != variables_) {
      at_.lower = at_.upper = Eigen::VectorXd::Zero(variables_);
      for (int i = 0; i < variables_; ++i) {
        if (HasLower(i)) at_.lower[i] = 1.0;
        if (HasUpper(i)) at_.upper[i] = 1.0;
      }
    }
    KeepNearBarrier();
    now_ = program_.ValuesAt(at_.x);
    if (at_.multipliers.size() != equations_) {
      at_.multipliers = Eigen::VectorXd::Zero(equations_);
      EstimateMultipliers();
    }
    most_violation_ = 1e4 * std::max(1.0, Violation(now_));
    small_violation_ = 1e-4 * std::max(1.0, Violation(now_));
  }

  /// By least squares; those of a bad start are left out.
  void EstimateMultipliers() {
    program_.SlopesAt(at_.x, at_.multipliers, slopes_);
    if (!system_.FactorLeast(slopes_.hessian, slopes_.jacobian, 1.0)) return;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(variables_ + equations_);
    right.head(variables_) = -(slopes_.gradient - at_.lower + at_.upper);
    const Eigen::VectorXd found = system_.Solve(right).tail(equations_);
    if (found.lpNorm<Eigen::Infinity>() <= 1e3) at_.multipliers = found;
  }

  static double Violation(const NonlinearProgram::Values& values) { return values.equations.lpNorm<1>(); }

  /// The objective with its barrier.
  [[nodiscard]] double Merit(const NonlinearProgram::Values& values, const Eigen::VectorXd& x) const {
    double merit = values.objective;
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) merit -= mu_ * Log(x[i] - lower_[i]);
      if (HasUpper(i)) merit -= mu_ * Log(upper_[i] - x[i]);
    }
    return merit;
  }

  [[nodiscard]] Eigen::VectorXd MeritGradient() const {
    Eigen::VectorXd gradient = slopes_.gradient;
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) gradient[i] -= mu_ / (at_.x[i] - lower_[i]);
      if (HasUpper(i)) gradient[i] += mu_ / (upper_[i] - at_.x[i]);
    }
    return gradient;
  }

  [[nodiscard]] Eigen::VectorXd Pull(const Eigen::VectorXd& multipliers) const {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(variables_);
    for (std::size_t i = 0; i < slopes_.jacobian.places.size(); ++i) {
      const auto& [row, column] = slopes_.jacobian.places[i];
      pull[column] += slopes_.jacobian.values[i] * multipliers[row];
    }
    return pull;
  }

  /// How far the point is from the conditions of a minimum with a barrier: its equation (5).
  [[nodiscard]] double ErrorOf(double mu) const {
    const Eigen::VectorXd dual = slopes_.gradient + Pull(at_.multipliers) - at_.lower + at_.upper;
    const double bounds = at_.lower.lpNorm<1>() + at_.upper.lpNorm<1>();
    const double dual_scale =
        std::max(kSMax, (at_.multipliers.lpNorm<1>() + bounds) / std::max(1, equations_ + variables_)) /
        kSMax;
    const double bound_scale = std::max(kSMax, bounds / std::max(1, variables_)) / kSMax;
    double gap = 0.0;
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) gap = std::max(gap, std::abs((at_.x[i] - lower_[i]) * at_.lower[i] - mu));
      if (HasUpper(i)) gap = std::max(gap, std::abs((upper_[i] - at_.x[i]) * at_.upper[i] - mu));
    }
    return std::max({dual.lpNorm<Eigen::Infinity>() / dual_scale, now_.equations.lpNorm<Eigen::Infinity>(),
                     gap / bound_scale});
  }

  /// The next barrier. @return false: it is the last one already
  bool SinkBarrier() {
    const double least = settings_.tolerance / 10.0;
    if (mu_ <= least) return false;
    mu_ = std::max(least, std::min(kKappaMu * mu_, mu_ * std::sqrt(mu_)));  // its theta_mu is 1.5
    filter_.clear();
    return true;
  }
  void LowerBarrier() {
    while (ErrorOf(mu_) <= kKappaEpsilon * mu_ && SinkBarrier()) {
    }
  }

  /// The greatest share of a change that keeps numbers inside their bounds.
  [[nodiscard]] double LongestStep(const Eigen::VectorXd& change) const {
    const double tau = std::max(kTauMin, 1.0 - mu_);
    double longest = 1.0;
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i) && change[i] < 0.0)
        longest = std::min(longest, -tau * (at_.x[i] - lower_[i]) / change[i]);
      if (HasUpper(i) && change[i] > 0.0)
        longest = std::min(longest, tau * (upper_[i] - at_.x[i]) / change[i]);
      if (std::abs(change[i]) * longest > reach_[i]) longest = reach_[i] / std::abs(change[i]);
    }
    return longest;
  }
  [[nodiscard]] double LongestStep(const Eigen::VectorXd& multipliers, const Eigen::VectorXd& change) const {
    const double tau = std::max(kTauMin, 1.0 - mu_);
    double longest = 1.0;
    for (int i = 0; i < variables_; ++i)
      if (change[i] < 0.0) longest = std::min(longest, -tau * multipliers[i] / change[i]);
    return longest;
  }

  /// A violation and a merit that a new point must improve upon.
  struct Corner {
    double violation, merit;
  };
  [[nodiscard]] bool Accepts(double violation, double merit) const {
    if (!(violation <= most_violation_) || !std::isfinite(merit)) return false;
    return std::ranges::all_of(
        filter_, [&](const Corner& corner) { return violation < corner.violation || merit < corner.merit; });
  }
  void AddToFilter(double violation, double merit) {
    filter_.push_back({(1.0 - kGammaTheta) * violation, merit - kGammaPhi * violation});
  }

  /// One Newton step with its line search. @return false if no step was acceptable
  bool Step() {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(variables_);
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) diagonal[i] += at_.lower[i] / (at_.x[i] - lower_[i]);
      if (HasUpper(i)) diagonal[i] += at_.upper[i] / (upper_[i] - at_.x[i]);
    }
    if (!system_.Factor(slopes_.hessian, slopes_.jacobian, diagonal)) return false;
    const Eigen::VectorXd gradient = MeritGradient();
    Eigen::VectorXd right(variables_ + equations_);
    right << -(gradient + Pull(at_.multipliers)), -now_.equations;
    const Eigen::VectorXd change = system_.Solve(right);
    if (!change.allFinite()) return false;
    const Eigen::VectorXd dx = change.head(variables_), dy = change.tail(equations_);

    const double violation = Violation(now_), merit = Merit(now_, at_.x);
    const double slope = gradient.dot(dx);
    const double longest = LongestStep(dx);
    for (double share = longest; share >= kLeastStep; share *= 0.5) {
      const bool switching = slope < 0.0 && share * Power(-slope, kSPhi) > kDelta * Power(violation, kSTheta);
      const auto good = [&](const NonlinearProgram::Values& tried, const Eigen::VectorXd& x) {
        const double tried_violation = Violation(tried), tried_merit = Merit(tried, x);
        if (!Accepts(tried_violation, tried_merit)) return false;
        // A few units of the last place are no increase.
        const double rounding = 1e-14 * std::abs(merit);
        if (violation <= small_violation_ && switching)
          return tried_merit <= merit + kEta * share * slope + rounding;
        return tried_violation <= (1.0 - kGammaTheta) * violation ||
               tried_merit <= merit - kGammaPhi * violation + rounding;
      };
      Eigen::VectorXd x = at_.x + share * dx;
      NonlinearProgram::Values tried = program_.ValuesAt(x);
      bool accepted = good(tried, x);
      if (!accepted && share == longest && Violation(tried) >= violation) {
        accepted = Correct(x, tried, share, good);
      }
      if (!accepted) continue;
      const double tried_merit = Merit(tried, x);
      if (!(violation <= small_violation_ && switching && tried_merit <= merit + kEta * share * slope))
        AddToFilter(violation, merit);
      Take(std::move(x), std::move(tried), dx, dy, share);
      return true;
    }
    return false;
  }

  /// Second-order corrections of a first trial that the equations' curvature spoils: its section 2.4.
  template <class Good>
  bool Correct(Eigen::VectorXd& x, NonlinearProgram::Values& tried, double share, const Good& good) {
    Eigen::VectorXd equations = share * now_.equations + tried.equations;
    double last = Violation(tried);
    Eigen::VectorXd right(variables_ + equations_);
    right.head(variables_) = -(MeritGradient() + Pull(at_.multipliers));
    for (int i = 0; i < kMostCorrections; ++i) {
      right.tail(equations_) = -equations;
      const Eigen::VectorXd corrected = system_.Solve(right).head(variables_);
      if (!corrected.allFinite()) return false;
      const double length = LongestStep(corrected);
      Eigen::VectorXd next = at_.x + length * corrected;
      NonlinearProgram::Values values = program_.ValuesAt(next);
      if (good(values, next)) {
        x = std::move(next);
        tried = std::move(values);
        return true;
      }
      if (Violation(values) > 0.99 * last) return false;
      last = Violation(values);
      equations = length * equations + values.equations;
    }
    return false;
  }

  void Take(Eigen::VectorXd x, NonlinearProgram::Values values, const Eigen::VectorXd& dx,
            const Eigen::VectorXd& dy, double share) {
    Eigen::VectorXd lower_change = Eigen::VectorXd::Zero(variables_), upper_change = lower_change;
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) {
        const double room = at_.x[i] - lower_[i];
        lower_change[i] = (mu_ - at_.lower[i] * dx[i]) / room - at_.lower[i];
      }
      if (HasUpper(i)) {
        const double room = upper_[i] - at_.x[i];
        upper_change[i] = (mu_ + at_.upper[i] * dx[i]) / room - at_.upper[i];
      }
    }
    at_.lower += LongestStep(at_.lower, lower_change) * lower_change;
    at_.upper += LongestStep(at_.upper, upper_change) * upper_change;
    at_.multipliers += share * dy;
    at_.x = std::move(x);
    now_ = std::move(values);
    KeepNearBarrier();
  }

  /// Multipliers of bounds stay within a factor of what the barrier says.
  void KeepNearBarrier() {
    for (int i = 0; i < variables_; ++i) {
      if (HasLower(i)) {
        const double natural = mu_ / (at_.x[i] - lower_[i]);
        at_.lower[i] = std::clamp(at_.lower[i], natural / kKappaSigma, natural * kKappaSigma);
      }
      if (HasUpper(i)) {
        const double natural = mu_ / (upper_[i] - at_.x[i]);
        at_.upper[i] = std::clamp(at_.upper[i], natural / kKappaSigma, natural * kKappaSigma);
      }
    }
  }

  /// Where no step is acceptable: shortest steps towards the equations, until the filter takes the point.
  bool Repair() {
    AddToFilter(Violation(now_), Merit(now_, at_.x));
    const double before = Violation(now_);
    if (before <= settings_.tolerance) return false;
    double weight = 1e-3;
    for (int i = 0; i < kMostRepairs; ++i) {
      program_.SlopesAt(at_.x, at_.multipliers, slopes_);
      Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(variables_, weight);
      for (int k = 0; k < variables_; ++k) {
        if (HasLower(k)) diagonal[k] += mu_ / Square(at_.x[k] - lower_[k]);
        if (HasUpper(k)) diagonal[k] += mu_ / Square(upper_[k] - at_.x[k]);
      }
      SparseEntries nothing = slopes_.hessian;
      std::ranges::fill(nothing.values, 0.0);
      if (!system_.Factor(nothing, slopes_.jacobian, diagonal)) return false;
      Eigen::VectorXd right = Eigen::VectorXd::Zero(variables_ + equations_);
      right.tail(equations_) = -now_.equations;
      const Eigen::VectorXd dx = system_.Solve(right).head(variables_);
      if (!dx.allFinite()) return false;
      bool moved = false;
      for (double share = LongestStep(dx); share >= kLeastStep; share *= 0.5) {
        Eigen::VectorXd x = at_.x + share * dx;
        NonlinearProgram::Values tried = program_.ValuesAt(x);
        if (!(Violation(tried) <= (1.0 - 1e-3 * share) * Violation(now_))) continue;
        at_.x = std::move(x);
        now_ = std::move(tried);
        moved = true;
        break;
      }
      if (!moved) return false;
      if (Violation(now_) <= 0.9 * before && Accepts(Violation(now_), Merit(now_, at_.x))) {
        at_.multipliers.setZero();
        for (int k = 0; k < variables_; ++k) {
          if (HasLower(k)) at_.lower[k] = std::min(1e3, mu_ / (at_.x[k] - lower_[k]));
          if (HasUpper(k)) at_.upper[k] = std::min(1e3, mu_ / (upper_[k] - at_.x[k]));
        }
        KeepNearBarrier();
        EstimateMultipliers();
        return true;
      }
    }
    return false;
  }

  static double Square(double x) { return x * x; }
  static double Power(double base, double exponent) {
    return base > 0.0 ? Exp(exponent * Log(std::max(base, 1e-300))) : 0.0;
  }

  const NonlinearProgram& program_;
  const InteriorPointSettings& settings_;
  const Eigen::VectorXd &lower_, &upper_, &reach_;
  int variables_, equations_;
  NewtonSystem system_;
  NonlinearProgram::Slopes slopes_;
  NonlinearProgram::Values now_;
  PrimalDual at_;
  double mu_;
  double most_violation_ = kInfinity, small_violation_ = 0.0;
  std::vector<Corner> filter_;
};

}  // namespace

Solved Minimize(const NonlinearProgram& program, PrimalDual start, const InteriorPointSettings& settings,
                const std::function<bool(const Eigen::VectorXd& x, int iteration)>& watch) {
  return Solver(program, settings).Run(std::move(start), watch);
}

}  // namespace gaitsmith
