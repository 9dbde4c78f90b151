// SPDX-License-Identifier: MIT
// gaitsmith breed: one round of breeding from picked motions.
#include <cstdio>

#include "core/breeding/litter.h"
#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/rollout/models.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::shell {
namespace {

/// The picked documents: the first one gives figure, ground and goal, each one its first controller.
struct Picks {
  Document document;
  std::vector<Controller> parents;
};

Result<Picks> ReadPicks(const std::vector<std::string>& paths) {
  Picks picks;
  for (const std::string& path : paths) {
    auto document = ReadDocument(path);
    if (!document) return std::unexpected(document.error());
    if (document->timeline.empty()) return Fail(ErrorCode::kMissing, path, "has no motion to breed from");
    const Controller& parent = FirstControllerOf(*document);
    picks.parents.push_back(parent);
    if (picks.parents.size() == 1) {
      picks.document = std::move(*document);
    } else if (!SameTree(document->figure, picks.document.figure)) {
      return Fail(ErrorCode::kStructure, path, "has another figure than " + paths.front());
    } else if (!SameShape(parent, picks.parents.front())) {
      return Fail(ErrorCode::kStructure, path,
                  "its controller has another kind, other senses or another number of rules than that of " +
                      paths.front());
    } else if (!SameJoints(*document, picks.document)) {
      std::fprintf(stderr,
                   "gaitsmith breed: %s has joints of another strength; all children get those of %s\n",
                   path.c_str(), paths.front().c_str());
    } else if (!SameRods(*document, picks.document)) {
      std::fprintf(stderr, "gaitsmith breed: %s has another body; all children get that of %s\n",
                   path.c_str(), paths.front().c_str());
    }
  }
  return picks;
}

/// Reads --keep goal, --keep rule=N and --keep joint=N.
Result<void> ReadKept(const Arguments& arguments, const ControllerShape& shape, BreedRound& wish) {
  for (const std::string& kept : arguments.All("keep")) {
    const std::size_t sign = kept.find('=');
    const std::string what = kept.substr(0, sign);
    if (kept == "goal") {
      wish.keep_goal = true;
      continue;
    }
    if (sign == std::string::npos || (what != "rule" && what != "joint"))
      return Fail(ErrorCode::kSyntax, "--keep", "must be goal, rule=N or joint=N, is " + kept);
    if (shape.Kind() == ControllerKind::kNetwork)
      return Fail(ErrorCode::kStructure, "--keep", "a network has no rules whose " + what + " could be kept");
    const bool rule = what == "rule";
    const auto number = ParseWhole(kept.substr(sign + 1), 1, rule ? shape.Bank().rules : shape.Bank().joints,
                                   "--keep " + what);
    if (!number) return std::unexpected(number.error());
    (rule ? wish.kept_rules : wish.kept_joints) |= 1u << (*number - 1);
  }
  return {};
}

/// Least distance to the other children.
float NearestOf(const std::vector<Brood::Member>& children, std::size_t child) {
  float nearest = 1.0f;
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (i != child) nearest = std::min(nearest, TraitDistance(children[i].traits, children[child].traits));
  }
  return nearest;
}

void PrintHeading() {
  std::printf("child,file,fitness,travel");
  for (std::size_t term = 0; term < kFreeTerms; ++term)
    std::printf(",%s", std::string(kStyleTermNames[term]).c_str());
  std::printf(",from_parent,from_others,hash\n");
}

/// @param family the picked document, with its lineage
/// @param repeats whether the lineage leads to this child
Result<void> WriteChild(const Document& family, bool repeats, const Brood& brood, std::size_t child,
                        const std::string& prefix) {
  const Brood::Member& member = brood.Children()[child];
  Document document = ChildOf(family, member.genome);
  if (!repeats) document.lineage = {};
  const Motion motion = Simulate(document);
  document.hash = motion.Hash();
  const std::string file = prefix + "-" + std::to_string(child + 1) + ".json";
  if (auto written = WriteText(file, EncodeJson(document)); !written) return written;
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);
  std::printf("%zu,%s,%.9g,%.9g", child + 1, file.c_str(), static_cast<double>(member.fitness),
              static_cast<double>(terms.travel_m));
  for (int term = 0; term < kFreeTerms; ++term)
    std::printf(",%.9g", static_cast<double>(terms.Style(static_cast<StyleTerm>(term))));
  std::printf(",%.3f,%.3f,%s\n", static_cast<double>(brood.DistanceToParents(member.traits)),
              static_cast<double>(NearestOf(brood.Children(), child)), HashText(motion.Hash()).c_str());
  return {};
}

}  // namespace

Outcome BreedCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"difference", "seed",    "evaluations", "children",
                                                  "keep",       "threads", "out-prefix"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return WrongCall(arguments.error());
  const std::string prefix = arguments->Last("out-prefix");
  if (prefix.empty())
    return WrongCall({ErrorCode::kMissing, "--out-prefix", "say what the children's files begin with"});
  const std::size_t count = arguments->Positional().size();
  if (count == 0)
    return WrongCall(
        {ErrorCode::kMissing, "DOC", "give at least one document, the motions that were picked"});
  if (count > kMaxBrood)
    return WrongCall(
        {ErrorCode::kTooMany, "DOC",
         "at most " + std::to_string(kMaxBrood) + " documents, there are " + std::to_string(count)});
  auto picks = ReadPicks(arguments->Positional());
  if (!picks) return std::unexpected(picks.error());

  BreedRound wish;
  wish.task = picks->document.task;
  const auto difference = ParseNumber(arguments->Last("difference", "0.3"), "--difference");
  if (!difference) return WrongCall(difference.error());
  if (!(*difference >= 0.0 && *difference <= 1.0))
    return WrongCall({ErrorCode::kOutOfRange, "--difference", "must be from 0 to 1"});
  wish.difference = static_cast<float>(*difference);
  const auto children = arguments->Integer("children", 1, kMaxBrood, kLitter);
  if (!children) return WrongCall(children.error());
  const auto seed = arguments->Integer("seed", 0, std::numeric_limits<std::uint32_t>::max(), 1);
  if (!seed) return WrongCall(seed.error());
  wish.seed = static_cast<std::uint32_t>(*seed);
  const auto evaluations = arguments->Integer("evaluations", 200, 1'000'000, kRoundEvaluations);
  if (!evaluations) return WrongCall(evaluations.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  const ControllerShape shape =
      picks->parents.front().Shape(CountPorts(picks->document.model, picks->document.figure));
  if (auto kept = ReadKept(*arguments, shape, wish); !kept) return WrongCall(kept.error());

  const Document nursery = NurseryOf(picks->document, picks->parents, wish);
  const auto brood = BroodOf(nursery, static_cast<int>(*evaluations), static_cast<int>(*children));
  SearchControl control;
  RunToEnd(Scorer(NurseryProblem(nursery)), *brood, static_cast<int>(*evaluations),
           static_cast<int>(*threads), control, [](const SearchProgress&) {});
  if (brood->Children().empty())
    return Fail(ErrorCode::kStructure, arguments->Positional().front(), "none of its children moves");
  Document family = picks->document;
  family.lineage = nursery.lineage;
  const bool repeats = *evaluations == kRoundEvaluations && *children == kLitter;
  PrintHeading();
  for (std::size_t child = 0; child < brood->Children().size(); ++child) {
    if (auto written = WriteChild(family, repeats, *brood, child, prefix); !written)
      return std::unexpected(written.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
