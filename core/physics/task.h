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

/// The secondary terms of Table 3, in its order.
enum class StyleTerm { kMaxCmHeight, kSlipSum, kRotations };
inline constexpr int kStyleTerms = 3;
inline constexpr std::array<std::string_view, kStyleTerms> kStyleTermNames = {"max_cm_height", "slip_sum",
                                                                              "rotations"};

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

  [[nodiscard]] float Style(StyleTerm term) const {
    switch (term) {
      case StyleTerm::kMaxCmHeight:
        return max_cm_height_m;
      case StyleTerm::kSlipSum:
        return slip_sum_m;
      case StyleTerm::kRotations:
        return rotations;
    }
    return 0.0f;
  }
};

/// Score of a motion that broke physics: worse than any real one.
inline constexpr float kVoidScore = -1e9f;

/// The primary term alone.
[[nodiscard]] float Primary(const Task&, const Terms&);

/// Fitness: primary term + sum of weight * secondary term; kVoidScore for a motion that broke physics or
/// whose fitness is not a number.
[[nodiscard]] float Fitness(const Task&, const Terms&);

/// "travel", "travel-right", "travel-left", "jump": names on the command line and in documents.
inline constexpr std::array<std::string_view, 4> kTaskNames = {"travel", "travel-right", "travel-left",
                                                               "jump"};

}  // namespace gaitsmith
