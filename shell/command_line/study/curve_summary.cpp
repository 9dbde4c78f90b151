// SPDX-License-Identifier: MIT
// What a summary says of curves: how soon searches reach targets, and files for IOHanalyzer.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/document/json_value.h"
#include "shell/command_line/files.h"
#include "shell/command_line/study/summary.h"

namespace gaitsmith::shell {

namespace {

/// A name of files and folders: letters, digits, dots and dashes.
std::string FileName(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain || c == '.' || c == '-' ? c : '_';
  }
  return name;
}

std::string RawValue(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// The first point at which a trial has a motion's score.
std::size_t FirstScore(const Progress& curve) {
  const auto first = std::ranges::find_if(curve, [](float best) { return std::isfinite(best); });
  return static_cast<std::size_t>(first - curve.begin());
}

/// The improvements of a trial, a block of the file of data.
std::string DataOf(const Progress& curve, const StudyPlan& plan) {
  std::string text = "evaluations raw_y\n";
  for (std::size_t point = FirstScore(curve); point < curve.size(); ++point) {
    const bool improves = point == FirstScore(curve) || curve[point] > curve[point - 1];
    if (!improves && point + 1 < curve.size()) continue;  // the last one says where the trial ended
    text += std::to_string(plan.EvaluationsAt(static_cast<int>(point))) + " " +
            RawValue(static_cast<double>(curve[point])) + "\n";
  }
  return text;
}

/// What the file of a problem says of a trial.
std::string RunOf(const Progress& curve, const StudyPlan& plan) {
  const float best = curve.back();
  const auto at = std::ranges::find(curve, best) - curve.begin();
  return R"({"instance": 1, "evals": )" + std::to_string(plan.evaluations) + R"(, "best": {"evals": )" +
         std::to_string(plan.EvaluationsAt(static_cast<int>(at))) + R"(, "y": )" +
         RawValue(static_cast<double>(best)) + R"(, "x": []}})";
}

/// Writes what a search did on one problem: what there is, and the data. @param number of the problem, from 1
Result<void> WriteIohFunction(const std::string& folder, const Sample& sample, int number) {
  const std::string function = "f" + std::to_string(number), problem = FileName(sample.problem);
  const std::filesystem::path of_search = std::filesystem::path(folder) / FileName(sample.search);
  const std::string data = "data_" + function + "_" + problem;
  std::error_code fault;
  std::filesystem::create_directories(of_search / data, fault);
  if (fault) return Fail(ErrorCode::kMissing, "--ioh " + folder, "cannot be made: " + fault.message());
  std::string runs, rows;
  for (const Progress& curve : sample.curves) {
    if (!std::isfinite(curve.back())) continue;  // found no motion: there is nothing to say
    runs.append(runs.empty() ? "" : ", ").append(RunOf(curve, *sample.plan));
    rows += DataOf(curve, *sample.plan);
  }
  const std::string path = data + "/IOHprofiler_" + function + "_DIM1.dat";
  const std::string text = R"({"version": "0.3.5", "suite": "gaitsmith", "function_id": )" +
                           std::to_string(number) + R"(, "function_name": )" + QuoteJson(problem) +
                           R"(, "maximization": true, "algorithm": {"name": )" + QuoteJson(sample.search) +
                           R"(, "info": "gaitsmith compare"}, "attributes": ["evaluations", "raw_y"], )" +
                           R"("scenarios": [{"dimension": 1, "path": )" + QuoteJson(path) + R"(, "runs": [)" +
                           runs + "]}]}\n";
  if (auto written = WriteText((of_search / path).string(), rows); !written) return written;
  return WriteText((of_search / ("IOHprofiler_" + function + "_" + problem + ".json")).string(), text);
}

}  // namespace

std::string RunningTimes(const std::vector<Sample>& samples) {
  std::string times = "problem,search,target,reached,n,ert,ert_low,ert_high\n";
  std::string shares = "problem,search,evaluations,reached_share\n";
  for (const std::string& problem : ProblemsOf(samples)) {
    const std::vector<const Sample*> on_it = OnProblem(samples, problem);
    std::vector<Progress> all;
    for (const Sample* one : on_it) all.insert(all.end(), one->curves.begin(), one->curves.end());
    const std::vector<double> targets = TargetsOf(all);
    for (const Sample* one : on_it) {
      const std::string start = problem + "," + one->search + ",";
      for (const double target : targets) {
        const RunningTime time = RunningTimeTo(target, one->curves, *one->plan);
        times += SummaryLine(problem + "," + one->search,
                             {target, static_cast<double>(time.reached),
                              static_cast<double>(one->curves.size()), time.expected, time.low, time.high});
      }
      const std::vector<double> share = ShareReached(one->curves, targets);
      for (std::size_t point = 0; point < share.size(); ++point) {
        shares += SummaryLine(start + std::to_string(one->plan->EvaluationsAt(static_cast<int>(point))),
                              {share[point]});
      }
    }
  }
  return times + "\n" + shares;
}

Result<void> WriteIoh(const std::string& folder, const std::vector<Sample>& samples) {
  const std::vector<std::string> problems = ProblemsOf(samples);
  for (const Sample& one : samples) {
    const auto number = std::ranges::find(problems, one.problem) - problems.begin() + 1;
    if (auto written = WriteIohFunction(folder, one, static_cast<int>(number)); !written) return written;
  }
  return {};
}

}  // namespace gaitsmith::shell
