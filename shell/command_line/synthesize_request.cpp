// SPDX-License-Identifier: MIT
#include "shell/command_line/synthesize_request.h"

#include <initializer_list>

#include "core/document/joints.h"
#include "core/document/timeline_edit.h"
#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"
#include "shell/command_line/search_options.h"

namespace gaitsmith::shell {

namespace {

/// Makes the document's search start from one of its controllers, and search for one of its kind.
void StartFrom(int controller, Document& document) {
  const Controller& start = document.controllers[static_cast<std::size_t>(controller)];
  document.senses = start.senses;
  document.rules = start.rules;
  document.kind = start.kind;
  document.search = {};
  document.search.start = controller;
}

/// Refuses options that contradict the chosen mode.
Result<void> CheckAbsent(const Arguments& arguments, std::initializer_list<const char*> options,
                         const std::string& why) {
  for (const char* option : options) {
    if (arguments.Has(option)) return Fail(ErrorCode::kStructure, std::string("--") + option, why);
  }
  return {};
}

/// Reads a document's problem with the controller to start from.
Result<Document> ReadStart(const Arguments& arguments) {
  if (auto fine = CheckAbsent(arguments, {"figure", "sense", "rules", "controller"},
                              "cannot be given with --from: the controller fits its own");
      !fine) {
    return std::unexpected(fine.error());
  }
  auto document = ReadDocument(arguments.Last("from"));
  if (!document) return document;
  if (document->controllers.empty()) {
    return Fail(ErrorCode::kMissing, "--from " + arguments.Last("from"), "has no controller to start from");
  }
  document->controllers = {FirstControllerOf(*document)};
  document->timeline.clear();
  StartFrom(0, *document);
  document->hash.reset();
  return document;
}

/// Reads a document's problem, for a search from random controllers.
Result<Document> ReadProblem(const Arguments& arguments) {
  if (auto fine = CheckAbsent(arguments, {"figure", "from"}, "cannot be given with --problem"); !fine) {
    return std::unexpected(fine.error());
  }
  auto document = ReadDocument(arguments.Last("problem"));
  if (!document) return document;
  document->controllers.clear();
  document->timeline.clear();
  document->search = {};
  document->hash.reset();
  return document;
}

/// Creates a new document for a figure.
Result<Document> ReadNew(const Arguments& arguments) {
  const auto figure = ReadFigure(arguments.Last("figure", "mr-star-man"));
  if (!figure) return std::unexpected(figure.error());
  Document document;
  SetFigure(*figure, document);
  document.title = figure->name;
  return document;
}

/// Reads a whole document, for a search for the controller of one clip.
Result<Document> ReadRepair(const Arguments& arguments) {
  if (auto fine =
          CheckAbsent(arguments, {"figure", "problem", "from", "handover"}, "cannot be given with --repair");
      !fine) {
    return std::unexpected(fine.error());
  }
  if (auto fine = CheckAbsent(arguments, {"sense", "rules", "controller", "duration"},
                              "cannot be given with --repair: the clip's own stays");
      !fine) {
    return std::unexpected(fine.error());
  }
  if (auto fine = CheckAbsent(arguments, {"joints", "ground"},
                              "cannot be given with --repair: the other clips would move differently");
      !fine) {
    return std::unexpected(fine.error());
  }
  if (!arguments.Has("clip"))
    return Fail(ErrorCode::kMissing, "--clip", "say which clip of the timeline, counted from 1");
  const std::string where = "--repair " + arguments.Last("repair");
  auto document = ReadDocument(arguments.Last("repair"));
  if (!document) return document;
  const auto clips = static_cast<long long>(document->timeline.size());
  if (clips < 2) return Fail(ErrorCode::kStructure, where, "has no clip that takes over from another one");
  const auto clip = arguments.Integer("clip", 2, clips, 2);
  if (!clip) return std::unexpected(clip.error());
  const auto index = static_cast<std::size_t>(*clip - 1);
  document->search = {};
  DropUnusedControllers(*document);
  if (document->controllers.size() >= static_cast<std::size_t>(kMaxControllers)) {
    return Fail(ErrorCode::kTooMany, where,
                "has " + std::to_string(kMaxControllers) + " controllers; there is no room for another one");
  }
  StartFrom(document->timeline[index].controller, *document);
  document->search.in_place_of = static_cast<int>(index);
  document->hash.reset();
  return document;
}

/// Adds the states in which other controllers leave the figure, from which the found controller must
/// continue.
Result<void> AddHandovers(const Arguments& arguments, Document& document) {
  for (const std::string& text : arguments.All("handover")) {
    const std::string where = "--handover " + text;
    const std::size_t mark = text.rfind('@');
    if (mark == std::string::npos) return Fail(ErrorCode::kSyntax, where, "must be DOC@SECONDS");
    const auto step = WholeSteps(text.substr(mark + 1), where, 1, kMaxSteps - 1);
    if (!step) return std::unexpected(step.error());
    const auto other = ReadDocument(text.substr(0, mark));
    if (!other) return std::unexpected(other.error());
    if (other->controllers.empty()) return Fail(ErrorCode::kMissing, where, "has no controller");
    if (!SameRods(*other, document)) {
      return Fail(ErrorCode::kStructure, where,
                  "is of another figure, \"" + other->figure.name + "\"; the search is for \"" +
                      document.figure.name + "\"");
    }
    if (!SameJoints(*other, document)) {
      return Fail(ErrorCode::kStructure, where,
                  "has joints of another strength than the search, in which it would leave the figure in "
                  "another state");
    }
    const auto controller = AddController(document, FirstControllerOf(*other));
    if (!controller) return Fail(controller.error().code, where, controller.error().Sentence());
    document.search.handovers.push_back({.controller = *controller, .step = *step});
  }
  const auto most = static_cast<std::size_t>(kMaxHandovers);
  if (document.search.handovers.size() <= most) return {};
  return Fail(ErrorCode::kTooMany, "--handover", "can be given " + std::to_string(most) + " times at most");
}

}  // namespace

Result<Request> ReadRequest(const Arguments& arguments) {
  if (arguments.Has("clip") && !arguments.Has("repair")) {
    return Fail(ErrorCode::kStructure, "--clip", "goes with --repair alone");
  }
  auto read = arguments.Has("repair")    ? ReadRepair(arguments)
              : arguments.Has("problem") ? ReadProblem(arguments)
              : arguments.Has("from")    ? ReadStart(arguments)
                                         : ReadNew(arguments);
  if (!read) return std::unexpected(read.error());
  Document& document = *read;
  if (arguments.Has("task")) {
    const auto task = IndexOf(kTaskNames, arguments.Last("task"), "--task");
    if (!task) return std::unexpected(task.error());
    document.task.kind = static_cast<TaskKind>(*task);
  }
  const auto algorithm = IndexOf(kAlgorithmNames, arguments.Last("search", "sphc"), "--search");
  if (!algorithm) return std::unexpected(algorithm.error());
  document.search.algorithm = static_cast<Algorithm>(*algorithm);
  if (auto set = SetProblemOptions(arguments, document); !set) return std::unexpected(set.error());
  if (!arguments.Has("repair")) document.duration_steps = document.task.duration_steps;
  const auto rules = arguments.Integer("rules", 1, kMaxRules, document.rules);
  if (!rules) return std::unexpected(rules.error());
  document.rules = static_cast<int>(*rules);
  const auto evaluations = arguments.Integer("evaluations", 1, 100'000'000, document.search.evaluations);
  if (!evaluations) return std::unexpected(evaluations.error());
  document.search.evaluations = static_cast<int>(*evaluations);
  const auto seed = arguments.Integer("seed", 0, 0xffffffffLL, 1);
  if (!seed) return std::unexpected(seed.error());
  document.search.seed = static_cast<std::uint32_t>(*seed);
  for (const std::string& option : arguments.All("search-option")) {
    if (auto set = SetSearchOption(option, document.search); !set) return std::unexpected(set.error());
  }
  const int own = static_cast<int>(document.controllers.size());
  if (auto added = AddHandovers(arguments, document); !added) return std::unexpected(added.error());
  if (auto valid = Validate(document); !valid) return std::unexpected(valid.error());
  return Request{.document = std::move(document), .own = own};
}

Result<void> PutFound(const Controller& found, int own, Document& document) {
  const int repaired = document.search.in_place_of;
  if (repaired >= 0) {
    const auto clip = static_cast<std::size_t>(repaired);
    const int before = document.timeline[clip].controller;
    // If the search found no improvement, the clip keeps its controller and its name.
    if (document.controllers[static_cast<std::size_t>(before)].genes != found.genes) {
      const auto added = AddController(document, found);
      if (!added) return std::unexpected(added.error());
      document.timeline[clip].controller = *added;
    }
    document.search.in_place_of = document.search.start = -1;
    DropUnusedControllers(document);
    return {};
  }
  document.search.handovers.clear();
  document.controllers.resize(static_cast<std::size_t>(own));
  document.controllers.push_back(found);
  document.timeline = {{.controller = own, .start_step = 0}};
  return {};
}

}  // namespace gaitsmith::shell
