// SPDX-License-Identifier: MIT
#include "shell/command_line/suite/suite_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <tuple>
#include <vector>

#include "core/document/json.h"
#include "core/document/link.h"
#include "shell/command_line/files.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

namespace {

/// A trial of a suite.
struct Found {
  std::string label;
  std::uint32_t seed;
  double score;
  std::string_view row;
};

Result<StudyFile> ReadMotions(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (file && file->table != StudyTable::kMotions) {
    return Fail(ErrorCode::kStructure, path,
                "holds " + std::string(NameOf(file->table)) + ", not the motions of a suite");
  }
  return file;
}

/// By label, then by score with the best first, then by seed.
std::vector<Found> Sorted(const StudyFile& file) {
  std::vector<Found> all;
  for (const auto& [index, rows] : file.trials) {
    const StudyPlan::Trial trial = file.plan.At(index);
    all.push_back({file.plan.problems[trial.problem], trial.seed, BestIn(rows.text), rows.text});
  }
  std::ranges::sort(all, {}, [](const Found& one) { return std::tuple(one.label, -one.score, one.seed); });
  return all;
}

}  // namespace

Outcome ListSuite(const std::string& path) {
  const auto file = ReadMotions(path);
  if (!file) return std::unexpected(file.error());
  constexpr std::size_t kColumns = 7;
  using Line = std::array<std::string, kColumns>;
  std::vector<Line> lines = {{"label", "seed", "score", "travel", "height", "slip", "rotations"}};
  for (const Found& found : Sorted(*file)) {
    Line line = {found.label, std::to_string(found.seed)};
    for (std::size_t column = 2; column < kColumns; ++column) {
      char text[48];
      const std::string field(FieldOf(found.row, static_cast<int>(column) + 2));
      std::snprintf(text, sizeof text, "%.3f", std::strtod(field.c_str(), nullptr));
      line[column] = text;
    }
    lines.push_back(std::move(line));
  }
  std::array<std::size_t, kColumns> widths{};
  for (const Line& line : lines) {
    for (std::size_t column = 0; column < kColumns; ++column)
      widths[column] = std::max(widths[column], line[column].size());
  }
  std::string text;
  for (const Line& line : lines) {
    text += line[0] + std::string(widths[0] - line[0].size(), ' ');
    for (std::size_t column = 1; column < kColumns; ++column)
      text += std::string(2 + widths[column] - line[column].size(), ' ') + line[column];
    text += "\n";
  }
  if (auto written = WriteText("-", text); !written) return std::unexpected(written.error());
  return {};
}

Outcome ExtractSuite(const std::string& path, const std::string& folder, Extracted which) {
  const auto file = ReadMotions(path);
  if (!file) return std::unexpected(file.error());
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) return Fail(ErrorCode::kMissing, folder, "cannot be made: " + fault.message());
  std::string last;
  for (const Found& found : Sorted(*file)) {
    if (which == Extracted::kBest && found.label == last) continue;
    last = found.label;
    // The file is untrusted: a label must not write outside the folder.
    if (found.label.find_first_of("/\\") != std::string::npos) {
      return Fail(ErrorCode::kStructure, path, "\"" + found.label + "\" cannot be the name of a file");
    }
    const auto document = DecodeLink(FieldOf(found.row, kLinkField));
    if (!document) return std::unexpected(document.error());
    const std::string name = found.label + "-" + std::to_string(found.seed) + ".json";
    if (auto written = WriteText((std::filesystem::path(folder) / name).string(), EncodeJson(*document));
        !written) {
      return std::unexpected(written.error());
    }
  }
  return {};
}

}  // namespace gaitsmith::shell
