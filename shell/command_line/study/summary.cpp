// SPDX-License-Identifier: MIT
#include "shell/command_line/study/summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <list>

#include "shell/command_line/files.h"
#include "shell/command_line/study/rank_diagram.h"
#include "shell/study/rank_test.h"

namespace gaitsmith::shell {

namespace {

/// The curve in a trial's checked rows.
Progress CurveIn(const StudyPlan& plan, std::string_view rows) {
  Progress curve(static_cast<std::size_t>(plan.points), -std::numeric_limits<float>::infinity());
  // Points before the first score have no row, so the rows are those of the last points.
  auto point = static_cast<std::size_t>(plan.points - std::ranges::count(rows, '\n'));
  for (; !rows.empty(); rows.remove_prefix(rows.find('\n') + 1))
    curve[point++] = static_cast<float>(BestIn(rows));
  return curve;
}

/// The trials of a file, for each problem and each search in the order of the file's plan.
std::vector<Sample> SamplesIn(const StudyFile& file, const std::string& name) {
  const StudyPlan& plan = file.plan;
  std::vector<Sample> samples;
  samples.reserve(plan.problems.size() * plan.searches.size());
  for (const std::string& problem : plan.problems) {
    for (const std::string& search : plan.searches)
      samples.push_back({.problem = problem, .search = search, .file = name, .plan = &plan});
  }
  for (const auto& [index, rows] : file.trials) {
    const StudyPlan::Trial trial = plan.At(index);
    Sample& sample = samples[trial.problem * plan.searches.size() + trial.search];
    sample.seeds.push_back(trial.seed);
    if (file.table == StudyTable::kCurves) {
      sample.curves.push_back(CurveIn(plan, rows.text));
      sample.best.push_back(static_cast<double>(sample.curves.back().back()));
    } else {
      sample.best.push_back(BestIn(rows.text));
    }
  }
  std::erase_if(samples, [](const Sample& one) { return one.best.empty(); });
  return samples;
}

/// The name of a file without folder and extension, or its path if another file has the same name.
std::string NameIn(std::span<const std::string> paths, const std::string& path) {
  const auto name = [](const std::string& of) { return std::filesystem::path(of).stem().string(); };
  return std::ranges::count(paths, name(path), name) == 1 ? name(path) : path;
}

Result<StudyFile> ReadStudyFile(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (!file) return std::unexpected(file.error());
  if (file->table == StudyTable::kMotions) {
    return Fail(ErrorCode::kStructure, path,
                "holds motions; a summary is made from the files that compare writes to --out and --curves");
  }
  return file;
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

std::string Quartiles(const Sample& sample) {
  return SummaryLine(sample.problem + "," + sample.search + "," + std::to_string(sample.best.size()),
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
    lines += SummaryLine(a->problem + "," + a->search + "," + b->search,
                         {Quantile(a->best, 0.5), Quantile(b->best, 0.5), a12, adjusted[i]});
  }
  return lines;
}

std::string ResultTables(const std::vector<Sample>& samples) {
  std::string each = "problem,search,n,median,lower_quartile,upper_quartile\n";
  std::string pairs = "problem,search_a,search_b,median_a,median_b,A12,p_holm\n";
  for (const std::string& problem : ProblemsOf(samples)) {
    const std::vector<const Sample*> on_it = OnProblem(samples, problem);
    for (const Sample* one : on_it) each += Quartiles(*one);
    pairs += Pairs(on_it);
  }
  return each + "\n" + pairs;
}

/// The value of a search with a seed on a problem, if that trial is finished.
std::optional<double> BestOf(const std::vector<Sample>& samples, const std::string& problem,
                             const std::string& search, std::uint32_t seed) {
  for (const Sample& one : samples) {
    if (one.problem != problem || one.search != search) continue;
    const auto at = std::ranges::find(one.seeds, seed);
    if (at != one.seeds.end()) return one.best[static_cast<std::size_t>(at - one.seeds.begin())];
  }
  return std::nullopt;
}

/// Ranks the searches in every problem and seed in which all have finished, prints the table and writes the
/// diagram.
Result<std::string> Ranks(const std::vector<Sample>& samples, const std::string& path) {
  std::vector<std::string> searches;
  for (const Sample& one : samples) {
    if (std::ranges::find(searches, one.search) == searches.end()) searches.push_back(one.search);
  }
  std::vector<std::vector<double>> blocks;
  for (const std::string& problem : ProblemsOf(samples)) {
    for (const std::uint32_t seed : OnProblem(samples, problem).front()->seeds) {
      std::vector<double> block;
      for (const std::string& search : searches) {
        if (const auto best = BestOf(samples, problem, search, seed)) block.push_back(*best);
      }
      if (block.size() == searches.size()) blocks.push_back(std::move(block));
    }
  }
  if (searches.size() < 2 || blocks.empty()) {
    return Fail(ErrorCode::kStructure, "--ranks",
                "needs at least two searches, and a problem and seed with which all of them have finished");
  }
  const RankOrder order = RankOrderOf(blocks);
  if (auto written = WriteText(path, RankDiagramSvg(order, searches, blocks.size())); !written)
    return std::unexpected(written.error());
  std::string table = "search,blocks,mean_rank\n";
  for (const auto& [search, rank] : order.places)
    table += SummaryLine(searches[search] + "," + std::to_string(blocks.size()), {rank});
  table += "\nbetter,worse,rank_difference,p_holm\n";
  for (const RankOrder::Pair& pair : order.pairs) {
    const RankOrder::Place &better = order.places[pair.better], &worse = order.places[pair.worse];
    table += SummaryLine(searches[better.search] + "," + searches[worse.search],
                         {worse.rank - better.rank, pair.p});
  }
  return table;
}

}  // namespace

std::vector<std::string> ProblemsOf(const std::vector<Sample>& samples) {
  std::vector<std::string> problems;
  for (const Sample& one : samples) {
    if (std::ranges::find(problems, one.problem) == problems.end()) problems.push_back(one.problem);
  }
  return problems;
}

std::vector<const Sample*> OnProblem(const std::vector<Sample>& samples, const std::string& problem) {
  std::vector<const Sample*> on_it;
  for (const Sample& one : samples) {
    if (one.problem == problem) on_it.push_back(&one);
  }
  return on_it;
}

std::string SummaryLine(const std::string& start, std::initializer_list<double> values) {
  std::string line = start;
  for (const double value : values) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.6g", value);
    line += text;
  }
  return line + "\n";
}

Result<void> Summarize(const SummaryRequest& request) {
  std::list<StudyFile> files;  // samples point to their plans
  std::vector<Sample> samples;
  for (const std::string& path : request.paths) {
    if (std::ranges::count(request.paths, path) > 1)
      return Fail(ErrorCode::kStructure, path, "is given twice");
    auto file = ReadStudyFile(path);
    if (!file) return std::unexpected(file.error());
    files.push_back(std::move(*file));
    if (files.back().table != files.front().table) {
      return Fail(ErrorCode::kStructure, path,
                  "holds " + std::string(NameOf(files.back().table)) + ", while " + request.paths.front() +
                      " holds " + std::string(NameOf(files.front().table)) + "; summarise them one by one");
    }
    std::ranges::move(SamplesIn(files.back(), NameIn(request.paths, path)), std::back_inserter(samples));
  }
  const bool curves = files.front().table == StudyTable::kCurves;
  if (curves && !request.ranks.empty())
    return Fail(ErrorCode::kStructure, "--ranks", "needs files of results, not of curves");
  if (!curves && !request.ioh.empty())
    return Fail(ErrorCode::kStructure, "--ioh", "needs files of curves, not of results");
  for (const std::string& search : request.searches) {
    if (std::ranges::find(samples, search, &Sample::search) == samples.end())
      return Fail(ErrorCode::kUnknownName, "--search", "no file has trials of " + search);
  }
  if (!request.searches.empty()) {
    std::erase_if(samples, [&](const Sample& one) {
      return std::ranges::find(request.searches, one.search) == request.searches.end();
    });
  }
  TellApart(samples);
  std::string text = curves ? RunningTimes(samples) : ResultTables(samples);
  if (!request.ranks.empty()) {
    const auto ranks = Ranks(samples, request.ranks);
    if (!ranks) return std::unexpected(ranks.error());
    text += "\n" + *ranks;
  }
  if (!request.ioh.empty()) {
    if (auto written = WriteIoh(request.ioh, samples); !written) return written;
  }
  return WriteText("-", text);
}

}  // namespace gaitsmith::shell
