// SPDX-License-Identifier: MIT
// gaitsmith measure: every term of a document's motion, and the score; or its way in several worlds.
#include <array>
#include <bit>
#include <cstdio>
#include <span>
#include <string_view>
#include <utility>

#include "core/document/trial_worlds.h"
#include "core/rollout/evaluator.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"

namespace gaitsmith::shell {

namespace {

/// A noise of WorldNoise by name.
struct NoiseRow {
  std::string_view name;
  void (*take)(WorldNoise& noise, const WorldNoise& all);
};
constexpr std::array<NoiseRow, 5> kNoises = {
    {{"friction", [](WorldNoise& noise, const WorldNoise& all) { noise.friction = all.friction; }},
     {"mass", [](WorldNoise& noise, const WorldNoise& all) { noise.mass = all.mass; }},
     {"slope", [](WorldNoise& noise, const WorldNoise& all) { noise.slope_rad = all.slope_rad; }},
     {"delay", [](WorldNoise& noise, const WorldNoise& all) { noise.delay_steps = all.delay_steps; }},
     {"step", [](WorldNoise& noise, const WorldNoise& /*all*/) {
        noise.halvings = static_cast<int>(FinestStep::kQuarter);
      }}}};

/// The noises that the arguments ask for: those of the document's search, or one.
Result<WorldNoise> NoiseAsked(const Arguments& arguments, const Document& document) {
  const WorldNoise all{.halvings = static_cast<int>(document.search.finest_step)};
  if (!arguments.Has("noise")) return all;
  WorldNoise noise{.friction = 0.0, .mass = 0.0, .slope_rad = 0.0, .delay_steps = 0};
  std::string names;
  for (const NoiseRow& row : kNoises) {
    if (row.name != arguments.Last("noise")) {
      names.append(names.empty() ? "" : ", ").append(row.name);
      continue;
    }
    row.take(noise, all);
    return noise;
  }
  return Fail(ErrorCode::kUnknownName, "--noise",
              "must be one of " + names + ", is \"" + arguments.Last("noise") + "\"");
}

/// The problem of a document with one clip, with as many substeps as asked for, and its genome.
Result<std::pair<Problem, Genome>> OneClip(const Arguments& arguments, const Document& document,
                                           const char* option) {
  if (document.timeline.size() != 1)
    return Fail(ErrorCode::kOutOfRange, option,
                "needs a motion of one clip, has " + std::to_string(document.timeline.size()));
  const auto substeps = arguments.Integer("substeps", 1, kMostSubsteps, 1);
  if (!substeps) return std::unexpected(substeps.error());
  if (!std::has_single_bit(static_cast<std::uint64_t>(*substeps)))
    return Fail(ErrorCode::kOutOfRange, "--substeps",
                "must be a power of two, is " + std::to_string(*substeps));
  const Controller& controller =
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)];
  Problem problem = ReplayProblem(document, controller);
  problem.substeps = static_cast<int>(*substeps);
  return std::pair(std::move(problem), controller.genes);
}

/// A row for each world, the document's own first.
Outcome MeasureWorlds(const Arguments& arguments, const Document& document) {
  const auto worlds = arguments.Integer("worlds", 1, kMaxWorlds, kRobustWorlds);
  if (!worlds) return std::unexpected(worlds.error());
  const auto seed = arguments.Integer("seed", 0, 4294967295, document.search.seed);
  if (!seed) return std::unexpected(seed.error());
  const auto noise = NoiseAsked(arguments, document);
  if (!noise) return std::unexpected(noise.error());
  const auto one = OneClip(arguments, document, "--worlds");
  if (!one) return std::unexpected(one.error());
  const auto& [problem, genome] = *one;
  std::vector<TrialWorld> drawn = DrawWorlds(static_cast<std::uint32_t>(*seed), static_cast<int>(*worlds),
                                             document.figure.Parts(), *noise);
  drawn.insert(drawn.begin(), TrialWorld{});
  std::printf("world,friction,slope_rad,delay_steps,travel,fitness,substeps\n");
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Problem there = problem.In(drawn[i]);
    const Evaluation found = Evaluator(there).Evaluate(std::span(&genome, 1)).front();
    std::printf("%d,%.9g,%.9g,%d,%.9g,%.9g,%d\n", static_cast<int>(i),
                static_cast<double>(there.environment.friction),
                static_cast<double>(there.environment.slope_rad), there.delay_steps,
                static_cast<double>(found.terms.travel_m), static_cast<double>(found.fitness),
                there.substeps);
  }
  return {};
}

/// Every term as CSV: a header and one row.
void PrintTerms(const Task& task, const Terms& terms, std::uint64_t hash) {
  std::string names = "travel", values;
  const auto add = [&values](float value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g,", static_cast<double>(value));
    values += text;
  };
  add(terms.travel_m);
  const auto add_terms = [&](int first, int end) {
    for (int term = first; term < end; ++term) {
      names += "," + std::string(kStyleTermNames[static_cast<std::size_t>(term)]);
      add(terms.Style(static_cast<StyleTerm>(term)));
    }
  };
  add_terms(0, kFreeTerms);
  add(Fitness(task, terms));
  names += ",fitness,hash";
  values += HashText(hash) + ",";
  add_terms(kFreeTerms, kStyleTerms);  // later columns than the hash
  values.pop_back();
  std::printf("%s\n%s\n", names.c_str(), values.c_str());
}

}  // namespace

Outcome MeasureCommand(Words words) {
  static constexpr std::array<std::string_view, 6> kOptions = {"joints", "ground", "worlds",
                                                               "seed",   "noise",  "substeps"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  if (auto set = SetProblemOptions(*arguments, *document); !set) return set;
  if (arguments->Has("worlds")) return MeasureWorlds(*arguments, *document);
  for (const char* option : {"seed", "noise"}) {
    if (arguments->Has(option))
      return Fail(ErrorCode::kMissing, std::string("--") + option, "needs --worlds");
  }
  if (arguments->Has("substeps")) {
    auto one = OneClip(*arguments, *document, "--substeps");
    if (!one) return std::unexpected(one.error());
    auto& [problem, genome] = *one;
    problem.all_terms = true;
    const Evaluation found = Evaluator(problem, true).Evaluate(std::span(&genome, 1)).front();
    PrintTerms(document->task, found.terms, found.trajectory_hash);
    return {};
  }
  const Motion motion = Simulate(*document);
  PrintTerms(document->task, motion.TermsAt(motion.Frames() - 1), motion.Hash());
  return {};
}

}  // namespace gaitsmith::shell
