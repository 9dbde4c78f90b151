// SPDX-License-Identifier: MIT
#include "shell/command_line/study_options.h"

#include <algorithm>
#include <filesystem>

#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"
#include "shell/command_line/search_options.h"

namespace gaitsmith::shell {

namespace {

Result<void> CheckLabel(const std::vector<std::string>& labels, const std::string& label,
                        const char* option) {
  if (!IsLabel(label)) {
    return Fail(ErrorCode::kSyntax, option,
                "\"" + label + "\" cannot be a label: it must have no blank, comma or quote");
  }
  if (std::ranges::find(labels, label) != labels.end()) {
    return Fail(ErrorCode::kStructure, option, "\"" + label + "\" is there twice; labels must differ");
  }
  return {};
}

/// "ssga:genetic.rates=per-component"
Result<SearchSettings> ReadSearch(const std::string& label) {
  const std::string where = "--search " + label;
  std::size_t colon = std::min(label.find(':'), label.size());
  const auto algorithm = IndexOf(kAlgorithmNames, label.substr(0, colon), where);
  if (!algorithm) return std::unexpected(algorithm.error());
  SearchSettings settings;
  settings.algorithm = static_cast<Algorithm>(*algorithm);
  while (colon < label.size()) {
    const std::size_t next = std::min(label.find(':', colon + 1), label.size());
    const std::string option = label.substr(colon + 1, next - colon - 1);
    if (auto set = SetSearchOption(option, settings); !set) {
      const std::string name =
          set.error().where != "--search-option" ? option.substr(0, option.find('=')) + ": " : "";
      return Fail(set.error().code, where, name + set.error().what);
    }
    colon = next;
  }
  return settings;
}

Result<void> ReadNumbers(const Arguments& arguments, StudyPlan& plan) {
  for (const char* option : {"problem", "search", "trials", "evaluations"}) {
    if (!arguments.Has(option)) return Fail(ErrorCode::kMissing, std::string("--") + option, "must be given");
  }
  const auto trials = arguments.Integer("trials", 1, kMostTrials, 1);
  if (!trials) return std::unexpected(trials.error());
  const auto seed = arguments.Integer("first-seed", 0, 0x100000000LL - *trials, 1);
  if (!seed) return std::unexpected(seed.error());
  const auto evaluations = arguments.Integer("evaluations", 1, kMostEvaluations, 1);
  if (!evaluations) return std::unexpected(evaluations.error());
  const long long most = std::min<long long>(*evaluations, kMostPoints);
  const auto points = arguments.Integer("points", 1, most, std::min(100LL, most));
  if (!points) return std::unexpected(points.error());
  plan.trials = static_cast<int>(*trials);
  plan.first_seed = static_cast<std::uint32_t>(*seed);
  plan.evaluations = static_cast<int>(*evaluations);
  plan.points = static_cast<int>(*points);
  return {};
}

Result<void> ReadSearches(const Arguments& arguments, Study& study) {
  for (const std::string& label : arguments.All("search")) {
    auto settings = ReadSearch(label);
    if (!settings) return std::unexpected(settings.error());
    if (auto fine = CheckLabel(study.plan.searches, label, "--search"); !fine) return fine;
    settings->evaluations = study.plan.evaluations;
    study.searches.push_back(*settings);
    study.plan.searches.push_back(label);
  }
  return {};
}

/// What the options made of a problem, and every search on it.
Result<void> CheckProblem(const Study& study, std::size_t problem) {
  const std::string where = "--problem " + study.plan.problems[problem];
  const auto fault = [&](const std::string& place, const Error& error) {
    return Fail(error.code, place, error.Sentence());
  };
  if (auto valid = Validate(study.problems[problem]); !valid) return fault(where, valid.error());
  for (std::size_t s = 0; s < study.searches.size(); ++s) {
    if (auto valid = Validate(TrialDocument(study, problem, s, 1)); !valid) {
      return fault(where + " --search " + study.plan.searches[s], valid.error());
    }
  }
  return {};
}

}  // namespace

std::expected<Study, Refusal> ReadStudy(const Arguments& arguments) {
  Study study;
  if (auto read = ReadNumbers(arguments, study.plan); !read) return WrongCall(read.error());
  if (auto read = ReadSearches(arguments, study); !read) return WrongCall(read.error());
  for (const std::string& path : arguments.All("problem")) {
    const std::string label = std::filesystem::path(path).stem().string();
    if (auto fine = CheckLabel(study.plan.problems, label, "--problem"); !fine)
      return WrongCall(fine.error());
    auto document = ReadDocument(path);
    if (!document) return std::unexpected(Refusal(document.error()));
    // Before the figure loses its name, which usual weights go by.
    if (auto set = SetProblemOptions(arguments, *document); !set) return WrongCall(set.error());
    study.plan.problems.push_back(label);
    study.problems.push_back(OnlyProblem(*document));
    if (auto fine = CheckProblem(study, study.problems.size() - 1); !fine) return WrongCall(fine.error());
  }
  study.plan.fingerprint = FingerprintOf(study);
  return study;
}

}  // namespace gaitsmith::shell
