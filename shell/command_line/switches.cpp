// SPDX-License-Identifier: MIT
// gaitsmith switches: how well controllers take over from each other at any moment.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <thread>

#include "core/document/joints.h"
#include "core/kinematics/state_distance.h"
#include "core/rollout/evaluator.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"
#include "shell/command_line/trial_crew.h"
#include "shell/search/parallel_search.h"
#include "shell/study/switch_file.h"
#include "shell/words/control_modes.h"

namespace gaitsmith::shell {

namespace {

/// A controller with its document's problem, and its score there without a switch.
struct Candidate {
  std::string label;
  Problem problem;  // with the observed duration, without pushes
  Controller controller;
  int duration_steps;  // of the document's task
  Document document;
  float usual = 0.0f;
  bool holds = false;  // does not break physics when run from the start
};

struct Switch {
  std::size_t from, to;
  int step;
  float score = 0.0f;
  bool success = false;
  double distance = 0.0;  // of the state from those that the second controller usually passes
};

/// @param document has a controller
Candidate CandidateOf(const Document& document, const std::string& path, int length) {
  const Controller& controller = FirstControllerOf(document);
  Problem problem = ReplayProblem(document, controller);
  problem.pushes.clear();
  problem.task.duration_steps = length > 0 ? length : document.task.duration_steps;
  return {.label = std::filesystem::path(path).stem().string(),
          .problem = std::move(problem),
          .controller = controller,
          .duration_steps = document.task.duration_steps,
          .document = document};
}

Result<std::vector<Candidate>> ReadCandidates(const std::vector<std::string>& paths, int length) {
  std::vector<Candidate> all;
  std::optional<Document> first;
  for (const std::string& path : paths) {
    auto document = ReadDocument(path);
    if (!document) return std::unexpected(document.error());
    if (document->controllers.empty()) return Fail(ErrorCode::kMissing, path, "has no controller");
    Candidate one = CandidateOf(*document, path, length);
    if (!first)
      first = std::move(*document);
    else if (!SameRods(*document, *first)) {
      return Fail(ErrorCode::kStructure, path,
                  "is of another figure than " + paths[0] + "; a controller fits its own alone");
    } else if (!SameJoints(*document, *first)) {
      return Fail(ErrorCode::kStructure, path,
                  "has joints of another strength than " + paths[0] +
                      "; a motion of the one is no motion of the other");
    }
    if (one.label.find_first_of(",\"\n") != std::string::npos) {
      return Fail(ErrorCode::kSyntax, path,
                  "its name is a label, which can have no comma, quote or line break");
    }
    if (std::ranges::any_of(all, [&](const Candidate& other) { return other.label == one.label; })) {
      return Fail(ErrorCode::kStructure, path, "\"" + one.label + "\" is there twice; names must differ");
    }
    all.push_back(std::move(one));
  }
  return all;
}

Evaluation EvaluateOne(const Problem& problem, const Controller& controller) {
  return Evaluator(problem, 1, false).Evaluate(std::span(&controller.genes, 1))[0];
}

/// Runs a job for each index, several in parallel.
template <class Job>
void ForEach(std::size_t count, int threads, const Job& job) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) job(i);
  };
  std::vector<std::jthread> workers;
  for (int i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
}

/// The first moment at which controllers take over [steps], when a motion has begun.
constexpr int kFirst = 100;

/// Every ordered pair of the shard at every time: from, to, step. The first controller is active for at most
/// the duration of its task.
std::vector<Switch> Planned(const std::vector<Candidate>& all, int times, const Shard& shard) {
  std::vector<Switch> switches;
  std::size_t pair = 0;
  for (std::size_t from = 0; from < all.size(); ++from) {
    for (std::size_t to = 0; to < all.size(); ++to) {
      if (to == from || !shard.Holds(pair++)) continue;
      const int span = std::max(0, all[from].duration_steps - kFirst);
      for (int i = 0; i < times; ++i) {
        const int step = kFirst + (times > 1 ? span * i / (times - 1) : 0);
        switches.push_back({.from = from, .to = to, .step = step});
      }
    }
  }
  return switches;
}

void Make(Switch& one, const std::vector<Candidate>& all) {
  const Candidate& to = all[one.to];
  Problem problem = to.problem;
  problem.beginnings = {{{all[one.from].controller}, {{.controller = 0, .start_step = 0}}, one.step}};
  const Evaluation found = EvaluateOne(problem, to.controller);
  one.score = found.fitness;
  one.success = found.fitness > kVoidScore && !found.terms.broke_physics && to.holds &&
                found.fitness >= to.usual - 0.5f * std::abs(to.usual);
}

/// The motion of a controller alone in the surroundings of a candidate.
Motion MotionAlone(const Candidate& where, const Controller& controller, int steps) {
  const Clip whole{.controller = 0, .start_step = 0};
  return Motion(Script{.figure = where.problem.figure,
                       .environment = where.problem.environment,
                       .start = where.problem.start,
                       .pushes = {},
                       .controllers = std::span(&controller, 1),
                       .clips = std::span(&whole, 1),
                       .steps = steps,
                       .model = where.problem.model});
}

/// @param pair the switches of one pair of controllers
void MeasureDistances(std::span<Switch> pair, const std::vector<Candidate>& all) {
  const Candidate &from = all[pair[0].from], &to = all[pair[0].to];
  const Motion before = MotionAlone(to, from.controller, pair.back().step);
  const Motion usual = MotionAlone(to, to.controller, std::max(1, to.problem.task.duration_steps));
  for (Switch& one : pair)
    one.distance = StateDistance(before, one.step, usual, std::min(kFirst, usual.Frames() - 1));
}

std::string SwitchesCsv(const std::vector<Switch>& switches, const std::vector<Candidate>& all,
                        const SwitchFile& file) {
  std::string csv = file.Heading();
  for (const Switch& one : switches) {
    char numbers[100];
    std::snprintf(numbers, sizeof numbers, ",%d,%.9g,%.9g,%d,%.6g\n", one.step,
                  static_cast<double>(one.score), static_cast<double>(all[one.to].usual), one.success ? 1 : 0,
                  one.distance);
    csv += all[one.from].label + "," + all[one.to].label + numbers;
  }
  return csv;
}

/// The share of successful switches, by the kinds of the two controllers.
std::string SummaryOf(const std::vector<Switch>& switches, const std::vector<Candidate>& all) {
  auto classes = ControlModeColumn(&ControlModeRow::name);
  std::swap(classes[0], classes[1]);  // physical senses first, in the order of the committed results
  std::string text = "from_class,to_class,switches,successes,rate\n";
  for (const std::string_view from : classes) {
    for (const std::string_view to : classes) {
      int count = 0, successes = 0;
      for (const Switch& one : switches) {
        if (ControlModeOf(all[one.from].controller).name != from ||
            ControlModeOf(all[one.to].controller).name != to)
          continue;
        ++count;
        successes += one.success ? 1 : 0;
      }
      if (count == 0) continue;
      char numbers[80];
      std::snprintf(numbers, sizeof numbers, ",%d,%d,%.3f\n", count, successes,
                    static_cast<double>(successes) / count);
      text += std::string(from) + "," + std::string(to) + numbers;
    }
  }
  return text;
}

}  // namespace

Outcome SwitchesCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"out", "times", "length", "threads", "shard"};
  static constexpr std::string_view kFlags[] = {"summary"};
  const auto arguments = Arguments::Parse(words, kOptions, kFlags);
  if (!arguments) return WrongCall(arguments.error());
  const std::string out = arguments->Last("out");
  if (out.empty()) {
    return WrongCall({ErrorCode::kMissing, "--out", "say where to write the rows (- for standard output)"});
  }
  if (arguments->Positional().size() < 2) {
    return WrongCall({ErrorCode::kMissing, "DOC", "give at least two documents"});
  }
  const auto times = arguments->Integer("times", 1, 1000, 20);
  if (!times) return WrongCall(times.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  const auto shard = ReadShard(*arguments);
  if (!shard) return WrongCall(shard.error());
  if (shard->of > 1 && arguments->Has("summary")) {
    return WrongCall(
        {ErrorCode::kStructure, "--summary", "cannot be given with --shard: it is of all switches"});
  }
  int length = 0;  // duration of each task
  if (arguments->Has("length")) {
    const auto steps = WholeSteps(arguments->Last("length"), "--length", 1);
    if (!steps) return WrongCall(steps.error());
    length = *steps;
  }
  auto all = ReadCandidates(arguments->Positional(), length);
  if (!all) return std::unexpected(all.error());

  SwitchFile file{.fingerprint = {}, .times = static_cast<int>(*times), .labels = {}, .shard = *shard};
  std::vector<Document> documents;
  for (const Candidate& one : *all) {
    file.labels.push_back(one.label);
    documents.push_back(one.document);
  }
  file.fingerprint = FingerprintOfSwitches(file.labels, documents, file.times, length);

  const int workers = static_cast<int>(*threads);
  ForEach(all->size(), workers, [&](std::size_t i) {
    Candidate& one = (*all)[i];
    const Evaluation found = EvaluateOne(one.problem, one.controller);
    one.usual = found.fitness;
    one.holds = found.fitness > kVoidScore && !found.terms.broke_physics;
  });
  std::vector<Switch> switches = Planned(*all, static_cast<int>(*times), *shard);
  ForEach(switches.size(), workers, [&](std::size_t i) { Make(switches[i], *all); });
  const auto of_pair = static_cast<std::size_t>(*times);
  ForEach(switches.size() / of_pair, workers, [&](std::size_t pair) {
    MeasureDistances(std::span(switches).subspan(pair * of_pair, of_pair), *all);
  });
  if (auto written = WriteText(out, SwitchesCsv(switches, *all, file)); !written) {
    return std::unexpected(written.error());
  }
  if (!arguments->Has("summary")) return {};
  const std::string gap = out == "-" ? "\n" : "";
  if (auto written = WriteText("-", gap + SummaryOf(switches, *all)); !written) {
    return std::unexpected(written.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
