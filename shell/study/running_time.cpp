// SPDX-License-Identifier: MIT
#include "shell/study/running_time.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/numeric/random.h"
#include "core/search/search.h"
#include "shell/study/rank_test.h"

namespace gaitsmith::shell {

namespace {

constexpr int kResamples = 1000;

/// Evaluations that a trial took.
struct Run {
  double evaluations;
  bool reached;
};

/// The first point at which a trial has a score, or the number of points.
std::size_t PointOf(const Progress& trial, double target) {
  const auto at =
      std::ranges::find_if(trial, [&](float best) { return static_cast<double>(best) >= target; });
  return static_cast<std::size_t>(at - trial.begin());
}

/// A number as tables print it, or the one before if that is above the number: a target that is read from a
/// table must not be missed by the trial that set it.
double InSixDigits(double value) {
  const auto printed = [](const char* format, double number) {
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    return std::string(text);
  };
  const auto number = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
  const double near = number(printed("%.6g", value));
  if (!(near > value)) return near;
  const std::string text = printed("%.17e", value);
  const int exponent = std::atoi(text.c_str() + text.find('e') + 1);
  return number(printed("%.6g", near - number("1e" + std::to_string(exponent - 5))));
}

double Expected(double evaluations, int reached) {
  return reached > 0 ? evaluations / reached : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> TargetsOf(std::span<const Progress> trials, int count) {
  std::vector<double> first;
  double best = static_cast<double>(kNoMotion);
  for (const Progress& trial : trials) {
    if (trial.empty()) continue;
    best = std::max(best, static_cast<double>(trial.back()));
    const auto motion = std::ranges::find_if(trial, [](float score) { return score > kNoMotion; });
    if (motion != trial.end()) first.push_back(static_cast<double>(*motion));
  }
  if (first.empty()) return {};
  const double least = Quantile(first, 0.5);
  if (!(least < best)) return {InSixDigits(best)};
  std::vector<double> targets;
  targets.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i < count; ++i) targets.push_back(InSixDigits(least + (best - least) * i / count));
  targets.push_back(InSixDigits(best));
  return targets;
}

std::vector<double> ShareReached(std::span<const Progress> trials, std::span<const double> targets) {
  const std::size_t points = trials.empty() ? 0 : trials[0].size();
  std::vector<double> share(points, 0.0);
  for (const Progress& trial : trials) {
    for (const double target : targets) {
      for (std::size_t point = PointOf(trial, target); point < points; ++point) share[point] += 1.0;
    }
  }
  const double pairs = static_cast<double>(trials.size()) * static_cast<double>(targets.size());
  for (double& one : share) one = pairs > 0.0 ? one / pairs : 0.0;
  return share;
}

RunningTime RunningTimeTo(double target, std::span<const Progress> trials, const StudyPlan& plan) {
  std::vector<Run> runs;
  runs.reserve(trials.size());
  double evaluations = 0.0;
  int reached = 0;
  for (const Progress& trial : trials) {
    const std::size_t point = PointOf(trial, target);
    const bool reaches = point < trial.size();
    runs.push_back(
        {static_cast<double>(reaches ? plan.EvaluationsAt(static_cast<int>(point)) : plan.evaluations),
         reaches});
    evaluations += runs.back().evaluations;
    reached += reaches ? 1 : 0;
  }
  std::vector<double> resampled;
  resampled.reserve(kResamples);
  for (std::uint64_t sample = 0; sample < kResamples; ++sample) {
    RandomStream random(1, sample, runs.size());
    double sum = 0.0;
    int hits = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const Run& run = runs[random.Below(static_cast<std::uint32_t>(runs.size()))];
      sum += run.evaluations;
      hits += run.reached ? 1 : 0;
    }
    resampled.push_back(Expected(sum, hits));
  }
  std::ranges::sort(resampled);
  // Not interpolated, because some may be infinite.
  const auto at = [&](double share) { return resampled[static_cast<std::size_t>(share * (kResamples - 1))]; };
  return {reached, Expected(evaluations, reached), at(0.025), at(0.975)};
}

}  // namespace gaitsmith::shell
