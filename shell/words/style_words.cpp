// SPDX-License-Identifier: MIT
#include "shell/words/style_words.h"

#include <algorithm>
#include <cmath>

#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
const std::array<TermWords, kStyleTerms>& TermTexts() {
  static constexpr auto kTexts = std::to_array<TermWords>({
      {"style/height", TrLater("Height"), TrLater("height"), TrLater("peak of the centre of mass"), "m",
       TrLater("per m"), 2},
      {"style/slip", TrLater("Slip"), TrLater("slip"), TrLater("how far the feet slide"), "m",
       TrLater("per m"), 2},
      {"style/rotations", TrLater("Rotations"), TrLater("rotations"), TrLater("full turns, start to end"),
       TrLater("turns"), TrLater("per turn"), 2},
      {"style/effort", TrLater("Effort"), TrLater("effort"), TrLater("total movement of joints or muscles"),
       "rad", TrLater("per rad"), 1},
      {"style/upright", TrLater("Upright"), TrLater("upright"), TrLater("1 = upright, −1 = upside down"), "",
       "", 2},
      {"style/smoothness", TrLater("Smoothness"), TrLater("smoothness"),
       TrLater("0 when joints or muscles never change speed"), "rad/s²", TrLater("per rad/s²"), 1},
      {"style/head", TrLater("Head height"), TrLater("head height"), TrLater("average height of the head"),
       "m", TrLater("per m"), 2},
      {"style/way", TrLater("On the way"), TrLater("on the way"),
       TrLater("0 on the way that you drew, less beside it"), "m", TrLater("per m"), 2},
      {"style/pose", TrLater("In the pose"), TrLater("in the pose"),
       TrLater("0 in the pose that you showed, less in others"), "rad", TrLater("per rad"), 2},
      {"style/work", TrLater("Work"), TrLater("work"), TrLater("energy that the muscles give or take"), "J",
       TrLater("per J"), 0},
      {"style/power", TrLater("Peak power"), TrLater("peak power"), TrLater("greatest power at one moment"),
       "W/kg", TrLater("per W/kg"), 0},
      {"style/transport", TrLater("Cost of transport"), TrLater("cost of transport"),
       TrLater("work for each newton of weight and metre of travel"), "", "", 2},
  });
  static_assert(kTexts.size() == kStyleTerms, "every term needs its words");
  return kTexts;
}

TermWords TermTextFor(const Figure& figure, std::size_t term) {
  TermWords words = TermTexts()[term];
  if (!figure.HasSprings()) return words;
  if (term == static_cast<std::size_t>(StyleTerm::kEffort)) {
    words.unit = TrLater("lengths");
    words.per = TrLater("per length");
  } else if (term == static_cast<std::size_t>(StyleTerm::kSmoothness)) {
    words.unit = TrLater("lengths/s²");
    words.per = TrLater("per length/s²");
  }
  return words;
}

std::string AmountText(float amount, int decimals) {
  const float size = std::abs(amount);
  return Fixed(amount, size >= 10'000.0f ? 0 : size >= 1000.0f ? std::min(decimals, 1) : decimals);
}

std::string ValueText(const TermWords& words, float value) {
  return AmountText(value, words.decimals) + (*words.unit != '\0' ? " " : "") + Tr(words.unit);
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
  switch (kind) {
    case TaskKind::kTravel:
      return Tr("Travel");
    case TaskKind::kTravelRight:
      return Tr("Travel to the right");
    case TaskKind::kTravelLeft:
      return Tr("Travel to the left");
    case TaskKind::kJump:
      return Tr("Jump");
  }
  return {};
}

std::string PrimaryLine(TaskKind kind) {
  switch (kind) {
    case TaskKind::kTravel:
      return Tr("Distance moved, left or right (centre of mass).");
    case TaskKind::kTravelRight:
      return Tr("Distance moved to the right (centre of mass).");
    case TaskKind::kTravelLeft:
      return Tr("Distance moved to the left (centre of mass).");
    case TaskKind::kJump:
      return Tr("Height gained above the start (centre of mass).");
  }
  return {};
}

std::string WayWords(float travel_m) {
  const std::string metres = AmountText(std::abs(travel_m), 2);
  if (std::abs(travel_m) < 0.005f) return metres + " m";
  return Tr(travel_m > 0.0f ? "{1} m to the right" : "{1} m to the left", metres);
}

std::string ReachedWords(TaskKind kind, const Terms& terms) {
  if (kind == TaskKind::kJump)
    return Tr("{1} m high", AmountText(terms.max_cm_height_m - terms.start_height_m, 2));
  return WayWords(terms.travel_m);
}

std::string TermsLine(const Terms& terms) {
  return Tr("{1} m · up to {2} m · slip {3} m · turns {4}", AmountText(terms.travel_m, 2),
            AmountText(terms.max_cm_height_m, 2), AmountText(terms.slip_sum_m, 1),
            AmountText(terms.rotations, 2));
}

std::string ScoreWords(const Document& document, const Terms& terms) {
  const Task& task = document.task;
  const float fitness = Fitness(task, terms);
  if (fitness <= kVoidScore) return Tr("No score: the simulation failed.");
  std::string sum, rest;
  for (std::size_t i = 0; i < kStyleTerms; ++i) {
    if (!CanMeasure(task, static_cast<StyleTerm>(i))) continue;
    const TermWords words = TermTextFor(document.figure, i);
    const float value = terms.Style(static_cast<StyleTerm>(i));
    const float weight = task.weights[i];
    const std::string measured = std::string(Tr(words.word)) + " " + ValueText(words, value);
    if (weight == 0.0f) {
      rest += (rest.empty() ? "" : ", ") + measured;
    } else {
      const float adds = weight * value;
      sum += "; " + Tr(adds < 0.0f ? "{1} times {2} takes away {3}" : "{1} times {2} adds {3}", measured,
                       WeightText(weight), AmountText(std::abs(adds), 2));
    }
  }
  const std::string whole = Tr("Score {1}: {2} {3} m{4}.", AmountText(fitness, 2), TaskWords(task.kind),
                               AmountText(Primary(task, terms), 2), sum);
  return rest.empty() ? whole : whole + " " + Tr("Not weighed: {1}.", rest);
}

}  // namespace gaitsmith::shell
