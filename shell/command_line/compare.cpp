// SPDX-License-Identifier: MIT
// gaitsmith compare: tries searches on problems, each with many seeds, and writes what every trial found and
// how it came there (Figure 6 of the paper).
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <thread>

#include "shell/command_line/interruption.h"
#include "shell/command_line/study_log.h"
#include "shell/command_line/study_options.h"
#include "shell/command_line/trial.h"
#include "shell/parallel_search.h"

namespace gaitsmith::shell {

namespace {

/// Threads that take one trial after another.
class TrialCrew {
 public:
  TrialCrew(const Study& study, std::vector<std::size_t> trials, StudyLog& results, StudyLog& curves)
      : study_(study), trials_(std::move(trials)), results_(results), curves_(curves) {}

  /// Runs all trials, or those that finish before an interruption; afterwards Left() says how many did not.
  [[nodiscard]] Result<void> Run(int threads) {
    std::unique_lock lock(mutex_);
    std::vector<std::jthread> workers;
    working_ = std::min(static_cast<std::size_t>(threads), trials_.size());
    workers.reserve(working_);
    for (std::size_t i = 0; i < working_; ++i) workers.emplace_back([this] { Work(); });
    while (!left_off_.wait_for(lock, std::chrono::milliseconds(250), [this] { return working_ == 0; }))
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
      const auto rows = RunTrial(study_, trial, evaluations_, stop);
      lock.lock();
      if (rows && !fault_) Keep(trial, *rows);
    }
    if (--working_ == 0) left_off_.notify_all();
  }
  void Keep(std::size_t trial, const TrialRows& rows) {
    auto kept = results_.Confirm(trial, rows.result);
    if (kept) kept = curves_.Confirm(trial, rows.curve);
    // The curve first, for it takes longer to write: a trial counts when both files have it.
    if (kept) kept = curves_.Add(trial, rows.curve);
    if (kept) kept = results_.Add(trial, rows.result);
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
  StudyLog& results_;
  StudyLog& curves_;
  std::mutex mutex_;  // of all below but the atomics
  std::condition_variable left_off_;
  std::size_t next_ = 0, finished_ = 0, working_ = 0;
  std::optional<Error> fault_;
  std::atomic<bool> faulty_ = false;
  std::atomic<std::int64_t> evaluations_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

struct Shard {
  std::size_t first = 0, of = 1;  // every of-th trial, from the first on
};

/// "2/8", from 1/n to n/n.
Result<Shard> ReadShard(const std::string& text) {
  const auto whole = [](std::string_view word, std::size_t& value) {
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    return fault == std::errc{} && end == word.data() + word.size();
  };
  const std::size_t slash = std::min(text.find('/'), text.size());
  std::size_t number = 0, of = 0;
  if (slash == text.size() || !whole(std::string_view(text).substr(0, slash), number) ||
      !whole(std::string_view(text).substr(slash + 1), of) || number < 1 || number > of) {
    return Fail(ErrorCode::kOutOfRange, "--shard",
                "must be i/n with i from 1 to n, such as 2/8, is \"" + text + "\"");
  }
  return Shard{.first = number - 1, .of = of};
}

/// Both outputs must be files, and neither may be the other, nor the other's file of the moment before it is
/// renamed.
Result<void> CheckPaths(const std::string& out, const std::string& curves) {
  const auto canonical = [](const std::string& path) {
    std::error_code fault;
    const auto found = std::filesystem::weakly_canonical(path, fault);
    return fault ? path : found.string();
  };
  if (out == "-" || curves == "-") {
    return Fail(ErrorCode::kStructure, out == "-" ? "--out" : "--curves",
                "must be a file, for finished trials are kept there");
  }
  std::error_code ignored;
  const std::string one = canonical(out), other = canonical(curves);
  if (one != other && one + ".part" != other && other + ".part" != one &&
      !std::filesystem::equivalent(out, curves, ignored)) {
    return {};
  }
  return Fail(ErrorCode::kStructure, "--curves", "must be another file than --out");
}

}  // namespace

Outcome CompareCommand(Words words) {
  static constexpr std::string_view kOptions[] = {
      "problem", "search",   "trials", "first-seed", "evaluations", "points", "controller", "sense",
      "weight",  "duration", "shard",  "threads",    "out",         "curves", "summary"};
  const auto arguments = Arguments::ParseOptions(words, kOptions);
  if (!arguments) return WrongCall(arguments.error());
  if (arguments->Has("summary")) {
    if (words.size() <= 2) return Summarize(arguments->Last("summary"));
    return WrongCall({ErrorCode::kStructure, "--summary", "goes with no other option"});
  }
  for (const char* option : {"out", "curves"}) {
    if (arguments->Last(option).empty()) {
      return WrongCall({ErrorCode::kMissing, std::string("--") + option, "say which file keeps the rows"});
    }
  }
  const std::string out = arguments->Last("out"), curves_path = arguments->Last("curves");
  if (auto fine = CheckPaths(out, curves_path); !fine) return WrongCall(fine.error());
  const auto shard = ReadShard(arguments->Last("shard", "1/1"));
  if (!shard) return WrongCall(shard.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  const auto study = ReadStudy(*arguments);
  if (!study) return std::unexpected(study.error());

  auto results = StudyLog::Open(out, study->plan, StudyTable::kResults);
  if (!results) return std::unexpected(results.error());
  auto curves = StudyLog::Open(curves_path, study->plan, StudyTable::kCurves);
  if (!curves) return std::unexpected(curves.error());
  for (StudyLog* log : {&*results, &*curves}) {
    if (auto begun = log->Begin(); !begun) return std::unexpected(begun.error());
  }
  CatchInterruption();
  std::vector<std::size_t> trials;
  for (std::size_t i = shard->first; i < study->plan.Total(); i += shard->of) {
    if (!results->Has(i) || !curves->Has(i)) trials.push_back(i);
  }
  const std::size_t wanted = trials.size();
  TrialCrew crew(*study, std::move(trials), *results, *curves);
  if (auto run = crew.Run(static_cast<int>(*threads)); !run) return std::unexpected(run.error());
  if (crew.Left() > 0) {
    return Fail(ErrorCode::kTruncated, "",
                "stopped; " + std::to_string(crew.Left()) + " of " + std::to_string(wanted) +
                    " trials are left, with which the same command goes on");
  }
  for (StudyLog* log : {&*results, &*curves}) {
    if (auto finished = log->Finish(); !finished) return std::unexpected(finished.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
