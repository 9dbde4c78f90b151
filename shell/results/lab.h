// SPDX-License-Identifier: MIT
// The lab: the paper's Figure 6 as an experiment. It decides which trial comes next, keeps the curves of
// finished trials and summarises them. LabRun runs the trials. The study and its file equal those of
// `gaitsmith compare`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "shell/study/running_time.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

inline constexpr int kMinLabTrials = 2, kMaxLabTrials = 50;
inline constexpr int kMaxLabEvaluations = 1'000'000;

/// The default choice: the benchmark, the paper's best algorithm, and a genetic algorithm.
constexpr std::array<bool, kAlgorithmNames.size()> PaperChoice() {
  std::array<bool, kAlgorithmNames.size()> choice{};
  for (const Algorithm one : {Algorithm::kRandomSearch, Algorithm::kSphc, Algorithm::kSsga})
    choice[static_cast<std::size_t>(one)] = true;
  return choice;
}

/// The choices on the panel.
struct LabSettings {
  std::array<bool, kAlgorithmNames.size()> chosen = PaperChoice();  // in the order of Algorithm
  int trials = 10;               // of each algorithm, [kMinLabTrials, kMaxLabTrials]
  int evaluations = 5000;        // of each trial, [1, kMaxLabEvaluations]
  std::uint32_t first_seed = 1;  // of the first trial; the others count up from it
};

enum class LabState { kIdle, kRunning, kDone, kStopped, kFailed };
/// As the page's scripts get them.
inline constexpr std::array<const char*, 5> kLabStateNames = {"idle", "running", "done", "stopped", "failed"};

/// Results of all finished trials of one algorithm.
struct LabSeries {
  Algorithm algorithm;
  int trials = 0;  // finished
  /// Quartiles over the trials at an evaluation count. Counts are left out if a quarter of the trials has no
  /// motion yet.
  struct Point {
    int evaluations;
    double lower_quartile, median, upper_quartile;
  };
  std::vector<Point> points;
  /// The share of trials and targets that are reached, at each evaluation count.
  struct Reached {
    int evaluations;
    double share;
  };
  std::vector<Reached> reached = {};
  /// How soon it is halfway (Lab::Halfway); nothing without a target or a trial.
  std::optional<RunningTime> to_halfway = {};
};

class Lab {
 public:
  LabSettings settings;  // settings of the next run

  /// Plans the trials of the settings and forgets the trials before. Refused, with a sentence and nothing
  /// changed, if an algorithm cannot work with the settings.
  /// @param document provides figure, task, senses and controllers of the problem
  [[nodiscard]] Result<void> Begin(const Document& document);

  [[nodiscard]] LabState State() const { return state_; }
  [[nodiscard]] bool Running() const { return state_ == LabState::kRunning; }
  /// Number of finished trials. The trials take turns: the first of every algorithm, then the second of every
  /// algorithm.
  [[nodiscard]] int Finished() const { return finished_; }
  [[nodiscard]] int Total() const { return static_cast<int>(study_.plan.Total()); }
  /// Budget of each trial.
  [[nodiscard]] int Evaluations() const { return study_.plan.evaluations; }

  struct Trial {
    Algorithm algorithm;
    std::uint32_t seed;
    Document document;  // the document of its search
  };
  /// The trial to run now. Call only while running.
  [[nodiscard]] Trial Now() const;
  /// Records the result of the trial of Now().
  void Finish(std::span<const Search::CurvePoint> curve);
  /// Ends the run; finished trials are kept.
  void End(LabState);

  /// One for each algorithm of the run, in the order of Algorithm.
  [[nodiscard]] const std::vector<LabSeries>& Series() const { return series_; }
  /// The middle one of the targets that all trials so far set (TargetsOf); nothing without a motion.
  [[nodiscard]] std::optional<double> Halfway() const;
  /// Whether a document has the problem of this run.
  [[nodiscard]] bool IsOf(const Document& document) const;
  /// The finished trials in the file format of `gaitsmith compare --curves`.
  [[nodiscard]] std::string Csv() const;
  /// The problem's label in that file.
  [[nodiscard]] std::string Label() const;

 private:
  [[nodiscard]] StudyPlan::Trial Current() const;
  void SumUp(std::size_t search);
  /// Targets move with each trial, so this is for all searches.
  void SumUpReached();

  LabState state_ = LabState::kIdle;
  Study study_;
  int finished_ = 0;
  /// The best score so far at each point of the plan, by algorithm of the run and finished trial.
  std::vector<std::vector<std::vector<float>>> samples_;
  std::vector<LabSeries> series_;
  std::vector<double> targets_;
  std::map<std::size_t, StudyFile::Rows> rows_;  // by canonical index
};

/// A file name from a document's title: its letters and digits, in lower case.
[[nodiscard]] std::string LabelOf(const std::string& title);

}  // namespace gaitsmith::shell
