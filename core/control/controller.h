// SPDX-License-Identifier: MIT
// Controllers of every kind: banks of stimulus-response rules, sensor-actuator networks and trajectories.
#pragma once

#include <string>
#include <string_view>

#include "core/control/joint_curves.h"
#include "core/control/network.h"

namespace gaitsmith {

enum class ControllerKind {
  kRules,       // banked stimulus-response rules: stimulus_response.h
  kNetwork,     // a sensor-actuator network: network.h
  kTrajectory,  // angles over time: joint_curves.h
};
struct ControllerKindRow {
  ControllerKind kind;
  std::string_view name;        // on the command line and in documents
  std::string_view components;  // the list of them in a document
  std::string_view count_note;  // after the numbers of components that are allowed, in an error
};
inline constexpr std::array<ControllerKindRow, 3> kControllerKinds = {{
    {ControllerKind::kRules, "rules", "rules", ""},
    {ControllerKind::kNetwork, "network", "nodes", ": hidden nodes, then one for each joint"},
    {ControllerKind::kTrajectory, "trajectory", "knots", ""},
}};
inline constexpr auto kControllerKindNames = [] {
  std::array<std::string_view, kControllerKinds.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kControllerKinds[i].name;
  return names;
}();
[[nodiscard]] constexpr const ControllerKindRow& RowOf(ControllerKind kind) {
  return kControllerKinds[static_cast<std::size_t>(kind)];
}

/// The position of each number of a controller in its genome, for every kind.
class ControllerShape {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): a bank's shape is a controller's shape
  ControllerShape(const BankShape& bank) : bank_(bank), network_(1, {0, 0}), curves_(1, {0, 0}) {}

  /// @param units rules of a bank, hidden nodes of a network or knots of a trajectory, [1, kMaxRules]
  ControllerShape(ControllerKind kind, int units, SenseKind senses, const PortCount& ports)
      : kind_(kind), bank_(units, senses, ports), network_(units, ports), curves_(units, ports) {}

  /// The same, with genes of a body after those of the controller: one component more.
  [[nodiscard]] ControllerShape WithBody(std::size_t genes) const {
    ControllerShape shape = *this;
    shape.body_ = genes;
    return shape;
  }

  [[nodiscard]] ControllerKind Kind() const { return kind_; }
  [[nodiscard]] const BankShape& Bank() const { return bank_; }           // only for rules
  [[nodiscard]] const NetworkShape& Network() const { return network_; }  // only for a network
  [[nodiscard]] const CurveShape& Curves() const { return curves_; }      // only for a trajectory
  [[nodiscard]] std::size_t Genes() const { return Begin(Units()) + body_; }
  /// Those of a body, at the end. 0: searches do not change it.
  [[nodiscard]] std::size_t BodyGenes() const { return body_; }

  /// Number of components, which crossover exchanges as a whole and a mutation draws anew: a bank's rules, a
  /// network's nodes, a trajectory's knots, and the body.
  [[nodiscard]] int Components() const { return Units() + (body_ > 0 ? 1 : 0); }
  /// The genes of a component by what they mean.
  [[nodiscard]] GeneGroups GroupsOf(int component) const {
    if (component == Units())
      return GeneGroups(Begin(component)).Add("body", GeneRole::kList, static_cast<int>(body_));
    switch (kind_) {
      case ControllerKind::kRules:
        break;
      case ControllerKind::kNetwork:
        return network_.GroupsOf(component);
      case ControllerKind::kTrajectory:
        return curves_.GroupsOf(component);
    }
    return bank_.GroupsOf(component);
  }
  /// Calls back with the index of the low end of every interval. The high end is the next gene.
  template <class Visit>
  void ForEachInterval(Visit visit) const {
    for (int component = 0; component < Components(); ++component) {
      for (const GeneGroup& group : GroupsOf(component)) {
        if (group.role != GeneRole::kIntervals) continue;
        for (std::size_t at = group.first; at < group.first + group.count; at += 2) visit(at);
      }
    }
  }
  /// The first gene of a component. Begin(Components()) is the number of all genes.
  [[nodiscard]] std::size_t Begin(int component) const {
    if (component > Units()) return Genes();
    if (kind_ == ControllerKind::kNetwork) return network_.Node(component);
    if (kind_ == ControllerKind::kTrajectory) return curves_.Knot(component);
    return static_cast<std::size_t>(component) * static_cast<std::size_t>(bank_.GenesPerRule());
  }

 private:
  /// A bank's rules, a network's nodes, a trajectory's knots.
  [[nodiscard]] int Units() const {
    return kind_ == ControllerKind::kNetwork ? network_.Nodes() : bank_.rules;
  }

  ControllerKind kind_ = ControllerKind::kRules;
  BankShape bank_;
  NetworkShape network_;
  CurveShape curves_;
  std::size_t body_ = 0;
};

/// A controller as a document holds it.
struct Controller {
  std::string name;
  ControllerKind kind = ControllerKind::kRules;
  SenseSpec senses;  // a network has the physical senses and uses only the range of tau, a trajectory a timer
  int rules = 0;     // a bank's rules, a network's hidden nodes or a trajectory's knots
  Genome genes;

  [[nodiscard]] ControllerShape Shape(const PortCount& ports) const {
    return {kind, rules, senses.kind, ports};
  }
};

}  // namespace gaitsmith
