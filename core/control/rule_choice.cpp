// SPDX-License-Identifier: MIT
#include "core/control/rule_choice.h"

#include "core/control/bank.h"

namespace gaitsmith {

RuleChoice ChoiceOf(const Controller& controller, const PortCount& ports, std::span<const float> senses,
                    int present) {
  const BankShape shape(controller.rules, controller.senses.kind, ports);
  const std::span<const Gene> genes(controller.genes);
  // The choice depends neither on targets, nor on the scales of readings, nor on the time step of responses.
  const Ports any = {.actuator_range = {static_cast<std::size_t>(shape.joints), {-1.0f, 1.0f}},
                     .contacts = ports.contacts};
  const Bank<1> bank(shape, controller.senses, std::span(&genes, 1), any, kStep);
  SenseVector<1> felt{};
  for (std::size_t i = 0; i < senses.size(); ++i) felt[i][0] = senses[i];

  RuleChoice choice;
  choice.standings.resize(static_cast<std::size_t>(shape.rules));
  bank.Measure(felt, 0, [&](int rule, int sense, float off) {
    RuleStanding& standing = choice.standings[static_cast<std::size_t>(rule)];
    ++standing.cares;
    if (standing.decisive_sense >= 0 && !(off > standing.off)) return;
    standing.off = off;
    standing.decisive_sense = sense;
  });
  choice.rule = bank.Choose(felt, Lane<1>::I{present})[0];
  choice.holds = choice.standings[static_cast<std::size_t>(choice.rule)].Holds();
  for (int rule = 0; rule < shape.rules; ++rule) {
    if (rule == choice.rule) continue;
    const auto off_of = [&](int r) { return choice.standings[static_cast<std::size_t>(r)].off; };
    if (choice.runner_up < 0 || off_of(rule) < off_of(choice.runner_up)) choice.runner_up = rule;
  }
  return choice;
}

}  // namespace gaitsmith
