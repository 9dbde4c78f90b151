// SPDX-License-Identifier: MIT
#include "core/numeric/scalar_math.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "core/numeric/random.h"
#include "core/physics/trajectory_hash.h"

namespace gaitsmith {

TEST_CASE("sine and cosine: within 1.2e-7 of the truth up to 8192 rad", "[numeric]") {
  double worst = 0.0;
  RandomStream random(3, 0, 0);
  for (int i = 0; i < 400000; ++i) {
    const double range = i % 2 == 0 ? 3.2 : 8192.0;
    const auto x = static_cast<float>((2.0 * random.Uniform() - 1.0) * range);
    const SineCosine ours = SinCos(x);
    worst = std::max({worst, std::abs(static_cast<double>(ours.sine) - std::sin(static_cast<double>(x))),
                      std::abs(static_cast<double>(ours.cosine) - std::cos(static_cast<double>(x)))});
  }
  CAPTURE(worst);
  REQUIRE(worst < 1.2e-7);
}

TEST_CASE("turn: a direction turned by up to 0.5 rad, within 2e-7", "[numeric]") {
  using L = Lane<1>;
  double worst = 0.0;
  for (int i = -5000; i <= 5000; ++i) {
    const float angle = static_cast<float>(i) * 1e-4f;
    L::F sine = L::Splat(0.6f), cosine = L::Splat(0.8f);
    Turn<1>(L::Splat(angle), sine, cosine);
    const double s = std::sin(static_cast<double>(angle)), c = std::cos(static_cast<double>(angle));
    const double from_s = static_cast<double>(0.6f), from_c = static_cast<double>(0.8f);
    worst = std::max(worst, std::abs(static_cast<double>(sine[0]) - (from_s * c + from_c * s)));
    worst = std::max(worst, std::abs(static_cast<double>(cosine[0]) - (from_c * c - from_s * s)));
  }
  CAPTURE(worst);
  REQUIRE(worst < 2e-7);
}

TEST_CASE("sine and cosine: odd and even to the bit", "[numeric]") {
  for (float x = 0.013f; x < 50.0f; x += 0.37f) {
    REQUIRE(SinCos(-x).sine == -SinCos(x).sine);
    REQUIRE(SinCos(-x).cosine == SinCos(x).cosine);
  }
}

TEST_CASE("sine and cosine: harmless on numbers that have none", "[numeric]") {
  for (const float x :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e30f}) {
    static_cast<void>(SinCos(x));
  }
  SUCCEED();
}

TEST_CASE("exp: relative error below 1e-15", "[numeric]") {
  double worst = 0.0;
  for (double x = -699.5; x < 700.0; x += 0.0137)
    worst = std::max(worst, std::abs(Exp(x) / std::exp(x) - 1.0));
  CAPTURE(worst);
  REQUIRE(worst < 1e-15);
  REQUIRE(Exp(-1e9) == 0.0);
  REQUIRE(Exp(-700.0) == 0.0);
  REQUIRE(Exp(-699.9) > 0.0);
  REQUIRE(Exp(699.9) < Exp(700.0));
  REQUIRE(Exp(700.1) == Exp(700.0));
  REQUIRE(Exp(1e9) == Exp(700.0));
  REQUIRE(Exp(std::numeric_limits<double>::quiet_NaN()) == 0.0);
  REQUIRE(Exp(0.0) == 1.0);
}

TEST_CASE("log: absolute error below 1e-14 for ordinary ratios, relative below 1e-14 elsewhere",
          "[numeric]") {
  for (double x = 1e-3; x < 1e4; x *= 1.0037) REQUIRE(std::abs(Log(x) - std::log(x)) < 1e-14);
  for (double x = 1e-300; x < 1e300; x *= 17.3) REQUIRE(std::abs(Log(x) / std::log(x) - 1.0) < 1e-14);
  REQUIRE(Log(1.0) == 0.0);
}

TEST_CASE("sine, exp, log: the same bits for ever", "[numeric][golden]") {
  TrajectoryHash sines, exps, logs;
  RandomStream random(7, 0, 0);
  for (int i = 0; i < 100000; ++i) {
    const double x = 40.0 * (random.Uniform() - 0.5);
    const SineCosine turned = SinCos(static_cast<float>(x));
    sines.Add(turned.sine);
    sines.Add(turned.cosine);
    exps.Add(Exp(x));
    logs.Add(Log(random.Uniform() + 1e-300));
  }
  CHECK(sines.Value() == 0x102384cf0cffc8aa);
  CHECK(exps.Value() == 0xef53909b4c26db6c);
  CHECK(logs.Value() == 0xb3d066ade540e557);
}

TEST_CASE("random stream: a function of its key alone", "[numeric]") {
  RandomStream a(7, 3, 11), b(7, 3, 11), other(7, 11, 3);
  for (int i = 0; i < 100; ++i) {
    const auto value = a.Next();
    REQUIRE(value == b.Next());
    REQUIRE(value != other.Next());
  }
  // These numbers must never change: every shared search starts from them.
  RandomStream pinned(1, 2, 3);
  REQUIRE(pinned.Next() == 0x214d4c07ecfeaac5ULL);
}

TEST_CASE("random stream: its distributions have their moments", "[numeric]") {
  RandomStream random(9, 0, 0);
  constexpr int kDraws = 200000;
  double sum = 0.0, squares = 0.0;
  int counts[7] = {};
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.Normal();
    sum += z;
    squares += z * z;
    ++counts[random.Below(7)];
  }
  // Five standard errors.
  REQUIRE(std::abs(sum / kDraws) < 5.0 / std::sqrt(kDraws));
  REQUIRE(std::abs(squares / kDraws - 1.0) < 5.0 * std::sqrt(2.0 / kDraws));
  for (const int count : counts) REQUIRE(std::abs(count - kDraws / 7.0) < 5.0 * std::sqrt(kDraws / 7.0));
}

TEST_CASE("Atan2 is the angle of a direction", "[core][numeric]") {
  double worst = 0.0;
  for (int i = -20000; i <= 20000; ++i) {
    const double angle = 3.1415926 * i / 20000.0;
    for (const double length : {1.0, 1e-6, 1e6}) {
      const auto sine = static_cast<float>(length * std::sin(angle)),
                 cosine = static_cast<float>(length * std::cos(angle));
      const double exact = std::atan2(static_cast<double>(sine), static_cast<double>(cosine));
      worst = std::max(worst, std::abs(static_cast<double>(Atan2(sine, cosine)) - exact));
    }
  }
  CHECK(worst < 5e-7);
  CHECK(Atan2(0.0f, 0.0f) == 0.0f);
  CHECK(Atan2(0.0f, 1.0f) == 0.0f);
}

}  // namespace gaitsmith
