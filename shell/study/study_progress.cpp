// SPDX-License-Identifier: MIT
#include "shell/study/study_progress.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace gaitsmith::shell {

namespace {

/// A path as a field of CSV.
std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A sentence names this number of shards. The table names all.
constexpr std::size_t kNamedShards = 10;

}  // namespace

void StudyProgress::Add(const std::string& path, const Shard& shard,
                        const std::map<std::size_t, StudyFile::Rows>& trials) {
  for (const auto& [trial, rows] : trials) done_[trial] = true;
  files_.push_back({.shard = shard, .done = trials.size(), .path = path});
}

void StudyProgress::AddWithoutHeading(const std::string& path) {
  files_.push_back({.shard = {}, .done = 0, .path = path, .headed = false});
}

std::size_t StudyProgress::Missing() const {
  return static_cast<std::size_t>(std::ranges::count(done_, false));
}

std::size_t StudyProgress::DoneIn(const Shard& shard) const {
  std::size_t done = 0;
  for (std::size_t trial = shard.first; trial < done_.size(); trial += shard.of) done += done_[trial] ? 1 : 0;
  return done;
}

std::vector<StudyProgress::Row> StudyProgress::Rows() const {
  std::vector<Row> rows = files_;
  std::set<std::pair<std::size_t, std::size_t>> there;  // of, first
  std::set<std::size_t> counts;
  for (const Row& row : files_) {
    if (row.shard.of == 1) continue;
    there.insert({row.shard.of, row.shard.first});
    counts.insert(row.shard.of);
  }
  for (const std::size_t of : counts) {
    for (std::size_t first = 0; first < std::min(of, done_.size()); ++first) {
      if (there.contains({of, first})) continue;
      const Shard shard{.first = first, .of = of};
      const std::size_t done = DoneIn(shard);
      if (done < shard.Due(done_.size())) rows.push_back({.shard = shard, .done = done, .path = ""});
    }
  }
  std::ranges::sort(rows, {}, [](const Row& row) {
    return std::tuple(!row.headed, row.shard.of, row.shard.first, std::string_view(row.path));
  });
  return rows;
}

std::string StudyProgress::Csv() const {
  std::string csv = "shard,of,done,due,state,file\n";
  for (const Row& row : Rows()) {
    if (!row.headed) {
      csv += ",,0,,unfinished," + Quoted(row.path) + "\n";
      continue;
    }
    const std::size_t due = row.shard.Due(done_.size());
    const char* state = row.path.empty() ? "missing" : row.done == due ? "complete" : "unfinished";
    csv += std::to_string(row.shard.first + 1) + "," + std::to_string(row.shard.of) + "," +
           std::to_string(row.done) + "," + std::to_string(due) + "," + state + "," + Quoted(row.path) + "\n";
  }
  const std::size_t missing = Missing();
  return csv + "all,," + std::to_string(done_.size() - missing) + "," + std::to_string(done_.size()) + "," +
         (missing == 0 ? "complete" : "unfinished") + ",\n";
}

std::string StudyProgress::Sentence(const std::function<std::string(std::size_t)>& name) const {
  std::string sentence =
      std::to_string(Missing()) + " of " + std::to_string(done_.size()) + " " + noun_ + " are missing";
  std::size_t named = 0, more = 0;
  for (const Row& row : Rows()) {
    const bool lost = row.path.empty();
    if (!lost && (row.shard.of == 1 || DoneIn(row.shard) == row.shard.Due(done_.size()))) continue;
    if (named == kNamedShards) {
      ++more;
      continue;
    }
    sentence += (named++ == 0 ? ": shard " : "; shard ") + NameOf(row.shard) +
                (lost ? " has no file" : " is not finished (" + row.path + ")");
  }
  if (more > 0) sentence += "; and " + std::to_string(more) + " more";
  const auto first = std::ranges::find(done_, false);
  if (named > 0 || first == done_.end()) return sentence;
  return sentence + ", first that of " + name(static_cast<std::size_t>(first - done_.begin()));
}

}  // namespace gaitsmith::shell
