// SPDX-License-Identifier: MIT
// gaitsmith taste: learns a person's taste from a file of comparisons.
#include "core/breeding/taste.h"

#include <cstdio>
#include <map>

#include "core/breeding/motion_traits.h"
#include "core/breeding/taste_weights.h"
#include "core/document/json.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {
namespace {

constexpr std::size_t kMostRows = 100'000;

/// Looks at motions, at each once.
class Viewer {
 public:
  Result<Traits> TraitsOf(const std::string& path, const std::string& where) {
    if (const auto known = seen_.find(path); known != seen_.end()) return known->second;
    const auto document = ReadDocument(path);
    if (!document) return std::unexpected(document.error());
    if (!first_) {
      first_ = *document;
    } else if (!SameTree(document->figure, first_->figure)) {
      return Fail(ErrorCode::kStructure, where, path + " has another figure than the motions before");
    }
    const auto traits = MotionTraits(*document);
    if (!traits) return Fail(traits.error().code, where, path + " " + traits.error().what);
    return seen_[path] = *traits;
  }
  /// The first document. Call after one was looked at.
  [[nodiscard]] const Document& First() const { return *first_; }

 private:
  std::map<std::string, Traits> seen_;
  std::optional<Document> first_;
};

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else if (c != '\r') {
      lines.back() += c;
    }
  }
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

Result<Comparison> ReadRow(const std::string& row, const std::string& where, Viewer& viewer) {
  const std::size_t one = row.find(','), two = row.rfind(',');
  if (one == std::string::npos || one == two)
    return Fail(ErrorCode::kSyntax, where, "must be first,second,verdict");
  const auto verdict = IndexOf(kVerdictNames, row.substr(two + 1), where);
  if (!verdict) return std::unexpected(verdict.error());
  const auto first = viewer.TraitsOf(row.substr(0, one), where);
  if (!first) return std::unexpected(first.error());
  const auto second = viewer.TraitsOf(row.substr(one + 1, two - one - 1), where);
  if (!second) return std::unexpected(second.error());
  return Comparison{*first, *second, static_cast<Verdict>(*verdict)};
}

Result<std::vector<Comparison>> ReadComparisons(const std::string& path, Viewer& viewer) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  const std::vector<std::string> lines = LinesOf(*text);
  if (lines.empty() || lines.front() != "first,second,verdict")
    return Fail(ErrorCode::kSyntax, path + ":1", "must be the heading first,second,verdict");
  if (lines.size() == 1) return Fail(ErrorCode::kMissing, path, "has no comparison");
  if (lines.size() > kMostRows)
    return Fail(ErrorCode::kTooMany, path, "has more than " + std::to_string(kMostRows) + " rows");
  std::vector<Comparison> comparisons;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto row = ReadRow(lines[i], path + ":" + std::to_string(i + 1), viewer);
    if (!row) return std::unexpected(row.error());
    comparisons.push_back(*row);
  }
  return comparisons;
}

const char* LikingOf(const Taste& taste, Trait trait) {
  if (!SureOf(taste, trait)) return "unsure";
  return TraitOf(taste.Weights(), trait) > 0.0f ? "more" : "less";
}

/// Prints the two of these motions whose comparison would tell most.
Result<void> PrintQuestion(const Taste& taste, const std::vector<std::string>& paths, Viewer& viewer) {
  std::vector<Traits> traits;
  for (const std::string& path : paths) {
    const auto seen = viewer.TraitsOf(path, "--ask");
    if (!seen) return std::unexpected(seen.error());
    traits.push_back(*seen);
  }
  std::size_t first = 0, second = 1;
  float most = -1.0f;
  for (std::size_t i = 0; i < traits.size(); ++i) {
    for (std::size_t k = i + 1; k < traits.size(); ++k) {
      const float telling = taste.Telling(traits[i], traits[k]);
      if (telling > most) {
        most = telling;
        first = i;
        second = k;
      }
    }
  }
  std::printf("first,second,telling\n%s,%s,%.4f\n", paths[first].c_str(), paths[second].c_str(),
              static_cast<double>(most));
  return {};
}

}  // namespace

Outcome TasteCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"ask", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return WrongCall(arguments.error());
  if (arguments->Positional().size() != 1)
    return WrongCall({ErrorCode::kMissing, "CSV", "give exactly one file of comparisons"});
  const std::vector<std::string>& asked = arguments->All("ask");
  if (asked.size() == 1) return WrongCall({ErrorCode::kMissing, "--ask", "give at least two documents"});
  Viewer viewer;
  const auto comparisons = ReadComparisons(arguments->Positional().front(), viewer);
  if (!comparisons) return std::unexpected(comparisons.error());
  const Taste taste(*comparisons);

  if (!asked.empty()) {
    if (auto printed = PrintQuestion(taste, asked, viewer); !printed) return std::unexpected(printed.error());
  }
  if (arguments->Has("out")) {
    Document document = viewer.First();
    document.task.weights = WeightsOf(taste, document);
    if (auto written = WriteText(arguments->Last("out"), EncodeJson(document)); !written)
      return std::unexpected(written.error());
    if (arguments->Last("out") == "-") return {};
  }
  if (!asked.empty()) return {};
  std::printf("trait,unit,scale,weight,doubt,likes\n");
  for (std::size_t i = 0; i < kTraits; ++i) {
    const TraitRow& row = kTraitTable[i];
    std::printf("%s,%s,%g,%.3f,%.3f,%s\n", std::string(row.name).c_str(), std::string(row.unit).c_str(),
                static_cast<double>(row.scale), static_cast<double>(taste.Weights()[i]),
                static_cast<double>(taste.Doubts()[i]), LikingOf(taste, static_cast<Trait>(i)));
  }
  return {};
}

}  // namespace gaitsmith::shell
