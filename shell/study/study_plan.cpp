// SPDX-License-Identifier: MIT
#include "shell/study/study_plan.h"

#include <algorithm>
#include <array>

#include "shell/study/fields.h"

namespace gaitsmith::shell {

namespace {

constexpr std::array<std::string_view, 3> kTableNames = {"results", "curves", "motions"};
constexpr std::array<std::string_view, 3> kColumns = {
    "problem,search,seed,evaluations,best,travel,max_cm_height,slip_sum,rotations,grounded,bearers,hash",
    "problem,search,seed,evaluation,best",
    "problem,search,seed,evaluations,best,travel,max_cm_height,slip_sum,rotations,grounded,bearers,hash,"
    "link"};

std::string Joined(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : ",") + label;
  return text;
}

bool AllDiffer(std::vector<std::string> labels) {
  std::ranges::sort(labels);
  return std::ranges::adjacent_find(labels) == labels.end() && std::ranges::all_of(labels, IsLabel);
}

bool Holds(const StudyPlan& plan) {
  return plan.trials >= 1 && plan.trials <= kMaxTrials && plan.evaluations >= 1 &&
         plan.evaluations <= kMaxEvaluations && plan.points >= 1 && plan.points <= plan.evaluations &&
         plan.points <= kMaxPoints &&
         plan.first_seed <= 0xffffffffu - static_cast<std::uint32_t>(plan.trials - 1) &&
         AllDiffer(plan.problems) && AllDiffer(plan.searches) && plan.fingerprint.size() == 16 &&
         plan.fingerprint.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::string_view NameOf(StudyTable table) { return kTableNames[static_cast<std::size_t>(table)]; }

std::size_t StudyPlan::Total() const {
  return problems.size() * searches.size() * static_cast<std::size_t>(trials);
}

StudyPlan::Trial StudyPlan::At(std::size_t index) const {
  const auto each = static_cast<std::size_t>(trials);
  return {index / each / searches.size(), index / each % searches.size(),
          first_seed + static_cast<std::uint32_t>(index % each)};
}

std::optional<std::size_t> StudyPlan::Find(std::string_view problem, std::string_view search,
                                           std::uint32_t seed) const {
  const auto p = static_cast<std::size_t>(std::ranges::find(problems, problem) - problems.begin());
  const auto s = static_cast<std::size_t>(std::ranges::find(searches, search) - searches.begin());
  const auto each = static_cast<std::size_t>(trials);
  if (p == problems.size() || s == searches.size() || seed < first_seed || seed - first_seed >= each) {
    return std::nullopt;
  }
  return (p * searches.size() + s) * each + (seed - first_seed);
}

int StudyPlan::EvaluationsAt(int point) const {
  return static_cast<int>(std::int64_t{evaluations} * (point + 1) / points);
}

std::size_t Shard::Due(std::size_t total) const { return first < total ? (total - first - 1) / of + 1 : 0; }

std::string NameOf(const Shard& shard) {
  return std::to_string(shard.first + 1) + "/" + std::to_string(shard.of);
}

std::optional<Shard> ParseShard(std::string_view text) {
  const std::size_t slash = text.find('/');
  std::size_t number = 0, of = 0;
  if (slash == std::string_view::npos || !ReadWhole(text.substr(0, slash), number) ||
      !ReadWhole(text.substr(slash + 1), of) || number < 1 || number > of || of > kMaxShards) {
    return std::nullopt;
  }
  return Shard{.first = number - 1, .of = of};
}

bool IsLabel(std::string_view text) {
  return !text.empty() && std::ranges::none_of(text, [](char c) {
    return c == ',' || c == '"' || static_cast<unsigned char>(c) <= ' ' || c == 0x7f;
  });
}

std::string Heading(const StudyPlan& plan, StudyTable table, const Shard& shard) {
  const auto kind = static_cast<std::size_t>(table);
  return "# gaitsmith study " + plan.fingerprint + " trials " + std::to_string(plan.Total()) + " " +
         std::string(kTableNames[kind]) + " evaluations " + std::to_string(plan.evaluations) + " points " +
         std::to_string(plan.points) + " first-seed " + std::to_string(plan.first_seed) + " problems " +
         Joined(plan.problems) + " searches " + Joined(plan.searches) +
         (shard.of > 1 ? " shard " + NameOf(shard) : "") + "\n" + std::string(kColumns[kind]) + "\n";
}

Result<ReadHeading> ParseHeading(std::string_view text) {
  const auto words = PartsOf(text.substr(0, text.find('\n')), ' ');
  if (words.size() < 3 || words[0] != "#" || words[1] != "gaitsmith" || words[2] != "study") {
    return Fail(ErrorCode::kSyntax, "", "is not a file of gaitsmith compare or suite");
  }
  const auto damaged = Fail(ErrorCode::kSyntax, "", "its heading is damaged");
  constexpr std::size_t kWords = 17, kWordsOfShard = kWords + 2;
  if (words.size() != kWords && words.size() != kWordsOfShard) return damaged;
  const auto shard = words.size() == kWordsOfShard ? ParseShard(words.back()) : Shard{};
  const auto kind = std::ranges::find(kTableNames, words[6]);
  std::size_t total = 0;
  StudyPlan plan{
      .fingerprint = words[3], .problems = PartsOf(words[14], ','), .searches = PartsOf(words[16], ',')};
  if (kind == kTableNames.end() || !shard || !ReadWhole(words[5], total) ||
      !ReadWhole(words[8], plan.evaluations) || !ReadWhole(words[10], plan.points) ||
      !ReadWhole(words[12], plan.first_seed)) {
    return damaged;
  }
  plan.trials = static_cast<int>(
      std::min<std::size_t>(total / (plan.problems.size() * plan.searches.size()), kMaxTrials + 1));
  const auto table = static_cast<StudyTable>(kind - kTableNames.begin());
  // Writing the plan again must give the same text. This also detects wrong words, a wrong total and other
  // columns.
  if (!Holds(plan) || !text.starts_with(Heading(plan, table, *shard))) return damaged;
  return ReadHeading{.plan = std::move(plan), .table = table, .shard = *shard};
}

}  // namespace gaitsmith::shell
