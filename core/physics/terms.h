// SPDX-License-Identifier: MIT
// What is measured of a motion, and the one table of style terms: their order, names, units and values.
// docs/style.md defines them.
#pragma once

#include <array>
#include <string_view>

namespace gaitsmith {

/// The secondary terms: those of Table 3 [Fukunaga 1994], in its order, then further ones.
enum class StyleTerm {
  kMaxCmHeight,
  kSlipSum,
  kRotations,
  kEffort,
  kUpright,
  kSmoothness,
  kHeadHeight,
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

  [[nodiscard]] float Style(StyleTerm term) const;
};

/// A style term as documents, scores and people know it.
struct StyleTermRow {
  std::string_view name;  // in documents and on the command line
  std::string_view unit;  // "" for a pure number
  float Terms::* value;
  int since;           // version of the binary format that first has its weight
  float usual_weight;  // per unit: asks for the term plainly, in figures that have not been calibrated
};

/// How many of the terms are the paper's. Every motion measures those; the further ones are measured by
/// StyleMeter, and only where a task weighs them.
inline constexpr int kPaperTerms = 3;

/// In the order of StyleTerm. A new term goes to the end: documents name them in this order.
inline constexpr auto kStyleTable = std::to_array<StyleTermRow>({
    {"max_cm_height", "m", &Terms::max_cm_height_m, 1, 10.0f},
    {"slip_sum", "m", &Terms::slip_sum_m, 1, 0.6f},
    {"rotations", "", &Terms::rotations, 1, 10.0f},
    {"effort", "rad", &Terms::effort_rad, 2, 0.05f},
    {"upright", "", &Terms::upright, 2, 5.0f},
    {"smoothness", "rad/s^2", &Terms::smoothness_radps2, 2, 0.2f},
    {"head_height", "m", &Terms::head_height_m, 2, 2.0f},
});
inline constexpr int kStyleTerms = static_cast<int>(kStyleTable.size());

inline constexpr std::array<std::string_view, kStyleTerms> kStyleTermNames = [] {
  std::array<std::string_view, kStyleTerms> names;
  for (std::size_t term = 0; term < names.size(); ++term) names[term] = kStyleTable[term].name;
  return names;
}();

inline float Terms::Style(StyleTerm term) const {
  return this->*kStyleTable[static_cast<std::size_t>(term)].value;
}

/// Which of the further terms are measured, in their order.
using FurtherTerms = std::array<bool, kStyleTerms - kPaperTerms>;
inline constexpr FurtherTerms kAllFurtherTerms = [] {
  FurtherTerms all;
  all.fill(true);
  return all;
}();

}  // namespace gaitsmith
