// SPDX-License-Identifier: MIT
#include "shell/command_line/trial_crew.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

#include "shell/command_line/interruption.h"
#include "shell/command_line/study/study_log.h"
#include "shell/command_line/trial.h"

namespace gaitsmith::shell {

namespace {

/// Worker threads that each run one trial after another.
class TrialCrew {
 public:
  TrialCrew(const Study& study, std::vector<std::size_t> trials, std::vector<StudyLog>& logs)
      : study_(study), trials_(std::move(trials)), logs_(logs) {
    for (const StudyLog& log : logs_) tables_.push_back(log.Table());
  }

  /// Runs all trials, or until an interruption. Left() then returns the number of unfinished trials.
  [[nodiscard]] Result<void> Run(int threads) {
    std::unique_lock lock(mutex_);
    std::vector<std::jthread> workers;
    working_ = std::min(static_cast<std::size_t>(threads), trials_.size());
    workers.reserve(working_);
    for (std::size_t i = 0; i < working_; ++i) workers.emplace_back([this] { Work(); });
    while (!all_done_.wait_for(lock, std::chrono::milliseconds(250), [this] { return working_ == 0; }))
      Draw();
    Draw();
    if (terminal_) std::fputc('\n', stderr);
    if (fault_) return std::unexpected(*fault_);
    return {};
  }
  [[nodiscard]] std::size_t Left() const { return trials_.size() - finished_; }

 private:
  void Work() {
    std::unique_lock lock(mutex_);
    const auto stop = [this] { return faulty_ || Interrupted(); };
    while (next_ < trials_.size() && !stop()) {
      const std::size_t trial = trials_[next_++];
      lock.unlock();
      const auto rows = RunTrial(study_, trial, tables_, evaluations_, stop);
      lock.lock();
      if (rows && !fault_) Keep(trial, *rows);
    }
    if (--working_ == 0) all_done_.notify_all();
  }
  void Keep(std::size_t trial, const std::vector<std::string>& rows) {
    Result<void> kept;
    for (std::size_t i = 0; i < logs_.size() && kept; ++i) kept = logs_[i].Confirm(trial, rows[i]);
    // Last log first: it holds the curves, which take longest to write, and a trial is complete only when
    // every file has it.
    for (std::size_t i = logs_.size(); i-- > 0 && kept;) kept = logs_[i].Add(trial, rows[i]);
    if (kept) {
      ++finished_;
    } else {
      fault_ = kept.error();
      faulty_ = true;
    }
  }
  void Draw() const {
    if (!terminal_) return;
    const double spent_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const auto done = static_cast<double>(evaluations_);
    const double all = static_cast<double>(trials_.size()) * study_.plan.evaluations;
    std::fprintf(stderr, "\r%zu of %zu trials  %.0f/s  %.0f s left \x1b[K", finished_, trials_.size(),
                 done / spent_s, done > 0.0 ? (all - done) / done * spent_s : 0.0);
  }

  const Study& study_;
  const std::vector<std::size_t> trials_;  // canonical indices
  std::vector<StudyLog>& logs_;
  std::vector<StudyTable> tables_;  // one per log
  std::mutex mutex_;                // guards all members below except the atomics
  std::condition_variable all_done_;
  std::size_t next_ = 0, finished_ = 0, working_ = 0;
  std::optional<Error> fault_;
  std::atomic<bool> faulty_ = false;
  std::atomic<std::int64_t> evaluations_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

}  // namespace

Result<Shard> ReadShard(const Arguments& arguments) {
  const std::string text = arguments.Last("shard", "1/1");
  const auto shard = ParseShard(text);
  if (shard) return *shard;
  return Fail(ErrorCode::kOutOfRange, "--shard",
              "must be i/n with i from 1 to n, such as 2/8, is \"" + text + "\"");
}

Result<void> RunTrials(const Study& study, std::span<const StudyOutput> outputs, const Shard& shard,
                       int threads) {
  std::vector<StudyLog> logs;
  logs.reserve(outputs.size());
  for (const StudyOutput& output : outputs) {
    auto log = StudyLog::Open(output.path, study.plan, output.table, shard);
    if (!log) return std::unexpected(log.error());
    logs.push_back(std::move(*log));
  }
  for (StudyLog& log : logs) {
    if (auto begun = log.Begin(); !begun) return begun;
  }
  CatchInterruption();
  std::vector<std::size_t> trials;
  for (std::size_t i = shard.first; i < study.plan.Total(); i += shard.of) {
    if (!std::ranges::all_of(logs, [i](const StudyLog& log) { return log.Has(i); })) trials.push_back(i);
  }
  const std::size_t wanted = trials.size();
  TrialCrew crew(study, std::move(trials), logs);
  if (auto run = crew.Run(threads); !run) return run;
  if (crew.Left() > 0) {
    return Fail(ErrorCode::kTruncated, "",
                "stopped; " + std::to_string(crew.Left()) + " of " + std::to_string(wanted) +
                    " trials are left, with which the same command goes on");
  }
  for (StudyLog& log : logs) {
    if (auto finished = log.Finish(); !finished) return finished;
  }
  return {};
}

}  // namespace gaitsmith::shell
