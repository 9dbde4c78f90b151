// SPDX-License-Identifier: MIT
// The measurements of a motion, and the one table of style terms: their order, names, units and values.
// docs/style.md defines them.
#pragma once

#include <array>
#include <string_view>

namespace gaitsmith {

/// The secondary terms: those of Table 3 [Fukunaga 1994], in its order, then our own.
enum class StyleTerm {
  kMaxCmHeight,
  kSlipSum,
  kRotations,
  kEffort,
  kUpright,
  kSmoothness,
  kHeadHeight,
  kOnWay,
  kInPose,
  kWork,
  kPeakPower,
  kCostOfTransport,
};

/// The measurements of one motion.
struct Terms {
  float travel_m = 0.0f;         // of the centre of mass, rightward positive
  float start_height_m = 0.0f;   // of the centre of mass
  float max_cm_height_m = 0.0f;  // greatest height of the centre of mass
  float slip_sum_m = 0.0f;       // path of endpoints that bear load in a step and in the step before
  float rotations = 0.0f;        // |turns| of the root rod from start to end
  bool broke_physics = false;    // a guard tripped: see kMaxPenetration and the limits after it

  // Our own terms, 0 unless they were requested. See docs/style.md.
  float effort_rad = 0.0f;         // sum over joints and steps of |change of angle|, or of muscles' rests
  float upright = 0.0f;            // mean of cos(turn of the root rod from the drawn pose), [-1, 1]
  float smoothness_radps2 = 0.0f;  // minus the mean of |change of a joint's rate| per second; 0 is smoothest
  float head_height_m = 0.0f;      // mean height of the head (Skeleton::head) above ground
  float on_way_m = 0.0f;           // minus the mean distance from a way that was shown; 0 if none was
  float in_pose_rad = 0.0f;        // minus the mean difference from a pose that was shown; 0 if none was
  float work_j = 0.0f;             // by the muscles, gained or lost: sum over joints and steps of |work|
  float peak_power_wpkg = 0.0f;    // greatest of all steps, over the figure's mass
  float cost_of_transport = 0.0f;  // work over weight and |travel|

  [[nodiscard]] float Style(StyleTerm term) const;
};

/// A style term's row in the table.
struct StyleTermRow {
  std::string_view name;  // in documents and on the command line
  std::string_view unit;  // "" for a pure number
  float Terms::* value;
  int since;  // first version of the binary format that has its weight
  // Per unit, for figures that have not been calibrated: a clear preference, and one that leaves travel
  // first.
  float usual_weight, gentle_weight;
};

/// Number of the paper's terms. Every motion measures them. StyleMeter measures the further terms, and only
/// if a task gives them a weight.
inline constexpr int kPaperTerms = 3;

/// In the order of StyleTerm. New terms go to the end, because documents store the weights in this order.
inline constexpr auto kStyleTable = std::to_array<StyleTermRow>({
    {"max_cm_height", "m", &Terms::max_cm_height_m, 1, 10.0f, 5.6f},
    {"slip_sum", "m", &Terms::slip_sum_m, 1, 0.6f, 0.27f},
    {"rotations", "", &Terms::rotations, 1, 10.0f, 3.7f},
    {"effort", "rad", &Terms::effort_rad, 2, 0.05f, 0.05f},
    {"upright", "", &Terms::upright, 2, 5.0f, 5.0f},
    {"smoothness", "rad/s^2", &Terms::smoothness_radps2, 2, 0.2f, 0.2f},
    {"head_height", "m", &Terms::head_height_m, 2, 2.0f, 2.0f},
    {"on_way", "m", &Terms::on_way_m, 6, 10.0f, 2.0f},
    {"in_pose", "rad", &Terms::in_pose_rad, 6, 20.0f, 5.0f},
    {"work", "J", &Terms::work_j, 7, 0.005f, 0.005f},
    {"peak_power", "W/kg", &Terms::peak_power_wpkg, 7, 0.005f, 0.005f},
    {"cost_of_transport", "", &Terms::cost_of_transport, 7, 3.0f, 3.0f},
});
inline constexpr int kStyleTerms = static_cast<int>(kStyleTable.size());
/// Number of the first terms, which need nothing but a motion.
inline constexpr int kFreeTerms = static_cast<int>(StyleTerm::kOnWay);
/// The first of the terms of the muscles, which need nothing but a motion either. Those between are measured
/// against what was shown.
inline constexpr int kWorkTerms = static_cast<int>(StyleTerm::kWork);

inline constexpr std::array<std::string_view, kStyleTerms> kStyleTermNames = [] {
  std::array<std::string_view, kStyleTerms> names;
  for (std::size_t term = 0; term < names.size(); ++term) names[term] = kStyleTable[term].name;
  return names;
}();

inline float Terms::Style(StyleTerm term) const {
  return this->*kStyleTable[static_cast<std::size_t>(term)].value;
}

/// Which of our own terms are measured, in their order.
using FurtherTerms = std::array<bool, kStyleTerms - kPaperTerms>;
inline constexpr FurtherTerms kAllFurtherTerms = [] {
  FurtherTerms all;
  all.fill(true);
  return all;
}();
/// Those of the free terms, of which traits are made (core/signal/traits.h).
inline constexpr FurtherTerms kFreeFurtherTerms = [] {
  FurtherTerms free{};
  for (int term = kPaperTerms; term < kFreeTerms; ++term)
    free[static_cast<std::size_t>(term - kPaperTerms)] = true;
  return free;
}();

}  // namespace gaitsmith
