// SPDX-License-Identifier: MIT
#include "core/spacetime/interior_point.h"

#include <catch_amalgamated.hpp>
#include <limits>

namespace gaitsmith::test {

namespace {

using Catch::Matchers::WithinAbs;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Problem 71 of [Hock 1981]: x0 x3 (x0 + x1 + x2) + x2 is least, where the product of all is at least 25 and
/// the sum of their squares 40. A fifth variable is the product.
class Problem71 final : public NonlinearProgram {
 public:
  Problem71() {
    lower_ << 1, 1, 1, 1, 25;
    upper_ << 5, 5, 5, 5, kUnbounded;
    reach_.setConstant(5, kUnbounded);
  }
  [[nodiscard]] int Variables() const override { return 5; }
  [[nodiscard]] int Equations() const override { return 2; }
  [[nodiscard]] const Eigen::VectorXd& Lower() const override { return lower_; }
  [[nodiscard]] const Eigen::VectorXd& Upper() const override { return upper_; }
  [[nodiscard]] const Eigen::VectorXd& Reach() const override { return reach_; }
  [[nodiscard]] Values ValuesAt(const Eigen::VectorXd& x) const override {
    Values values{x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], Eigen::VectorXd(2)};
    values.equations << x[0] * x[1] * x[2] * x[3] - x[4], x.head(4).squaredNorm() - 40.0;
    return values;
  }
  void SlopesAt(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Slopes& out) const override {
    out.gradient = Eigen::VectorXd::Zero(5);
    out.gradient.head(4) << x[3] * (2 * x[0] + x[1] + x[2]), x[0] * x[3], x[0] * x[3] + 1,
        x[0] * (x[0] + x[1] + x[2]);
    out.jacobian.Clear();
    out.hessian.Clear();
    const double all = x[0] * x[1] * x[2] * x[3];
    Eigen::Matrix4d bend = Eigen::Matrix4d::Zero();
    bend(0, 0) = 2 * x[3];
    bend(1, 0) = bend(2, 0) = x[3];
    bend(3, 0) = 2 * x[0] + x[1] + x[2];
    bend(3, 1) = bend(3, 2) = x[0];
    for (int i = 0; i < 4; ++i) {
      out.jacobian.Add(0, i, all / x[i]);
      out.jacobian.Add(1, i, 2 * x[i]);
      for (int j = 0; j <= i; ++j)
        out.hessian.Add(i, j, bend(i, j) + (i == j ? 2 * y[1] : y[0] * all / (x[i] * x[j])));
    }
    out.jacobian.Add(0, 4, -1.0);
  }

 private:
  Eigen::VectorXd lower_{5}, upper_{5}, reach_;
};

PrimalDual StartOf71() {
  PrimalDual start;
  start.x.resize(5);
  start.x << 1, 5, 5, 1, 25;
  return start;
}

/// A circle and a line; they meet if the line is near enough.
class CircleAndLine final : public NonlinearProgram {
 public:
  explicit CircleAndLine(double height)
      : height_(height), free_(Eigen::VectorXd::Constant(2, kUnbounded)), least_(-free_) {}
  [[nodiscard]] int Variables() const override { return 2; }
  [[nodiscard]] int Equations() const override { return 2; }
  [[nodiscard]] const Eigen::VectorXd& Lower() const override { return least_; }
  [[nodiscard]] const Eigen::VectorXd& Upper() const override { return free_; }
  [[nodiscard]] const Eigen::VectorXd& Reach() const override { return free_; }
  [[nodiscard]] Values ValuesAt(const Eigen::VectorXd& x) const override {
    Values values{x[0], Eigen::VectorXd(2)};
    values.equations << x.squaredNorm() - 1.0, x[1] - height_;
    return values;
  }
  void SlopesAt(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Slopes& out) const override {
    out.gradient = Eigen::Vector2d(1.0, 0.0);
    out.jacobian.Clear();
    out.hessian.Clear();
    for (int i = 0; i < 2; ++i) {
      out.jacobian.Add(0, i, 2 * x[i]);
      out.hessian.Add(i, i, 2 * y[0]);
    }
    out.jacobian.Add(1, 1, 1.0);
  }

 private:
  double height_;
  Eigen::VectorXd free_, least_;
};

}  // namespace

TEST_CASE("the interior-point method solves a problem with a known solution", "[spacetime]") {
  const Solved solved = Minimize(Problem71(), StartOf71(), {});
  CHECK(solved.end == SolveEnd::kSolved);
  CHECK(solved.iterations < 30);
  CHECK_THAT(solved.objective, WithinAbs(17.0140173, 1e-5));
  CHECK_THAT(solved.at.x[1], WithinAbs(4.7429994, 1e-4));
  CHECK_THAT(solved.at.x[2], WithinAbs(3.8211503, 1e-4));
  CHECK_THAT(solved.at.x[3], WithinAbs(1.3794082, 1e-4));
  CHECK(solved.violation < 1e-6);
}

TEST_CASE("equations that cannot be met are not called solved", "[spacetime]") {
  PrimalDual start;
  start.x.resize(2);
  start.x << 0.3, 0.2;
  const Solved apart = Minimize(CircleAndLine(1.5), start, {});
  CHECK(apart.end != SolveEnd::kSolved);
  CHECK(apart.violation > 0.1);
  const Solved meeting = Minimize(CircleAndLine(0.6), start, {});
  CHECK(meeting.end == SolveEnd::kSolved);
  CHECK_THAT(std::abs(meeting.at.x[0]), WithinAbs(0.8, 1e-6));
}

TEST_CASE("who watches the method can stop it", "[spacetime]") {
  int seen = 0;
  const Solved solved = Minimize(Problem71(), StartOf71(), {}, [&](const Eigen::VectorXd&, int iteration) {
    seen = iteration;
    return iteration < 3;
  });
  CHECK(solved.end == SolveEnd::kCancelled);
  CHECK(seen == 3);
}

}  // namespace gaitsmith::test
