// SPDX-License-Identifier: MIT
#include "shell/study/switch_file.h"

#include <cstdlib>

#include "shell/study/fields.h"

namespace gaitsmith::shell {

namespace {

constexpr std::string_view kSwitchStart = "# gaitsmith switches ";
constexpr std::string_view kSwitchColumns = "from,to,step,score,usual,success,distance\n";
constexpr std::size_t kSwitchFields = 7;

bool IsReal(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

Result<SwitchFile> ReadSwitchHeading(std::string_view line) {
  const auto damaged = Fail(ErrorCode::kSyntax, "", "its heading is damaged");
  // Labels may have blanks, so they come last.
  constexpr std::string_view kLast = " documents ";
  const std::size_t last = line.find(kLast);
  if (last == std::string_view::npos) return damaged;
  const auto words = PartsOf(line.substr(0, last), ' ');
  if (words.size() != 10) return damaged;
  SwitchFile file{.fingerprint = words[3], .labels = PartsOf(line.substr(last + kLast.size()), ',')};
  const auto shard = ParseShard(words[9]);
  if (!ReadWhole(words[7], file.times) || file.times < 1 || file.labels.size() < 2 || !shard) return damaged;
  file.shard = *shard;
  return file;
}

/// @return the error in a row of this pair, or nothing
std::string RowFault(const SwitchFile& file, std::size_t pair, const std::vector<std::string>& fields) {
  const auto [from, to] = file.At(pair);
  if (fields.size() != kSwitchFields) {
    return "has " + std::to_string(fields.size()) + " fields instead of " + std::to_string(kSwitchFields);
  }
  if (fields[0] != file.labels[from] || fields[1] != file.labels[to]) {
    return "must be of " + file.NameOfTrial(pair);
  }
  int step = 0;
  if (!ReadWhole(fields[2], step) || (fields[5] != "0" && fields[5] != "1")) return "has a damaged number";
  const bool fine = IsReal(fields[3]) && IsReal(fields[4]) && IsReal(fields[6]);
  return fine ? "" : "has a damaged number";
}

}  // namespace

SwitchFile::Pair SwitchFile::At(std::size_t pair) const {
  const std::size_t from = pair / (labels.size() - 1), other = pair % (labels.size() - 1);
  return {.from = from, .to = other < from ? other : other + 1};
}

std::string SwitchFile::NameOfTrial(std::size_t pair) const {
  return labels[At(pair).from] + " to " + labels[At(pair).to];
}

std::string SwitchFile::Heading() const {
  if (shard.of == 1) return std::string(kSwitchColumns);
  std::string names;
  for (const std::string& label : labels) names += (names.empty() ? "" : ",") + label;
  return std::string(kSwitchStart) + fingerprint + " pairs " + std::to_string(Total()) + " times " +
         std::to_string(times) + " shard " + NameOf(shard) + " documents " + names + "\n" +
         std::string(kSwitchColumns);
}

std::string SwitchFile::Text() const {
  std::string text = Heading();
  for (const auto& [pair, rows] : trials) text += rows.text;
  return text;
}

bool SwitchFile::Begins(std::string_view text) { return text.starts_with(kSwitchStart); }

Result<SwitchFile> SwitchFile::Parse(std::string_view text, const std::string& path, Ending ending) {
  if (!Begins(text)) return Fail(ErrorCode::kSyntax, path + ":1", "is not a shard of gaitsmith switches");
  auto file = ReadSwitchHeading(text.substr(0, text.find('\n')));
  // Writing the heading again must give the same text, as for other studies.
  if (!file || !text.starts_with(file->Heading())) {
    return Fail(ErrorCode::kSyntax, path + ":1", "its heading is damaged");
  }
  const auto times = static_cast<std::size_t>(file->times);
  std::size_t at = file->Heading().size(), line = 3, pair = file->shard.first;
  for (; at < text.size() && pair < file->Total(); pair += file->shard.of) {
    const std::size_t first = at, first_line = line;
    std::size_t rows = 0;
    for (; rows < times; ++rows, ++line) {
      const std::size_t end = text.find('\n', at);
      if (end == std::string_view::npos) break;
      if (const auto fault = RowFault(*file, pair, PartsOf(text.substr(at, end - at), ',')); !fault.empty()) {
        return Fail(ErrorCode::kSyntax, path + ":" + std::to_string(line), fault);
      }
      at = end + 1;
    }
    if (rows < times) {
      at = first;
      break;
    }
    file->trials[pair] = {.text = std::string(text.substr(first, at - first)), .line = first_line};
  }
  const bool cut = at < text.size() && pair < file->Total();
  if (cut ? ending == Ending::kWhole : at < text.size()) {
    return Fail(
        ErrorCode::kTruncated, path + ":" + std::to_string(line),
        cut ? "the pair is cut short; run its command again" : "comes after the last pair of this shard");
  }
  return file;
}

}  // namespace gaitsmith::shell
