// SPDX-License-Identifier: MIT
#include "shell/command_line/study/study_options.h"

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

/// Parses a label such as "ssga:genetic.rates=per-component".
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

/// Checks a problem, as changed by the options, with every search.
Result<void> CheckProblem(const Study& study, std::size_t problem, const char* option) {
  const std::string where = std::string(option) + " " + study.plan.problems[problem];
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

Result<void> ReadSeeds(const Arguments& arguments, const char* seeds, StudyPlan& plan) {
  for (const char* option : {"search", seeds, "evaluations"}) {
    if (!arguments.Has(option)) return Fail(ErrorCode::kMissing, std::string("--") + option, "must be given");
  }
  const auto trials = arguments.Integer(seeds, 1, kMaxTrials, 1);
  if (!trials) return std::unexpected(trials.error());
  const auto seed = arguments.Integer("first-seed", 0, 0x100000000LL - *trials, 1);
  if (!seed) return std::unexpected(seed.error());
  const auto evaluations = arguments.Integer("evaluations", 1, kMaxEvaluations, 1);
  if (!evaluations) return std::unexpected(evaluations.error());
  plan.trials = static_cast<int>(*trials);
  plan.first_seed = static_cast<std::uint32_t>(*seed);
  plan.evaluations = static_cast<int>(*evaluations);
  return {};
}

Result<void> AddSearch(const std::string& label, Study& study) {
  auto settings = ReadSearch(label);
  if (!settings) return std::unexpected(settings.error());
  if (auto fine = CheckLabel(study.plan.searches, label, "--search"); !fine) return fine;
  settings->evaluations = study.plan.evaluations;
  study.searches.push_back(*settings);
  study.plan.searches.push_back(label);
  return {};
}

Result<void> AddProblem(const std::string& label, Document problem, const char* option, Study& study) {
  if (auto fine = CheckLabel(study.plan.problems, label, option); !fine) return fine;
  study.plan.problems.push_back(label);
  study.problems.push_back(std::move(problem));
  return CheckProblem(study, study.problems.size() - 1, option);
}

std::expected<Study, Refusal> ReadStudy(const Arguments& arguments) {
  Study study;
  if (!arguments.Has("problem")) return WrongCall({ErrorCode::kMissing, "--problem", "must be given"});
  if (auto read = ReadSeeds(arguments, "trials", study.plan); !read) return WrongCall(read.error());
  const long long most = std::min<long long>(study.plan.evaluations, kMaxPoints);
  const auto points = arguments.Integer("points", 1, most, std::min(100LL, most));
  if (!points) return WrongCall(points.error());
  study.plan.points = static_cast<int>(*points);
  for (const std::string& label : arguments.All("search")) {
    if (auto added = AddSearch(label, study); !added) return WrongCall(added.error());
  }
  for (const std::string& path : arguments.All("problem")) {
    const std::string label = std::filesystem::path(path).stem().string();
    auto document = ReadDocument(path);
    if (!document) return std::unexpected(Refusal(document.error()));
    // Must precede removing the figure's name, which the usual weights depend on.
    if (auto set = SetProblemOptions(arguments, *document); !set) return WrongCall(set.error());
    if (auto added = AddProblem(label, OnlyProblem(*document), "--problem", study); !added) {
      return WrongCall(added.error());
    }
  }
  study.plan.fingerprint = FingerprintOf(study);
  return study;
}

}  // namespace gaitsmith::shell
