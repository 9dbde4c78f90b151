// SPDX-License-Identifier: MIT
// Comparisons of searches, with the rows of `gaitsmith compare`, and the statistics that judge them.
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "shell/command_line/study/study_options.h"
#include "shell/command_line/trial.h"
#include "shell/python/bindings.h"
#include "shell/python/fault.h"
#include "shell/study/rank_test.h"

namespace gaitsmith::python {

namespace py = pybind11;

namespace {

using shell::StudyTable;
constexpr StudyTable kTables[] = {StudyTable::kResults, StudyTable::kCurves};

/// Runs all trials, several at a time.
/// @return the rows of each trial, in canonical order; fewer after a stop
std::vector<std::vector<std::string>> RunAll(const shell::Study& study, int threads, SignalWatch& watch) {
  std::vector<std::vector<std::string>> rows(study.plan.Total());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::int64_t> evaluations = 0;
  std::atomic<bool> stopped = false;
  std::mutex mutex;
  std::condition_variable all_done;
  std::size_t working = std::min(static_cast<std::size_t>(threads), rows.size());
  std::vector<std::jthread> crew;
  for (std::size_t i = working; i > 0; --i) {
    crew.emplace_back([&] {
      for (std::size_t trial = next++; trial < rows.size() && !stopped; trial = next++) {
        auto found = shell::RunTrial(study, trial, kTables, evaluations, [&] { return stopped.load(); });
        if (found) rows[trial] = std::move(*found);
      }
      const std::lock_guard lock(mutex);
      if (--working == 0) all_done.notify_all();
    });
  }
  std::unique_lock lock(mutex);
  while (!all_done.wait_for(lock, std::chrono::milliseconds(100), [&] { return working == 0; })) {
    lock.unlock();
    if (watch()) stopped = true;
    lock.lock();
  }
  return rows;
}

/// @return the texts of both files, as `gaitsmith compare` writes them
py::tuple Compare(const std::vector<std::pair<std::string, std::string>>& problems,
                  const std::vector<std::string>& searches, long long trials, long long evaluations,
                  long long first_seed, std::optional<long long> points, long long threads) {
  shell::Study study;
  if (problems.empty()) throw Fault("problems: must have at least one");
  if (searches.empty()) throw Fault("searches: must have at least one");
  study.plan.trials = InRange("trials", trials, 1, shell::kMaxTrials);
  study.plan.evaluations = InRange("evaluations", evaluations, 1, shell::kMaxEvaluations);
  if (first_seed < 0 || first_seed + trials > 0x100000000LL)
    throw Fault("first_seed: must be from 0, with all seeds below 4294967296, is " +
                std::to_string(first_seed));
  study.plan.first_seed = static_cast<std::uint32_t>(first_seed);
  const long long most = std::min<long long>(evaluations, shell::kMaxPoints);
  study.plan.points = InRange("points", points.value_or(std::min(100LL, most)), 1, most);
  const int crew = InRange("threads", threads, 1, 256);
  for (const std::string& label : searches) Take(shell::AddSearch(label, study));
  for (const auto& [label, json] : problems)
    Take(shell::AddProblem(label, shell::OnlyProblem(DocumentOf(json)), "problems", study));
  study.plan.fingerprint = shell::FingerprintOf(study);
  SignalWatch watch;
  std::string texts[] = {shell::Heading(study.plan, kTables[0]), shell::Heading(study.plan, kTables[1])};
  {
    const py::gil_scoped_release released;
    for (const auto& rows : RunAll(study, crew, watch)) {
      for (std::size_t i = 0; i < rows.size(); ++i) texts[i] += rows[i];
    }
  }
  watch.ThrowIfStopped();
  return py::make_tuple(texts[0], texts[1]);
}

void CheckSample(const char* name, const std::vector<double>& sample) {
  if (sample.empty()) throw Fault(std::string(name) + ": must not be empty");
  for (const double value : sample) {
    if (value != value) throw Fault(std::string(name) + ": must not contain NaN");
  }
}

}  // namespace

void AddStudyFunctions(py::module_& core) {
  core.def("compare", &Compare);
  core.def("compare_ranks", [](const std::vector<double>& first, const std::vector<double>& second) {
    CheckSample("first", first);
    CheckSample("second", second);
    const auto [u, a12, p] = shell::CompareRanks(first, second);
    return py::make_tuple(u, a12, p);
  });
  core.def("holm_adjusted", [](const std::vector<double>& p) { return shell::HolmAdjusted(p); });
  core.def("cores", [] { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); });
}

}  // namespace gaitsmith::python
