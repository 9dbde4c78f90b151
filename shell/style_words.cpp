// SPDX-License-Identifier: MIT
#include "shell/style_words.h"

#include <algorithm>
#include <cmath>

#include "shell/session.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

std::string LowerCase(std::string text) {
  if (text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
  return text;
}

}  // namespace

const std::array<TermWords, kStyleTerms>& TermTexts() {
  static constexpr std::array<TermWords, kStyleTerms> kTexts = {{
      {"style/height", "Height", "peak of the centre of mass", "m", "per m", 2},
      {"style/slip", "Slip", "how far loaded endpoints slide", "m", "per m", 2},
      {"style/rotations", "Rotations", "turns of the root from start to end", "turns", "per turn", 2},
      {"style/effort", "Effort", "angle that all joints travel together", "rad", "per rad", 1},
      {"style/upright", "Upright", "mean: 1 as drawn, −1 upside down", "", "", 2},
      {"style/smoothness", "Smoothness", "0 when joints never change speed", "rad/s²", "per rad/s²", 1},
      {"style/head", "Head height", "mean height of the endpoint drawn highest", "m", "per m", 2},
  }};
  return kTexts;
}

std::string AmountText(float amount, int decimals) {
  const float size = std::abs(amount);
  return Fixed(amount, size >= 10'000.0f ? 0 : size >= 1000.0f ? std::min(decimals, 1) : decimals);
}

std::string ValueText(const TermWords& words, float value) {
  return AmountText(value, words.decimals) + (*words.unit != '\0' ? " " : "") + words.unit;
}

std::string WeightText(float weight) {
  const float size = std::abs(weight);
  const int least = size >= 100.0f ? 0 : 1;
  const int most = size >= 100.0f ? 1 : size >= 10.0f ? 2 : 4;
  int decimals = least;
  const auto shown_exactly = [&] {
    const double scaled = static_cast<double>(weight) * std::pow(10.0, decimals);
    return std::abs(scaled - std::round(scaled)) < 1e-3;
  };
  while (decimals < most && !shown_exactly()) ++decimals;
  return Fixed(weight, decimals);
}

std::string PrimaryLabel(TaskKind kind) {
  std::string words = TaskWords(kind);
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

std::string PrimaryLine(TaskKind kind) {
  switch (kind) {
    case TaskKind::kTravel:
      return "Metres the centre of mass gets away, either way.";
    case TaskKind::kTravelRight:
      return "Metres the centre of mass gets to the right.";
    case TaskKind::kTravelLeft:
      return "Metres the centre of mass gets to the left.";
    case TaskKind::kJump:
      return "Metres the centre of mass rises above its start.";
  }
  return {};
}

std::string ScoreWords(const Task& task, const Terms& terms) {
  const float fitness = Fitness(task, terms);
  if (fitness <= kVoidScore) return "No score: this motion breaks physics.";
  std::string sum = "Score " + AmountText(fitness, 2) + ": " + TaskWords(task.kind) + " " +
                    AmountText(Primary(task, terms), 2) + " m";
  std::string rest;
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    const TermWords& words = TermTexts()[i];
    const float value = terms.Style(static_cast<StyleTerm>(i));
    const float weight = task.weights[i];
    const std::string measured = LowerCase(words.label) + " " + ValueText(words, value);
    if (weight == 0.0f) {
      rest += (rest.empty() ? " Not weighed: " : ", ") + measured;
    } else {
      const float adds = weight * value;
      sum += "; " + measured + " times " + WeightText(weight) + (adds < 0.0f ? " takes away " : " adds ") +
             AmountText(std::abs(adds), 2);
    }
  }
  return sum + "." + rest + (rest.empty() ? "" : ".");
}

}  // namespace gaitsmith::shell
