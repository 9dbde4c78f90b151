// SPDX-License-Identifier: MIT
#include "core/document/archive.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "core/rollout/models.h"
#include "core/world/terrain.h"

namespace gaitsmith {

std::string RealText(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

std::string Archive::PathOf(std::string_view name) const {
  std::string where;
  for (const std::string& part : path_) where += (where.empty() || part.front() == '[' ? "" : ".") + part;
  if (!name.empty()) where += (where.empty() ? "" : ".") + std::string(name);
  return where;
}

void Archive::FailAt(std::string_view name, ErrorCode code, std::string what) {
  if (!error_) error_ = Error{code, PathOf(name), std::move(what)};
}

void Archive::Enter(std::string_view name) { path_.emplace_back(name); }
void Archive::EnterElement(std::size_t index) { path_.push_back("[" + std::to_string(index) + "]"); }

void Archive::CheckReal(std::string_view name, float& value, float low, float high) {
  if (!std::isfinite(value)) return FailAt(name, ErrorCode::kNotFinite, "must be a finite number");
  if (value < low || value > high) {
    return FailAt(name, ErrorCode::kOutOfRange,
                  "must be from " + RealText(low) + " to " + RealText(high) + ", is " + RealText(value));
  }
  value += 0.0f;  // turns -0 into 0, so that equal documents have equal bits
}

void Archive::CheckInteger(std::string_view name, std::int64_t value, std::int64_t low, std::int64_t high) {
  if (value < low || value > high) {
    FailAt(name, ErrorCode::kOutOfRange,
           "must be from " + std::to_string(low) + " to " + std::to_string(high) + ", is " +
               std::to_string(value));
  }
}

void Archive::CheckModel(std::string_view name, std::int64_t model) {
  if (model < 1 || model > kModelVersion) {
    FailAt(name, ErrorCode::kUnknownVersion,
           "needs physical model " + std::to_string(model) + ", but this Gaitsmith has models up to " +
               std::to_string(kModelVersion) + ": a newer one is needed");
  }
}

Result<void> CheckName(std::string_view text) {
  if (text.size() > kMaxNameBytes) {
    return Fail(ErrorCode::kTooMany, "",
                "at most " + std::to_string(kMaxNameBytes) + " bytes, has " + std::to_string(text.size()));
  }
  // Well-formed UTF-8 without control characters, so that any page can display it.
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int more = lead < 0x80   ? 0
                     : lead < 0xc2 ? -1
                     : lead < 0xe0 ? 1
                     : lead < 0xf0 ? 2
                     : lead < 0xf5 ? 3
                                   : -1;
    unsigned code = more <= 0 ? lead : lead & (0x3fu >> more);
    bool good = more >= 0 && lead >= 0x20 && lead != 0x7f && i + static_cast<std::size_t>(more) < text.size();
    for (int k = 1; good && k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      good = (next & 0xc0u) == 0x80u;
      code = code << 6 | (next & 0x3fu);
    }
    const bool overlong = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
    if (!good || overlong || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) {
      return Fail(ErrorCode::kSyntax, "",
                  "must be printable UTF-8 text, but byte " + std::to_string(i) + " is not");
    }
    i += static_cast<std::size_t>(more) + 1;
  }
  return {};
}

void Archive::CheckText(std::string_view name, const std::string& text) {
  if (const auto good = CheckName(text); !good) FailAt(name, good.error().code, good.error().what);
}

void Archive::CheckCount(std::string_view name, std::size_t count, std::size_t most) {
  if (count > most) {
    FailAt(name, ErrorCode::kTooMany,
           "at most " + std::to_string(most) + ", there are " + std::to_string(count));
  }
}

namespace {

std::string Element(const char* list, std::size_t index, const char* field) {
  return std::string(list) + "[" + std::to_string(index) + "]." + field;
}

Result<void> CheckSenses(const SenseSpec& senses, const std::string& where) {
  if (senses.tau_min_s > senses.tau_max_s) {
    return Fail(
        ErrorCode::kOutOfRange, where + ".tau_max_s",
        "must be at least tau_min_s = " + RealText(senses.tau_min_s) + ", is " + RealText(senses.tau_max_s));
  }
  return {};
}

Result<void> CheckKind(ControllerKind kind, const SenseSpec& senses, const std::string& where) {
  if (kind == ControllerKind::kNetwork && senses.kind != SenseKind::kPhysical) {
    return Fail(ErrorCode::kStructure, where,
                senses.kind == SenseKind::kTimer ? "a network has physical senses, not a timer"
                                                 : "a network has physical senses, and no sight");
  }
  if (kind == ControllerKind::kTrajectory && senses.kind != SenseKind::kTimer)
    return Fail(ErrorCode::kStructure, where, "a trajectory follows a timer and has no other senses");
  return {};
}

Result<void> CheckControllers(const Document& d, const std::vector<Controller>& list, const char* name) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Controller& c = list[i];
    if (auto senses = CheckSenses(c.senses, Element(name, i, "senses")); !senses) return senses;
    if (auto kind = CheckKind(c.kind, c.senses, Element(name, i, "kind")); !kind) return kind;
    const std::size_t genes = c.Shape(CountPorts(d.model, d.figure)).Genes();
    if (c.genes.size() != genes) {
      return Fail(ErrorCode::kStructure, Element(name, i, "rules"),
                  "is for another figure: it has " + std::to_string(c.genes.size()) +
                      " genes, this figure needs " + std::to_string(genes));
    }
  }
  return {};
}

/// @param where of a task
Result<void> CheckShown(const Demonstration& shown, const Figure& figure, const std::string& where) {
  for (std::size_t i = 1; i < shown.way.size(); ++i) {
    if (shown.way[i].step <= shown.way[i - 1].step)
      return Fail(ErrorCode::kStructure, where + "." + Element("shown.way", i, "step"),
                  "must be after the point before it");
  }
  if (!shown.pose_rad.empty() && figure.HasSprings())
    return Fail(ErrorCode::kStructure, where + ".shown.pose",
                "is for figures of rods, and this one has springs");
  const auto joints = static_cast<std::size_t>(figure.Joints());
  if (!shown.pose_rad.empty() && shown.pose_rad.size() != joints)
    return Fail(ErrorCode::kStructure, where + ".shown.pose",
                "must have one angle for each of the " + std::to_string(joints) + " joints, has " +
                    std::to_string(shown.pose_rad.size()));
  return {};
}

Result<void> CheckLineage(const Document& d) {
  const auto& [founders, rounds, shown] = d.lineage;
  if (auto fits = CheckControllers(d, founders, "lineage.founders"); !fits) return fits;
  for (std::size_t i = 1; i < founders.size(); ++i) {
    if (!SameShape(founders[i], founders[0]))
      return Fail(ErrorCode::kStructure, Element("lineage.founders", i, "senses"),
                  "founders must have the same kind, senses and number of rules");
  }
  if (founders.empty() != rounds.empty())
    return Fail(ErrorCode::kMissing, "lineage", "needs founders and rounds, or neither");
  if (static_cast<std::size_t>(shown) >= std::max<std::size_t>(1, rounds.size()))
    return Fail(ErrorCode::kStructure, "lineage.shown", "there is no round " + std::to_string(shown));
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    const BreedRound& round = rounds[i];
    const std::string task = "lineage.rounds[" + std::to_string(i) + "].task";
    if (auto fits = CheckShown(round.task.shown, d.figure, task); !fits) return fits;
    if (round.parent >= static_cast<int>(i))
      return Fail(ErrorCode::kStructure, Element("lineage.rounds", i, "parent"), "must be an earlier round");
    const std::size_t choices = round.parent < 0 ? founders.size() : kLitter;
    if (round.picks == 0 || round.picks >> choices != 0)
      return Fail(ErrorCode::kOutOfRange, Element("lineage.rounds", i, "picks"),
                  "must pick from " + std::to_string(choices) + " motions, one bit each");
  }
  return {};
}

/// Checks the settings of a search that depend on each other.
Result<void> CheckSearch(const Document& d) {
  const SearchSettings& search = d.search;
  if (search.start >= 0) {
    if (static_cast<std::size_t>(search.start) >= d.controllers.size()) {
      return Fail(ErrorCode::kStructure, "search.start",
                  "there is no controller " + std::to_string(search.start) + ", the document has " +
                      std::to_string(d.controllers.size()));
    }
    if (!FitsSearch(d, d.controllers[static_cast<std::size_t>(search.start)])) {
      return Fail(
          ErrorCode::kStructure, "search.start",
          "must be a controller of the kind, the senses and the number of rules that are searched for");
    }
  }
  if (search.in_place_of >= 0) {
    const auto clip = static_cast<std::size_t>(search.in_place_of);
    if (clip >= d.timeline.size()) {
      return Fail(ErrorCode::kStructure, "search.in_place_of",
                  "there is no clip " + std::to_string(clip) + ", the timeline has " +
                      std::to_string(d.timeline.size()));
    }
    if (EndOf(d, clip) <= d.timeline[clip].start_step) {
      return Fail(ErrorCode::kStructure, "search.in_place_of",
                  "the motion ends before clip " + std::to_string(clip) + " begins");
    }
    if (!search.handovers.empty()) {
      return Fail(ErrorCode::kStructure, "search.handovers", "cannot go together with in_place_of");
    }
  }
  for (std::size_t i = 0; i < search.handovers.size(); ++i) {
    const int controller = search.handovers[i].controller;
    if (static_cast<std::size_t>(controller) >= d.controllers.size()) {
      return Fail(ErrorCode::kStructure, Element("search.handovers", i, "controller"),
                  "there is no controller " + std::to_string(controller) + ", the document has " +
                      std::to_string(d.controllers.size()));
    }
  }
  const int population = PopulationOf(search);
  if (search.evaluations < population) {
    return Fail(ErrorCode::kOutOfRange, "search.evaluations",
                "must be at least the population, " + std::to_string(population) + ", is " +
                    std::to_string(search.evaluations));
  }
  if (search.algorithm != Algorithm::kCmaEs) return {};
  if (search.cma.population != 0 && search.cma.population < 4) {
    return Fail(ErrorCode::kOutOfRange, "search.cma.population",
                "must be 0 (automatic) or at least 4, is " + std::to_string(search.cma.population));
  }
  const std::size_t genes = ProblemOf(d).Shape().Genes();
  if (search.cma.covariance == Covariance::kFull && genes > kMaxCovarianceGenes) {
    return Fail(ErrorCode::kTooMany, "search.cma.covariance",
                "can be full for at most " + std::to_string(kMaxCovarianceGenes) + " genes, there are " +
                    std::to_string(genes));
  }
  return {};
}

/// What a figure of springs can have.
Result<void> CheckSprings(const Document& d) {
  const auto fail = [](std::string where, const char* what) {
    return Fail(ErrorCode::kStructure, std::move(where), what);
  };
  if (const char* why = WhyNotModel(d.model, d.figure); why != nullptr) return fail("model", why);
  if (!d.figure.HasSprings()) return {};
  const char* follows = "a figure of springs follows rules or curves, not a network";
  if (d.kind == ControllerKind::kNetwork) return fail("kind", follows);
  for (const auto& [list, name] :
       {std::pair(&d.controllers, "controllers"), std::pair(&d.lineage.founders, "lineage.founders")}) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      if ((*list)[i].kind == ControllerKind::kNetwork) return fail(Element(name, i, "kind"), follows);
    }
  }
  if (!d.drawn.empty()) return fail("drawn", "is for figures of rods, and this one has springs");
  if (d.search.body != BodyFreedom::kNone)
    return fail("search.body", "the bodies of figures of springs cannot be searched");
  if (!d.plan.Empty() || !d.plan.solved.unknowns.empty())
    return fail("plan", "figures of springs have no keyframes");
  return {};
}

Result<void> CheckPlan(const Document& d) {
  if (d.figure.HasSprings()) return {};
  const PlanScene scene = SceneOf(d);
  if (auto plan = Validate(d.plan, scene.skeleton); !plan) return plan;
  const PlanSolution& solved = d.plan.solved;
  if (solved.unknowns.empty()) return {};
  const auto needed = static_cast<std::size_t>(UnknownsOf(scene, {solved.degree, solved.pieces_per_second}));
  if (solved.unknowns.size() == needed) return {};
  return Fail(ErrorCode::kStructure, "plan.solved.unknowns",
              "must be " + std::to_string(needed) + " for this figure and plan, are " +
                  std::to_string(solved.unknowns.size()));
}

}  // namespace

const char* WhyNotModel(int model, const Figure& figure) {
  if (figure.HasSprings()) return model == kSpringModel ? nullptr : "must be 3 for a figure of springs";
  return model == kSpringModel ? "is for figures of springs, and this one has rods" : nullptr;
}

Result<void> CheckReferences(const Document& d) {
  if (auto figure = Validate(d.figure); !figure) {
    return Fail(figure.error().code, "figure." + figure.error().where, figure.error().what);
  }
  if (auto springs = CheckSprings(d); !springs) return springs;
  if (auto ground = Validate(d.environment.ground); !ground) {
    return Fail(ground.error().code, "environment." + ground.error().where, ground.error().what);
  }
  if (!d.environment.ground.empty() && d.model < kFirstDrawnGround) {
    return Fail(ErrorCode::kStructure, "environment.ground",
                "needs limited joints (model 2); in model 1 the ground is level");
  }
  if (!d.drawn.empty()) {
    const Figure drawn = AsDrawn(d);
    if (auto figure = Validate(drawn); !figure)
      return Fail(figure.error().code, "drawn" + figure.error().where.substr(4), figure.error().what);
    if (!SameTree(drawn, d.figure))
      return Fail(ErrorCode::kStructure, "drawn", "must have the rods of the figure, attached alike");
  }
  if (auto senses = CheckSenses(d.senses, "senses"); !senses) return senses;
  if (auto kind = CheckKind(d.kind, d.senses, "kind"); !kind) return kind;
  if (auto fits = CheckControllers(d, d.controllers, "controllers"); !fits) return fits;
  if (auto shown = CheckShown(d.task.shown, d.figure, "task"); !shown) return shown;
  if (auto lineage = CheckLineage(d); !lineage) return lineage;
  if (auto search = CheckSearch(d); !search) return search;
  if (auto plan = CheckPlan(d); !plan) return plan;
  for (std::size_t i = 0; i < d.timeline.size(); ++i) {
    const Clip& clip = d.timeline[i];
    if (static_cast<std::size_t>(clip.controller) >= d.controllers.size()) {
      return Fail(ErrorCode::kStructure, Element("timeline", i, "controller"),
                  "there is no controller " + std::to_string(clip.controller) + ", the document has " +
                      std::to_string(d.controllers.size()));
    }
    if (i == 0 ? clip.start_step != 0 : clip.start_step <= d.timeline[i - 1].start_step) {
      return Fail(
          ErrorCode::kStructure, Element("timeline", i, "start_step"),
          i == 0 ? "the first clip must start at 0" : "must be after the start of the clip before it");
    }
  }
  for (std::size_t i = 0; i < d.pushes.size(); ++i) {
    if (d.pushes[i].endpoint >= d.figure.Endpoints()) {
      return Fail(ErrorCode::kStructure, Element("pushes", i, "endpoint"),
                  "there is no endpoint " + std::to_string(d.pushes[i].endpoint) + ", the figure has 0 to " +
                      std::to_string(d.figure.Endpoints() - 1));
    }
    if (i > 0 && d.pushes[i].step < d.pushes[i - 1].step) {
      return Fail(ErrorCode::kStructure, Element("pushes", i, "step"), "pushes must be sorted by step");
    }
  }
  return {};
}

}  // namespace gaitsmith
