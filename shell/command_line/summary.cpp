// SPDX-License-Identifier: MIT
// gaitsmith compare --summary: how well each search did on each problem, and which differences between
// searches are significant.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/study/rank_test.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

namespace {

/// All finished trials of one search on one problem, from one file.
struct Sample {
  std::string problem, search, file;
  std::vector<double> best;
};

/// The column `best` of a file, for each problem and each search in the order of the file's plan.
std::vector<Sample> SamplesIn(const StudyFile& file, const std::string& name) {
  const StudyPlan& plan = file.plan;
  std::vector<Sample> samples;
  samples.reserve(plan.problems.size() * plan.searches.size());
  for (const std::string& problem : plan.problems) {
    for (const std::string& search : plan.searches) samples.push_back({problem, search, name, {}});
  }
  for (const auto& [index, rows] : file.trials) {
    const StudyPlan::Trial trial = plan.At(index);
    samples[trial.problem * plan.searches.size() + trial.search].best.push_back(BestIn(rows.text));
  }
  std::erase_if(samples, [](const Sample& one) { return one.best.empty(); });
  return samples;
}

/// The name of a file without folder and extension, or its path if another file has the same name.
std::string NameIn(std::span<const std::string> paths, const std::string& path) {
  const auto name = [](const std::string& of) { return std::filesystem::path(of).stem().string(); };
  return std::ranges::count(paths, name(path), name) == 1 ? name(path) : path;
}

/// @param name of the file, for those who compare it with others
Result<std::vector<Sample>> ReadSamples(const std::string& path, const std::string& name) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  const auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (!file) return std::unexpected(file.error());
  if (file->table != StudyTable::kResults) {
    return Fail(ErrorCode::kStructure, path,
                "holds " + std::string(NameOf(file->table)) +
                    "; a summary is made from the results that compare writes to --out");
  }
  return SamplesIn(*file, name);
}

/// Names the file after each search that several files have tried on the same problem.
void TellApart(std::vector<Sample>& samples) {
  std::vector<std::string> names;
  names.reserve(samples.size());
  for (const Sample& one : samples) {
    const bool alone = std::ranges::count_if(samples, [&](const Sample& other) {
                         return other.problem == one.problem && other.search == one.search;
                       }) == 1;
    names.push_back(alone ? one.search : one.search + " in " + one.file);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].search = names[i];
}

std::string Line(const std::string& start, std::initializer_list<double> values) {
  std::string line = start;
  for (const double value : values) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.6g", value);
    line += text;
  }
  return line + "\n";
}

std::string Quartiles(const Sample& sample) {
  return Line(sample.problem + "," + sample.search + "," + std::to_string(sample.best.size()),
              {Quantile(sample.best, 0.5), Quantile(sample.best, 0.25), Quantile(sample.best, 0.75)});
}

/// Compares every pair of searches on one problem, as one family of tests.
std::string Pairs(std::span<const Sample* const> samples) {
  struct Pair {
    const Sample *a, *b;
    double a12;
  };
  std::vector<Pair> pairs;
  std::vector<double> p;
  for (std::size_t a = 0; a < samples.size(); ++a) {
    for (std::size_t b = a + 1; b < samples.size(); ++b) {
      const RankComparison compared = CompareRanks(samples[a]->best, samples[b]->best);
      pairs.push_back({samples[a], samples[b], compared.a12});
      p.push_back(compared.p);
    }
  }
  const std::vector<double> adjusted = HolmAdjusted(p);
  std::string lines;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [a, b, a12] = pairs[i];
    lines += Line(a->problem + "," + a->search + "," + b->search,
                  {Quantile(a->best, 0.5), Quantile(b->best, 0.5), a12, adjusted[i]});
  }
  return lines;
}

}  // namespace

Outcome Summarize(std::span<const std::string> paths, std::span<const std::string> searches) {
  std::vector<Sample> samples;
  for (const std::string& path : paths) {
    if (std::ranges::count(paths, path) > 1) return Fail(ErrorCode::kStructure, path, "is given twice");
    auto of_file = ReadSamples(path, NameIn(paths, path));
    if (!of_file) return std::unexpected(of_file.error());
    std::ranges::move(*of_file, std::back_inserter(samples));
  }
  const auto is = [](const std::string& search) {
    return [&](const Sample& one) { return one.search == search; };
  };
  for (const std::string& search : searches) {
    if (std::ranges::none_of(samples, is(search)))
      return Fail(ErrorCode::kUnknownName, "--search", "no file has trials of " + search);
  }
  if (!searches.empty()) {
    std::erase_if(samples, [&](const Sample& one) {
      return std::ranges::find(searches, one.search) == searches.end();
    });
  }
  TellApart(samples);
  std::vector<std::string> problems;
  for (const Sample& one : samples) {
    if (std::ranges::find(problems, one.problem) == problems.end()) problems.push_back(one.problem);
  }
  std::string each = "problem,search,n,median,lower_quartile,upper_quartile\n";
  std::string pairs = "problem,search_a,search_b,median_a,median_b,A12,p_holm\n";
  for (const std::string& problem : problems) {
    std::vector<const Sample*> on_it;
    for (const Sample& one : samples) {
      if (one.problem != problem) continue;
      on_it.push_back(&one);
      each += Quartiles(one);
    }
    pairs += Pairs(on_it);
  }
  return WriteText("-", each + "\n" + pairs);
}

}  // namespace gaitsmith::shell
