// SPDX-License-Identifier: MIT
#include "shell/results/lab.h"

#include <algorithm>

#include "core/document/binary.h"
#include "shell/study/rank_test.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

namespace {

constexpr int kPoints = 100;  // the default of `compare --points`

/// The study of these settings, or the first error in them.
Result<Study> StudyOf(const LabSettings& settings, const Document& document) {
  if (settings.trials < kMinLabTrials || settings.trials > kMaxLabTrials) {
    return Fail(ErrorCode::kOutOfRange, "trials",
                "must be from " + std::to_string(kMinLabTrials) + " to " + std::to_string(kMaxLabTrials));
  }
  if (settings.evaluations < 1 || settings.evaluations > kMaxLabEvaluations) {
    return Fail(ErrorCode::kOutOfRange, "evaluations",
                "must be from 1 to " + std::to_string(kMaxLabEvaluations));
  }
  if (settings.first_seed > 0xffffffffu - static_cast<std::uint32_t>(settings.trials - 1)) {
    return Fail(ErrorCode::kOutOfRange, "firstSeed", TrLater("leaves too few seeds for these trials"));
  }
  Study study{.plan = {.fingerprint = {},
                       .first_seed = settings.first_seed,
                       .trials = settings.trials,
                       .evaluations = settings.evaluations,
                       .points = std::min(kPoints, settings.evaluations),
                       .problems = {LabelOf(document.title)},
                       .searches = {}},
              .problems = {OnlyProblem(document)},
              .searches = {}};
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    if (!settings.chosen[i]) continue;
    SearchSettings search;
    search.algorithm = static_cast<Algorithm>(i);
    search.evaluations = settings.evaluations;
    study.plan.searches.emplace_back(kAlgorithmNames[i]);
    study.searches.push_back(search);
    const auto valid = Validate(TrialDocument(study, 0, study.searches.size() - 1, settings.first_seed));
    if (!valid) {
      const std::string& where = valid.error().where;
      return Fail(valid.error().code, std::string(kAlgorithmNames[i]) + (where.empty() ? "" : ": ") + where,
                  valid.error().what);
    }
  }
  if (study.searches.empty()) return Fail(ErrorCode::kMissing, "", TrLater("choose at least one algorithm"));
  study.plan.fingerprint = FingerprintOf(study);
  return study;
}

}  // namespace

std::string LabelOf(const std::string& title) {
  std::string label;
  bool gap = false;
  for (const char c : title) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (!capital && (c < 'a' || c > 'z') && (c < '0' || c > '9')) {
      gap = true;
      continue;
    }
    if (gap && !label.empty()) label += '-';
    gap = false;
    label += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return label.empty() ? "gaitsmith" : label;
}

Result<void> Lab::Begin(const Document& document) {
  auto study = StudyOf(settings, document);
  if (!study) return std::unexpected(study.error());
  study_ = std::move(*study);
  state_ = LabState::kRunning;
  finished_ = 0;
  samples_.assign(study_.searches.size(), {});
  series_.clear();
  targets_.clear();
  for (const SearchSettings& search : study_.searches)
    series_.push_back({.algorithm = search.algorithm, .points = {}});
  rows_.clear();
  return {};
}

StudyPlan::Trial Lab::Current() const {
  const std::size_t searches = study_.searches.size();
  const auto next = static_cast<std::size_t>(finished_);
  return {0, next % searches, study_.plan.first_seed + static_cast<std::uint32_t>(next / searches)};
}

Lab::Trial Lab::Now() const {
  const auto [problem, search, seed] = Current();
  return {study_.searches[search].algorithm, seed, TrialDocument(study_, problem, search, seed)};
}

void Lab::Finish(std::span<const Search::CurvePoint> curve) {
  const auto [problem, search, seed] = Current();
  const StudyPlan& plan = study_.plan;
  const std::size_t index = *plan.Find(plan.problems[problem], plan.searches[search], seed);
  const TrialResult result{.best = curve.empty() ? kVoidScore : curve.back().best,
                           .terms = {},
                           .ground = {},
                           .hash = 0,
                           .curve = curve};
  rows_[index] = {.text = RowsOf(plan, StudyTable::kCurves, index, result), .line = 0};
  samples_[search].push_back(BestAtPoints(plan, curve, kVoidScore));
  SumUp(search);
  SumUpReached();
  if (++finished_ == Total()) state_ = LabState::kDone;
}

void Lab::End(LabState state) {
  if (Running()) state_ = state;
}

void Lab::SumUp(std::size_t search) {
  LabSeries& series = series_[search];
  series.trials = static_cast<int>(samples_[search].size());
  series.points.clear();
  std::vector<double> sample(samples_[search].size());
  for (int point = 0; point < study_.plan.points; ++point) {
    for (std::size_t i = 0; i < sample.size(); ++i)
      sample[i] = static_cast<double>(samples_[search][i][static_cast<std::size_t>(point)]);
    const double lower = Quantile(sample, 0.25);
    if (lower <= static_cast<double>(kNoMotion)) continue;
    series.points.push_back(
        {study_.plan.EvaluationsAt(point), lower, Quantile(sample, 0.5), Quantile(sample, 0.75)});
  }
}

void Lab::SumUpReached() {
  std::vector<Progress> all;
  for (const std::vector<Progress>& trials : samples_) all.insert(all.end(), trials.begin(), trials.end());
  targets_ = TargetsOf(all);
  for (std::size_t search = 0; search < series_.size(); ++search) {
    LabSeries& series = series_[search];
    series.reached.clear();
    series.to_halfway.reset();
    if (samples_[search].empty() || targets_.empty()) continue;
    const std::vector<double> share = ShareReached(samples_[search], targets_);
    for (std::size_t point = 0; point < share.size(); ++point)
      series.reached.push_back({study_.plan.EvaluationsAt(static_cast<int>(point)), share[point]});
    series.to_halfway = RunningTimeTo(*Halfway(), samples_[search], study_.plan);
  }
}

std::optional<double> Lab::Halfway() const {
  if (targets_.empty()) return std::nullopt;
  return targets_[(targets_.size() - 1) / 2];
}

bool Lab::IsOf(const Document& document) const {
  return !study_.problems.empty() &&
         EncodeBinary(study_.problems.front()) == EncodeBinary(OnlyProblem(document));
}

std::string Lab::Csv() const {
  return StudyFile{.plan = study_.plan, .table = StudyTable::kCurves, .trials = rows_}.Text();
}

std::string Lab::Label() const { return study_.plan.problems.empty() ? "" : study_.plan.problems.front(); }

}  // namespace gaitsmith::shell
