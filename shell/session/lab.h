// SPDX-License-Identifier: MIT
// The lab: the paper's Figure 6 as an experiment. It says which trial comes next, keeps the curves of those
// that are finished and sums them up; who runs the trials is not its concern. Its study is the one that
// `gaitsmith compare` would run, and its file the same.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "shell/study/study.h"

namespace gaitsmith::shell {

inline constexpr int kFewestLabTrials = 2, kMostLabTrials = 50;
inline constexpr int kMostLabEvaluations = 1'000'000;

/// What the lab begins with: the benchmark, the paper's best, and a genetic algorithm.
constexpr std::array<bool, kAlgorithmNames.size()> PaperChoice() {
  std::array<bool, kAlgorithmNames.size()> choice{};
  for (const Algorithm one : {Algorithm::kRandomSearch, Algorithm::kSphc, Algorithm::kSsga})
    choice[static_cast<std::size_t>(one)] = true;
  return choice;
}

/// What is chosen on the panel.
struct LabSettings {
  std::array<bool, kAlgorithmNames.size()> chosen = PaperChoice();  // in the order of Algorithm
  int trials = 10;               // of each algorithm, [kFewestLabTrials, kMostLabTrials]
  int evaluations = 5000;        // of each trial, [1, kMostLabEvaluations]
  std::uint32_t first_seed = 1;  // the other trials' seeds follow
};

enum class LabState { kIdle, kRunning, kDone, kStopped, kFailed };

/// All finished trials of one algorithm.
struct LabSeries {
  Algorithm algorithm;
  int trials = 0;  // finished
  /// Over the trials, after so many evaluations. Left out: counts after which a quarter of them have no
  /// motion.
  struct Point {
    int evaluations;
    double lower_quartile, median, upper_quartile;
  };
  std::vector<Point> points;
};

class Lab {
 public:
  LabSettings settings;  // of the next run

  /// Plans the trials that the settings ask for and forgets those before. Refused, with a sentence and
  /// nothing changed: settings that an algorithm cannot work with.
  /// @param document figure, task, senses and controllers of the problem are taken from it
  [[nodiscard]] Result<void> Begin(const Document& document);

  [[nodiscard]] LabState State() const { return state_; }
  [[nodiscard]] bool Running() const { return state_ == LabState::kRunning; }
  /// Trials finished, and all. By turns: the first of every algorithm, then the second of every one.
  [[nodiscard]] int Finished() const { return finished_; }
  [[nodiscard]] int Total() const { return static_cast<int>(study_.plan.Total()); }
  /// Of each trial.
  [[nodiscard]] int Evaluations() const { return study_.plan.evaluations; }

  struct Trial {
    Algorithm algorithm;
    std::uint32_t seed;
    Document document;  // whose search it is
  };
  /// The trial to run now. Only while running.
  [[nodiscard]] Trial Now() const;
  /// That trial is finished.
  void Finish(std::span<const Search::CurvePoint> curve);
  /// Ends the run; what is finished stays.
  void End(LabState);

  /// One for each algorithm of the run, in the order of Algorithm.
  [[nodiscard]] const std::vector<LabSeries>& Series() const { return series_; }
  /// Whether another document asks for the problem of this run.
  [[nodiscard]] bool IsOf(const Document& document) const;
  /// The file that `gaitsmith compare --curves` writes, of the trials finished so far.
  [[nodiscard]] std::string Csv() const;
  /// The label of the problem in that file.
  [[nodiscard]] std::string Label() const;

 private:
  [[nodiscard]] StudyPlan::Trial Current() const;
  void SumUp(std::size_t search);

  LabState state_ = LabState::kIdle;
  Study study_;
  int finished_ = 0;
  /// For each algorithm of the run and each of its finished trials: the best so far at each of the plan's
  /// points.
  std::vector<std::vector<std::vector<float>>> samples_;
  std::vector<LabSeries> series_;
  std::map<std::size_t, StudyFile::Rows> rows_;  // by canonical index
};

/// What a document's file would be called: letters and digits of its title, in small letters.
[[nodiscard]] std::string LabelOf(const std::string& title);

}  // namespace gaitsmith::shell
