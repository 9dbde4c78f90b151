// SPDX-License-Identifier: MIT
// A document: everything a person made or found, and everything that fixes the bits of its motion. One
// schema, three encodings: JSON in a file (json.h), bits in a link and in a worker message (binary.h,
// link.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"
#include "core/rollout/motion.h"
#include "core/search/search.h"

namespace gaitsmith {

inline constexpr int kMaxControllers = 64;
inline constexpr int kMaxClips = 256;
inline constexpr int kMaxPushes = 256;
inline constexpr int kMaxNameBytes = 80;

/// What is shown and how; never changes a bit of the motion.
struct View {
  float speed = 1.0f;  // of playback, [0.01, 16]
  int panel = 1;       // its number in shell/session/panels.h, [0, 15]
  bool trail = true;   // path of the centre of mass
  bool forces = true;  // contact forces
  bool poses = true;   // lettered past poses
};

struct Document {
  std::string title;
  int model =
      1;  // version of the physical model, [1, kModelVersion]; a literal, for old documents keep theirs
  Figure figure;
  Environment environment;
  StartState start;
  std::vector<Push> pushes;  // sorted by step
  Task task;
  SenseSpec senses;                              // for the next search; each controller has its own
  int rules = 10;                                // likewise; or a network's hidden nodes
  ControllerKind kind = ControllerKind::kRules;  // likewise
  SearchSettings search;
  std::vector<Controller> controllers;
  std::vector<Clip> timeline;  // sorted by start, the first at 0
  int duration_steps = 500;    // of the motion shown, [1, kMaxSteps]
  View view;
  std::optional<std::uint64_t> hash;  // of the trajectory, as its maker saw it
};

/// Whether a text can be a name or a title: at most kMaxNameBytes of well-formed UTF-8 without control
/// characters. The error says what is wrong, not where.
[[nodiscard]] Result<void> CheckName(std::string_view text);

/// Checks every number, name and reference. The first fault is returned: where and what.
[[nodiscard]] Result<void> Validate(const Document&);

/// Who acts where in a document, as a motion takes it. @param document valid; must outlive the script
[[nodiscard]] Script ScriptOf(const Document& document);

/// The motion the document describes. @param document valid
[[nodiscard]] Motion Simulate(const Document& document);

/// The step at which a clip of the timeline ends: where the next one takes over, or with the motion. May lie
/// before its start, in a document whose motion ends before that. @param clip an index of the timeline
[[nodiscard]] int EndOf(const Document& document, std::size_t clip);

/// What its search settings ask for.
[[nodiscard]] Problem ProblemOf(const Document&);
[[nodiscard]] SearchSpace SpaceOf(const Document&);

/// Whether a search of the document may begin with the controller.
[[nodiscard]] bool SuitsSearch(const Document&, const Controller&);

/// The problem in which a controller of the document, alone from the start, makes the motion shown; with
/// exactly one clip its evaluation has the document's own trajectory hash.
[[nodiscard]] Problem ReplayProblem(const Document&, const Controller&);

/// 16 hexadecimal digits.
[[nodiscard]] std::string HashText(std::uint64_t hash);

}  // namespace gaitsmith
