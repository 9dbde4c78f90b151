// SPDX-License-Identifier: MIT
#include "shell/words/motion_name.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/transition.h"
#include "core/world/environment.h"
#include "shell/words/figure_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// A body is the longest rod or the height of the centre of mass at the start, whichever is more.
constexpr float kTravelBodies = 1.0f;  // from here on it travels
constexpr float kJumpBodies = 0.5f;    // rise of the centre of mass from which it jumps...
constexpr float kJumpReach = 4.0f;     // ...unless it travels this many times as far
constexpr float kTurned = 0.9f;        // net turns of the root
constexpr float kUpright = 0.5f;       // mean cosine of the root's turn
// People change from walking to running at about this Froude number, v² / (g · hip height).
constexpr float kRunFroude = 0.5f;

// To the left and to the right, in the order of Gait.
constexpr std::array<std::array<const char*, 2>, 5> kWays = {{{"Move left", "Move right"},
                                                              {"Run left", "Run right"},
                                                              {"Hop left", "Hop right"},
                                                              {"Crawl left", "Crawl right"},
                                                              {"Roll left", "Roll right"}}};
constexpr std::array<const char*, 2> kWalk = {"Walk left", "Walk right"};

const char* WayName(std::string_view figure, const Terms& terms, float speed_mps) {
  const auto right = static_cast<std::size_t>(terms.travel_m > 0.0f);
  Gait gait = GaitOf(figure);
  if (terms.rotations >= kTurned) {
    gait = Gait::kRoll;
  } else if (terms.upright < kUpright) {
    gait = Gait::kCrawl;
  }
  const float froude = speed_mps * speed_mps / (kStandardGravity * std::max(terms.start_height_m, 0.01f));
  return gait == Gait::kRun && froude < kRunFroude ? kWalk[right]
                                                   : kWays[static_cast<std::size_t>(gait)][right];
}

struct Name {
  const char* words;
  float way_m;  // 0 if it stays about where it is
};

/// @param figure its name: a frog hops where an ostrich runs
Name NameOf(std::string_view figure, const Motion& motion) {
  const int last = motion.Frames() - 1;
  const Terms& terms = motion.TermsAt(last);
  if (terms.broke_physics) return {"", 0.0f};
  const float body_m = std::max(terms.start_height_m, motion.Bones().longest_rod_m);
  const float way_m = std::abs(terms.travel_m);
  const bool travels = way_m >= kTravelBodies * body_m;
  const float rise_m = terms.max_cm_height_m - terms.start_height_m;
  const bool turned = terms.rotations >= kTurned;
  if (rise_m >= kJumpBodies * body_m && way_m < kJumpReach * rise_m)
    return {turned ? "Somersault" : "Jump", travels ? way_m : 0.0f};
  const float speed_mps = way_m / (static_cast<float>(std::max(last, 1)) * motion.StepS());
  if (travels) return {WayName(figure, terms, speed_mps), way_m};
  if (turned) return {"Turn", 0.0f};
  return {terms.upright >= kUpright ? "Stand" : "Fall", 0.0f};
}

}  // namespace

std::string MotionName(const Document& d, int controller, std::span<const Controller> others) {
  const auto [words, way_m] = NameOf(d.figure.name, UsualMotion(d, controller));
  std::string name = words;
  const Genome& genes = d.controllers[static_cast<std::size_t>(controller)].genes;
  const bool taken = std::ranges::any_of(
      others, [&](const Controller& other) { return other.name == name && other.genes != genes; });
  if (way_m == 0.0f || !taken) return name;
  return name + ", " + PlainFixed(static_cast<double>(way_m), way_m < 10.0f ? 1 : 0) + " m";
}

}  // namespace gaitsmith::shell
