// SPDX-License-Identifier: MIT
#include "core/control/rule_edit.h"

#include <algorithm>

namespace gaitsmith {
namespace {

BankShape ShapeOf(const Controller& controller, const PortCount& ports) {
  return {controller.rules, controller.senses.kind, ports};
}

// Where a rule's genes begin. For rule = controller.rules, the end of all genes.
auto Begin(Controller& controller, const PortCount& ports, int rule) {
  return controller.genes.begin() + rule * ShapeOf(controller, ports).GenesPerRule();
}

}  // namespace

void RuleEdit::SetInterval(int sense, float low, float high) {
  const auto [edge_low, edge_high] = EdgesOf(controller_.senses.kind);
  const Gene first = Encode(std::min(low, high), edge_low, edge_high);
  const Gene last = Encode(std::max(low, high), edge_low, edge_high);
  controller_.genes[shape_.Low(rule_, sense)] = first;
  controller_.genes[shape_.High(rule_, sense)] =
      first == 0 && last == kGeneMax ? static_cast<Gene>(kGeneMax - 1) : last;
}

void RuleEdit::SetCares(int sense, bool cares) {
  if (cares == shape_.Cares(controller_.genes, rule_, sense)) return;
  controller_.genes[shape_.Low(rule_, sense)] = cares ? kGeneMax / 4 : 0;
  controller_.genes[shape_.High(rule_, sense)] = cares ? kGeneMax - kGeneMax / 4 : kGeneMax;
}

Stimulus StimulusOf(const Controller& controller, const PortCount& ports, int rule, int sense) {
  const BankShape shape = ShapeOf(controller, ports);
  const auto [low, high] = EdgesOf(controller.senses.kind);
  return {shape.Cares(controller.genes, rule, sense),
          Decode(controller.genes[shape.Low(rule, sense)], low, high),
          Decode(controller.genes[shape.High(rule, sense)], low, high)};
}

float TargetOf(const Controller& controller, const PortCount& ports, int rule, int joint, float min_rad,
               float max_rad) {
  return Decode(controller.genes[ShapeOf(controller, ports).Target(rule, joint)], min_rad, max_rad);
}

float TauOf(const Controller& controller, const PortCount& ports, int rule) {
  return DecodeTau(controller.genes[ShapeOf(controller, ports).Tau(rule)], controller.senses);
}

void CopyRule(Controller& controller, const PortCount& ports, int rule) {
  const Genome copy(Begin(controller, ports, rule), Begin(controller, ports, rule + 1));
  controller.genes.insert(Begin(controller, ports, rule + 1), copy.begin(), copy.end());
  ++controller.rules;
}

void DeleteRule(Controller& controller, const PortCount& ports, int rule) {
  controller.genes.erase(Begin(controller, ports, rule), Begin(controller, ports, rule + 1));
  --controller.rules;
}

}  // namespace gaitsmith
