// SPDX-License-Identifier: MIT
#include "shell/study/study_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/document/link.h"
#include "shell/study/fields.h"

namespace gaitsmith::shell {

namespace {

constexpr std::size_t kResultFields = 12, kCurveFields = 5, kMotionFields = kResultFields + 1;

constexpr std::size_t FieldsOf(StudyTable table) {
  return table == StudyTable::kCurves    ? kCurveFields
         : table == StudyTable::kMotions ? kMotionFields
                                         : kResultFields;
}

std::string Number(double value) {
  if (value != value) return "nan";  // of a motion that broke physics; some libraries print the sign of a NaN
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// Parses a text that begins with a number. (Emscripten's std::from_chars supports whole numbers only.)
double Real(std::string_view text) { return std::strtod(std::string(text).c_str(), nullptr); }

/// "problem,search,seed,"
std::string TrialText(const StudyPlan& plan, std::size_t index) {
  const StudyPlan::Trial trial = plan.At(index);
  return plan.problems[trial.problem] + "," + plan.searches[trial.search] + "," + std::to_string(trial.seed) +
         ",";
}

/// Reads the rows of a file in order. The curve of a trial is contiguous and in order.
class RowReader {
 public:
  explicit RowReader(const StudyFile& file) : file_(file) {}

  /// @return the error in a row, or nothing
  std::string Read(std::string_view row) {
    Cut(row);
    if (const std::size_t fields = FieldsOf(file_.table); count_ != fields) {
      return "has " + std::to_string(count_) + " fields instead of " + std::to_string(fields);
    }
    std::uint32_t seed = 0;
    if (!ReadWhole(fields_[2], seed)) return "its seed is not a number";
    const auto trial = file_.plan.Find(fields_[0], fields_[1], seed);
    if (!trial) return "is of no trial of this study";
    if (!file_.shard.Holds(*trial)) return "is of no trial of shard " + NameOf(file_.shard);
    if (points_ > 0 && trial != trial_) return "comes before the curve of another trial is complete";
    trial_ = *trial;
    std::string fault = file_.table == StudyTable::kCurves ? CheckPoint() : CheckResult();
    if (fault.empty() && file_.table == StudyTable::kMotions) fault = CheckLink();
    return fault.empty() && file_.trials.contains(trial_) ? "is there twice, first in line " + FirstLine()
                                                          : fault;
  }
  [[nodiscard]] std::size_t Trial() const { return trial_; }
  /// Whether the last row was the last of its trial.
  [[nodiscard]] bool Complete() const { return points_ == 0; }

 private:
  void Cut(std::string_view row) {
    count_ = 0;
    for (std::size_t at = 0; at <= row.size(); ++count_) {
      const std::size_t end = std::min(row.find(',', at), row.size());
      if (count_ < fields_.size()) fields_[count_] = row.substr(at, end - at);
      at = end + 1;
    }
  }
  /// Accepts only the notation that we write: another notation is a sign of damage.
  static bool IsNumber(std::string_view text, double& value) {
    value = Real(text);
    return Number(value) == text;
  }

  std::string CheckResult() const {
    int evaluations = 0;
    if (!ReadWhole(fields_[3], evaluations) || evaluations != file_.plan.evaluations) {
      return "must have " + std::to_string(file_.plan.evaluations) + " evaluations";
    }
    double value = 0.0;  // a motion that broke physics may have NaN terms, but has a score
    for (std::size_t i = 4; i < kResultFields - 1; ++i) {
      if (!IsNumber(fields_[i], value) || (i == 4 && !std::isfinite(value)))
        return "has a damaged number, \"" + std::string(fields_[i]) + "\"";
    }
    if (fields_[kResultFields - 1].size() != 16 ||
        fields_[kResultFields - 1].find_first_not_of("0123456789abcdef") != std::string_view::npos) {
      return "its hash is not 16 hexadecimal digits";
    }
    return "";
  }
  /// Checks that the link holds the motion of this row.
  std::string CheckLink() const {
    const auto document = DecodeLink(fields_[kMotionFields - 1]);
    if (!document) return "its link is damaged: " + document.error().Sentence();
    if (!document->hash || HashText(*document->hash) != fields_[kResultFields - 1] ||
        document->search.seed != file_.plan.At(trial_).seed || document->timeline.size() != 1) {
      return "its link holds the motion of another trial";
    }
    return "";
  }
  std::string CheckPoint() {
    const StudyPlan& plan = file_.plan;
    int evaluations = 0;
    if (!ReadWhole(fields_[3], evaluations)) return "its evaluation is not a number";
    // The first points of a curve may be missing, if no motion had a score yet. After that, points are
    // consecutive.
    int point = points_;
    while (points_ == 0 && point + 1 < plan.points && plan.EvaluationsAt(point) < evaluations) ++point;
    if (plan.EvaluationsAt(point) != evaluations) {
      return "must be of evaluation " + std::to_string(plan.EvaluationsAt(point));
    }
    double best = 0.0;
    if (!IsNumber(fields_[4], best) || !std::isfinite(best))
      return "has a damaged number, \"" + std::string(fields_[4]) + "\"";
    if (points_ > 0 && best < best_) return "is worse than the row before it";
    best_ = best;
    points_ = (point + 1) % plan.points;
    return "";
  }
  std::string FirstLine() const { return std::to_string(file_.trials.at(trial_).line); }

  const StudyFile& file_;
  std::array<std::string_view, kMotionFields> fields_;
  std::size_t count_ = 0, trial_ = 0;
  int points_ = 0;  // of the curve being read; 0 between curves
  double best_ = 0.0;
};

}  // namespace

std::string RowsOf(const StudyPlan& plan, StudyTable table, std::size_t trial, const TrialResult& result) {
  const std::string start = TrialText(plan, trial);
  if (table != StudyTable::kCurves) {
    std::string row = start + std::to_string(plan.evaluations);
    const Terms& terms = result.terms;
    for (const float value :
         {result.best, terms.travel_m, terms.max_cm_height_m, terms.slip_sum_m, terms.rotations,
          result.ground.share, static_cast<float>(result.ground.bearers)}) {
      row += "," + Number(static_cast<double>(value));
    }
    row += "," + HashText(result.hash);
    return row + (table == StudyTable::kMotions ? "," + result.link : "") + "\n";
  }
  std::string rows;
  const auto values = BestAtPoints(plan, result.curve, -std::numeric_limits<float>::infinity());
  for (int point = 0; point < plan.points; ++point) {
    const float best = values[static_cast<std::size_t>(point)];
    if (!std::isfinite(best)) continue;
    rows +=
        start + std::to_string(plan.EvaluationsAt(point)) + "," + Number(static_cast<double>(best)) + "\n";
  }
  return rows;
}

std::vector<float> BestAtPoints(const StudyPlan& plan, std::span<const Search::CurvePoint> curve,
                                float before) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(plan.points));
  std::size_t passed = 0;
  for (int point = 0; point < plan.points; ++point) {
    while (passed < curve.size() && curve[passed].evaluation <= plan.EvaluationsAt(point)) ++passed;
    values.push_back(passed == 0 ? before : curve[passed - 1].best);
  }
  return values;
}

std::string_view FieldOf(std::string_view row, int field) {
  for (; field > 0; --field) row.remove_prefix(row.find(',') + 1);
  return row.substr(0, row.find_first_of(",\n"));
}

double BestIn(std::string_view row) { return Real(FieldOf(row, 4)); }

Result<StudyFile> StudyFile::Parse(std::string_view text, const std::string& path, Ending ending) {
  auto heading = ParseHeading(text);
  if (!heading) return Fail(heading.error().code, path + ":1", heading.error().what);
  StudyFile file{.plan = std::move(heading->plan), .table = heading->table, .shard = heading->shard};
  RowReader reader(file);
  std::size_t at = Heading(file.plan, file.table, file.shard).size(), first = at, line = 3, first_line = line;
  file.whole_bytes = at;
  for (; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) break;
    if (const std::string fault = reader.Read(text.substr(at, end - at)); !fault.empty()) {
      return Fail(ErrorCode::kSyntax, path + ":" + std::to_string(line), fault);
    }
    at = end + 1;
    if (!reader.Complete()) continue;
    file.trials[reader.Trial()] = {.text = std::string(text.substr(first, at - first)), .line = first_line};
    file.whole_bytes = first = at;
    first_line = line + 1;
  }
  if (ending == Ending::kWhole && file.whole_bytes != text.size()) {
    return Fail(ErrorCode::kTruncated, path + ":" + std::to_string(first_line),
                "the trial is cut short; run its command again to finish it");
  }
  return file;
}

std::string StudyFile::NameOfTrial(std::size_t trial) const {
  const StudyPlan::Trial place = plan.At(trial);
  return plan.problems[place.problem] + " with " + plan.searches[place.search] + " and seed " +
         std::to_string(place.seed);
}

std::string StudyFile::Text() const {
  std::string text = Heading(plan, table, shard);
  for (const auto& [index, rows] : trials) text += rows.text;
  return text;
}

}  // namespace gaitsmith::shell
