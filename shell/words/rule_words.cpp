// SPDX-License-Identifier: MIT
#include "shell/words/rule_words.h"

#include <cmath>

#include "core/control/rule_edit.h"
#include "core/numeric/scalar_math.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// By how much a sense misses a rule's interval: "0.04 m above its interval".
std::string MissWords(const RuleMoment& moment, int rule, int sense) {
  const SenseScale scale = ScaleOf(moment.controller.senses, moment.ports, sense);
  const Stimulus stimulus = StimulusOf(moment.controller, moment.ports.Count(), rule, sense);
  const float felt = moment.senses[static_cast<std::size_t>(sense)];
  const bool above = felt > stimulus.high;
  const float miss =
      above ? scale.Of(felt) - scale.Of(stimulus.high) : scale.Of(stimulus.low) - scale.Of(felt);
  return Tr(above ? "{1} above its range" : "{1} below its range", QuantityWords(scale.quantity, miss));
}

// How well a rule matches, in percent.
std::string MatchWords(const RuleStanding& standing) { return Fixed(100.0f * standing.Depth(), 0); }

std::string WhyItActs(const RuleMoment& moment, int rule) {
  const auto standing_of = [&](int r) -> const RuleStanding& {
    return moment.choice.standings[static_cast<std::size_t>(r)];
  };
  const RuleStanding& own = standing_of(rule);
  std::string words;
  if (own.cares == 0) {
    words = Tr("Rule {1} is active: it uses no sense, so it always matches.", rule + 1);
  } else {
    const char* pattern =
        own.cares == 1 ? TrLater("Rule {1} is active: {2} is in range (match {3} %).")
        : own.cares == 2
            ? TrLater("Rule {1} is active: {2} is in range, and so is the other sense it uses (match {3} %).")
            : TrLater(
                  "Rule {1} is active: {2} is in range, and so are the other {4} senses it uses (match {3} "
                  "%).");
    words = Tr(pattern, rule + 1, SenseWords(moment, own.decisive_sense), MatchWords(own), own.cares - 1);
  }
  if (moment.choice.runner_up < 0) return words;
  const int rival = moment.choice.runner_up;
  const RuleStanding& next = standing_of(rival);
  if (!next.Holds()) {
    return words + " " +
           Tr("No other rule matches. Nearest is rule {1}: {2}, {3}.", rival + 1,
              SenseWords(moment, next.decisive_sense), MissWords(moment, rival, next.decisive_sense));
  }
  if (next.off == own.off)
    return words + " " + Tr("Rule {1} matches equally well, but comes later.", rival + 1);
  return words + " " + Tr("Next best is rule {1} (match {2} %).", rival + 1, MatchWords(next));
}

}  // namespace

std::optional<RuleMoment> MomentOf(const Controller& controller, const Motion& motion, int clip, int frame) {
  if (controller.kind != ControllerKind::kRules || motion.At(frame).clip != clip) return std::nullopt;
  const int count = SenseCount(controller.senses.kind, motion.Connections().Count());
  RuleMoment moment{controller, motion.Connections(), {}, {}, frame == 0};
  for (int sense = 0; sense < count; ++sense) moment.senses.push_back(motion.Sense(frame, sense));
  // A controller that takes over starts with its first rule.
  const bool goes_on = frame > 0 && motion.At(frame - 1).clip == clip;
  moment.choice = ChoiceOf(controller, motion.Connections().Count(), moment.senses,
                           goes_on ? motion.At(frame - 1).rule : 0);
  return moment;
}

std::string QuantityWords(SenseQuantity quantity, float value) {
  const auto with = [](double number, int decimals, const char* unit) {
    return Fixed(number, decimals) + unit;
  };
  const auto number = static_cast<double>(value);
  switch (quantity) {
    case SenseQuantity::kAngle:
      return with(number * 180.0 / kPi, 0, "°");
    case SenseQuantity::kForce:
      return with(number, std::abs(number) < 10.0 ? 1 : 0, " N");
    case SenseQuantity::kHeight:
    case SenseQuantity::kAhead:
    case SenseQuantity::kCorner:
      return with(number, 2, " m");
    case SenseQuantity::kVelocity:
      return with(number, 2, " m/s");
    case SenseQuantity::kTime:
      return with(number, 2, " s");
    case SenseQuantity::kLength:
      return with(number * 100.0, 0, " %");
  }
  return {};
}

std::string SenseWords(const RuleMoment& moment, int sense) {
  const SenseScale scale = ScaleOf(moment.controller.senses, moment.ports, sense);
  return Tr("{1} at {2}", TrSentence(SenseName(moment.controller.senses.kind, moment.ports.Count(), sense)),
            QuantityWords(scale.quantity, scale.Of(moment.senses[static_cast<std::size_t>(sense)])));
}

std::string WhyWords(const RuleMoment& moment, int rule) {
  const RuleChoice& choice = moment.choice;
  const RuleStanding& own = choice.standings[static_cast<std::size_t>(rule)];
  if (moment.begins) {
    return Tr(rule == 0
                  ? "Rule {1} is active: a controller starts with its first rule, before it senses anything."
                  : "Rule {1} is inactive: a controller starts with rule 1, before it senses anything.",
              rule + 1);
  }
  if (rule == choice.rule && choice.holds) return WhyItActs(moment, rule);
  if (rule == choice.rule) {
    const int rival = choice.runner_up;
    std::string words = Tr("Rule {1} stays active, because no rule matches.", rule + 1);
    if (rival < 0) return words;
    const int sense = choice.standings[static_cast<std::size_t>(rival)].decisive_sense;
    return words + " " +
           Tr("Nearest is rule {1}: {2}, {3}.", rival + 1, SenseWords(moment, sense),
              MissWords(moment, rival, sense));
  }
  if (!own.Holds()) {
    return Tr("Rule {1} is inactive: {2} is {3}.", rule + 1, SenseWords(moment, own.decisive_sense),
              MissWords(moment, rule, own.decisive_sense));
  }
  const RuleStanding& winner = choice.standings[static_cast<std::size_t>(choice.rule)];
  if (winner.off == own.off) {
    return Tr("Rule {1} matches equally well ({2} %), but rule {3} comes first.", rule + 1, MatchWords(own),
              choice.rule + 1);
  }
  return Tr("Rule {1} matches too ({2} %), but rule {3} matches better ({4} %).", rule + 1, MatchWords(own),
            choice.rule + 1, MatchWords(winner));
}

}  // namespace gaitsmith::shell
