// SPDX-License-Identifier: MIT
// A document: everything the user made or found, and everything that determines the bits of its motion. One
// schema serves three encodings: JSON in a file (json.h), bits in a link and in a worker message (binary.h,
// link.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/lineage.h"
#include "core/numeric/error.h"
#include "core/rollout/motion.h"
#include "core/search/search.h"
#include "core/spacetime/planned_motion.h"

namespace gaitsmith {

inline constexpr int kMaxControllers = 64;
inline constexpr int kMaxClips = 256;
inline constexpr int kMaxPushes = 256;
inline constexpr int kMaxNameBytes = 80;

/// Display settings. They never change a bit of the motion.
struct View {
  float speed = 1.0f;   // playback speed, [0.01, 16]
  int panel = 1;        // its number in shell/workspace/panels.h, [0, 15]
  bool trail = true;    // path of the centre of mass
  bool forces = true;   // contact forces
  bool poses = true;    // lettered past poses
  bool torques = true;  // how much of their joints' strength the limbs use, of limited joints
};

struct Document {
  std::string title;
  /// Version of the physical model, [1, kModelVersion]. A literal, because old documents keep their model.
  int model = 1;
  Figure figure;
  std::vector<Rod> drawn;  // the figure's rods before a search changed the body; empty if none did
  Environment environment;
  StartState start;
  std::vector<Push> pushes;  // sorted by step
  Task task;
  SenseSpec senses;  // for the next search; each controller has its own
  int rules = 10;    // for the next search: a bank's rules, a network's hidden nodes or a trajectory's knots
  ControllerKind kind = ControllerKind::kRules;  // for the next search
  SearchSettings search;
  std::vector<Controller> controllers;
  std::vector<Clip> timeline;  // sorted by start, the first at 0
  int duration_steps = 500;    // of the displayed motion, [1, kMaxSteps]
  View view;
  Plan plan;                          // a motion with keyframes
  Lineage lineage;                    // how the motion was bred, if it was
  std::optional<std::uint64_t> hash;  // of the trajectory, as the author's machine computed it
};

/// Checks whether a text can be a name or a title: at most kMaxNameBytes of well-formed UTF-8 without control
/// characters. The error says what is wrong, but not where.
[[nodiscard]] Result<void> CheckName(std::string_view text);

/// Gives a document another figure, with a model that can move it on its ground. What figures of springs
/// cannot have goes: a search for networks or for bodies, and keyframes.
void SetFigure(const Figure& figure, Document& document);

/// Checks every number, name and reference. Returns the first fault: where and what.
[[nodiscard]] Result<void> Validate(const Document&);

/// The script of a document's motion. @param document must be valid and outlive the script
[[nodiscard]] Script ScriptOf(const Document& document);

/// The motion that the document describes. @param document must be valid
[[nodiscard]] Motion Simulate(const Document& document);

/// The step at which a clip of the timeline ends: the start of the next clip, or the end of the motion. May
/// be before the clip's start if the motion ends earlier. @param clip an index of the timeline
[[nodiscard]] int EndOf(const Document& document, std::size_t clip);

/// The figure as it was before a search changed its body.
[[nodiscard]] Figure AsDrawn(const Document&);

/// The scene of the document's plan.
[[nodiscard]] PlanScene SceneOf(const Document&);

/// The problem defined by the search settings.
[[nodiscard]] Problem ProblemOf(const Document&);
[[nodiscard]] SearchSpace SpaceOf(const Document&);
/// The genome that the search begins with; empty: a random one.
[[nodiscard]] Genome StartOf(const Document&);

/// Gives a document the body of a genome that the search of `searched` found, if that changes bodies.
/// @param to may be `searched`; its figure has the same tree. @return the genome's controller, without a name
[[nodiscard]] Controller TakeFound(const Document& searched, Genome genome, Document& to);

/// Whether two controllers of one figure have the same kind, senses and number of rules, so that their genes
/// mean the same.
[[nodiscard]] bool SameShape(const Controller&, const Controller&);

/// Whether a search of the document can begin with this controller.
[[nodiscard]] bool FitsSearch(const Document&, const Controller&);

/// The problem in which one controller of the document, active from the start, makes the displayed motion.
/// With exactly one clip its evaluation has the document's own trajectory hash.
[[nodiscard]] Problem ReplayProblem(const Document&, const Controller&);

/// 16 hexadecimal digits.
[[nodiscard]] std::string HashText(std::uint64_t hash);

}  // namespace gaitsmith
