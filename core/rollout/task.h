// SPDX-License-Identifier: MIT
// What counts as a good motion: a primary term plus weighted secondary terms (style) [Fukunaga 1994,
// section 4.1].
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace gaitsmith {

enum class TaskKind {
  kTravel,       // |distance| the centre of mass has moved, either way [m]
  kTravelRight,  // distance to the right [m]
  kTravelLeft,   // distance to the left [m]
  kJump,         // greatest height of the centre of mass above its start [m]
};

/// The secondary terms: those of Table 3, in its order, then further ones. docs/style.md defines them.
enum class StyleTerm {
  kMaxCmHeight,
  kSlipSum,
  kRotations,
  kEffort,
  kUpright,
  kSmoothness,
  kHeadHeight,
};
inline constexpr int kPaperTerms = 3;
inline constexpr int kStyleTerms = 7;
inline constexpr std::array<std::string_view, kStyleTerms> kStyleTermNames = {
    "max_cm_height", "slip_sum", "rotations", "effort", "upright", "smoothness", "head_height"};

/// Which of the further terms are measured, in their order.
using FurtherTerms = std::array<bool, kStyleTerms - kPaperTerms>;
inline constexpr FurtherTerms kAllFurtherTerms = {true, true, true, true};

struct Task {
  TaskKind kind = TaskKind::kTravel;
  int duration_steps = 500;  // T in whole steps, [1, kMaxSteps]; the paper's motions: 5 to 10 s
  std::array<float, kStyleTerms> weights = {};  // of the secondary terms, [-1000, 1000]
};

/// What was measured during one motion.
struct Terms {
  float travel_m = 0.0f;         // of the centre of mass, rightward positive
  float start_height_m = 0.0f;   // of the centre of mass
  float max_cm_height_m = 0.0f;  // greatest height of the centre of mass
  float slip_sum_m = 0.0f;       // path of endpoints that bear load now and did a step before
  float rotations = 0.0f;        // |turns| of the root rod from start to end
  bool broke_physics = false;    // a guard tripped: see kMaxPenetration and its neighbours

  // The further terms; 0 where nobody asked for them. See docs/style.md.
  float effort_rad = 0.0f;         // sum over joints and steps of |change of angle|
  float upright = 0.0f;            // mean of cos(turn of the root rod from the drawn pose), [-1, 1]
  float smoothness_radps2 = 0.0f;  // minus the mean of |change of a joint's rate| a second: 0 is smoothest
  float head_height_m = 0.0f;      // mean height of the head (Skeleton::head) above ground

  [[nodiscard]] float Style(StyleTerm term) const {
    switch (term) {
      case StyleTerm::kMaxCmHeight:
        return max_cm_height_m;
      case StyleTerm::kSlipSum:
        return slip_sum_m;
      case StyleTerm::kRotations:
        return rotations;
      case StyleTerm::kEffort:
        return effort_rad;
      case StyleTerm::kUpright:
        return upright;
      case StyleTerm::kSmoothness:
        return smoothness_radps2;
      case StyleTerm::kHeadHeight:
        return head_height_m;
    }
    return 0.0f;
  }
};

/// Score of a motion that broke physics: worse than any real one.
inline constexpr float kVoidScore = -1e9f;

/// The primary term alone.
[[nodiscard]] float Primary(const Task&, const Terms&);

/// The further terms whose weights are not 0: what a search has to measure.
[[nodiscard]] FurtherTerms WeightedFurtherTerms(const Task&);

/// Fitness: primary term + sum of weight * secondary term; kVoidScore for a motion that broke physics or
/// whose fitness is not a number. Reads no further term whose weight is 0.
[[nodiscard]] float Fitness(const Task&, const Terms&);

/// "travel", "travel-right", "travel-left", "jump": names on the command line and in documents.
inline constexpr std::array<std::string_view, 4> kTaskNames = {"travel", "travel-right", "travel-left",
                                                               "jump"};

}  // namespace gaitsmith
