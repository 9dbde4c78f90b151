// SPDX-License-Identifier: MIT
// gaitsmith compare --summary: how well each search did on each problem, and which differences between
// searches are significant.
#include <cstdio>

#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/study/rank_test.h"
#include "shell/study/study_file.h"

namespace gaitsmith::shell {

namespace {

/// The column `best` of the finished trials on one problem, for each search.
std::vector<std::vector<double>> Samples(const StudyFile& file, std::size_t problem) {
  std::vector<std::vector<double>> samples(file.plan.searches.size());
  for (const auto& [index, rows] : file.trials) {
    const StudyPlan::Trial trial = file.plan.At(index);
    if (trial.problem != problem) continue;
    samples[trial.search].push_back(BestIn(rows.text));
  }
  return samples;
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

std::string Quartiles(const std::string& start, const std::vector<double>& sample) {
  return Line(start + "," + std::to_string(sample.size()),
              {Quantile(sample, 0.5), Quantile(sample, 0.25), Quantile(sample, 0.75)});
}

/// Compares every pair of searches on one problem, as one family of tests.
std::string Pairs(const StudyPlan& plan, const std::string& problem,
                  const std::vector<std::vector<double>>& samples) {
  struct Pair {
    std::size_t a, b;
    double a12;
  };
  std::vector<Pair> pairs;
  std::vector<double> p;
  for (std::size_t a = 0; a < samples.size(); ++a) {
    for (std::size_t b = a + 1; b < samples.size(); ++b) {
      if (samples[a].empty() || samples[b].empty()) continue;
      const RankComparison compared = CompareRanks(samples[a], samples[b]);
      pairs.push_back({a, b, compared.a12});
      p.push_back(compared.p);
    }
  }
  const std::vector<double> adjusted = HolmAdjusted(p);
  std::string lines;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b, a12] = pairs[i];
    lines += Line(problem + "," + plan.searches[a] + "," + plan.searches[b],
                  {Quantile(samples[a], 0.5), Quantile(samples[b], 0.5), a12, adjusted[i]});
  }
  return lines;
}

}  // namespace

Outcome Summarize(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  const auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (!file) return std::unexpected(file.error());
  if (file->table != StudyTable::kResults) {
    return Fail(ErrorCode::kStructure, path,
                "holds " + std::string(NameOf(file->table)) +
                    "; a summary is made from the results that compare writes to --out");
  }
  std::string each = "problem,search,n,median,lower_quartile,upper_quartile\n";
  std::string pairs = "problem,search_a,search_b,median_a,median_b,A12,p_holm\n";
  for (std::size_t problem = 0; problem < file->plan.problems.size(); ++problem) {
    const std::string& name = file->plan.problems[problem];
    const auto samples = Samples(*file, problem);
    for (std::size_t search = 0; search < samples.size(); ++search) {
      if (samples[search].empty()) continue;
      each += Quartiles(name + "," + file->plan.searches[search], samples[search]);
    }
    pairs += Pairs(file->plan, name, samples);
  }
  return WriteText("-", each + "\n" + pairs);
}

}  // namespace gaitsmith::shell
