// SPDX-License-Identifier: MIT
// The terms of a score in words: names, units, explanations, and the whole sum as text.
#pragma once

#include <array>
#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

struct TermWords {
  const char* id;     // id of its slider, e.g. "style/slip"; the other texts are to be translated
  const char* label;  // "Slip"
  const char* word;   // "slip", within a sentence
  const char* line;   // what it measures, in a few words
  const char* unit;   // "m", or empty for a plain number
  const char* per;    // unit of the weight: "per m"
  int decimals;       // of the measured value
};

/// In the order of StyleTerm, with the units of joints.
[[nodiscard]] const std::array<TermWords, kStyleTerms>& TermTexts();
/// Muscles move in drawn lengths, not in radians. @param term  below kStyleTerms
[[nodiscard]] TermWords TermTextFor(const Figure&, std::size_t term);

/// A number with at most this many decimals: large numbers have fewer, to fit into a column.
[[nodiscard]] std::string AmountText(float amount, int decimals);
/// "20.86 m"
[[nodiscard]] std::string ValueText(const TermWords&, float value);
/// A weight with at least one decimal, more if needed and if they fit into a column: "-0.05".
[[nodiscard]] std::string WeightText(float weight);
/// "Travel to the right": the primary term.
[[nodiscard]] std::string PrimaryLabel(TaskKind);
/// One sentence about what the primary term measures.
[[nodiscard]] std::string PrimaryLine(TaskKind);

/// "1.84 m to the right"
[[nodiscard]] std::string WayWords(float travel_m);
/// What a motion reached, in metres: "12.3 m to the right", or for a jump "0.84 m high".
[[nodiscard]] std::string ReachedWords(TaskKind, const Terms&);

/// "−18.33 m · up to 0.97 m · slip 20.9 m · turns 0.02": the paper's terms. Travel to the left is negative.
[[nodiscard]] std::string TermsLine(const Terms&);

/// The score as a sum in words, for screen readers: "Score 28.76: travel 18.33 m; slip 20.86 m times 0.5 adds
/// 10.43. Not weighed: height 0.97 m, ...".
[[nodiscard]] std::string ScoreWords(const Document&, const Terms&);

}  // namespace gaitsmith::shell
