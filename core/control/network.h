// SPDX-License-Identifier: MIT
// Sensor-actuator networks (SAN) [VanDePanne Fiume 1993], the other kind of controller: a few binary sensors,
// hidden nodes and actuators, all connected by weights, with no state but delays. Design decision 21 explains
// how we read the sources.
//
//   touch sensor   1 while the ground pushes the endpoint
//   angle sensor   1 while the joint's angle is above a threshold
//   hidden node    charges while the weighted sum of its inputs is positive, else discharges. A full charge
//                  takes its delay. Its output turns to 1 when full and to 0 when empty
//   actuator       charges in the same way. Its charge places the joint's target between two angles
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/control/stimulus_response.h"
#include "core/numeric/lane.h"
#include "core/numeric/scalar_math.h"
#include "core/signal/actuator_targets.h"
#include "core/signal/readings.h"

namespace gaitsmith {

inline constexpr int kMaxHidden = kMaxRules;
inline constexpr int kMaxNodes = kMaxHidden + kMaxActuators;
/// Of figures of rods. Networks do not drive figures of springs.
inline constexpr int kMaxTouchSensors = 17;
inline constexpr int kMaxInputs = kMaxTouchSensors + kMaxActuators + kMaxHidden;  // 64
/// Weights are in [-kMaxWeight, kMaxWeight].
inline constexpr float kMaxWeight = 2.0f;

/// The position of each number of a network in its genome: node after node, hidden nodes first. Each node has
/// the weight of every input (touches, angles, hidden outputs) and its delay. An actuator also has the
/// threshold of its joint's sensor, both ends of its target range and its time constant.
struct NetworkShape {
  int hidden = 10;  // [1, kMaxHidden]
  int touches = 0;  // number of endpoints
  int joints = 0;

  NetworkShape(int hidden_nodes, const PortCount& ports)
      : hidden(hidden_nodes), touches(ports.contacts), joints(ports.actuators) {}

  [[nodiscard]] int Inputs() const { return touches + joints + hidden; }
  /// Index into a matrix with a row per node and a column per input.
  [[nodiscard]] std::size_t Connection(int node, int input) const {
    const int at = node * Inputs() + input;
    return static_cast<std::size_t>(at);
  }
  [[nodiscard]] int Nodes() const { return hidden + joints; }
  [[nodiscard]] bool IsActuator(int node) const { return node >= hidden; }
  /// The first gene of a node. Node(Nodes()) is the number of all genes.
  [[nodiscard]] std::size_t Node(int node) const {
    const int actuators = std::max(0, node - hidden);
    const int before = node * (Inputs() + 1) + actuators * kActuatorGenes;
    return static_cast<std::size_t>(before);
  }
  [[nodiscard]] std::size_t Genes() const { return Node(Nodes()); }
  [[nodiscard]] std::size_t Weight(int node, int input) const {
    return Node(node) + static_cast<std::size_t>(input);
  }
  [[nodiscard]] std::size_t Delay(int node) const { return Weight(node, Inputs()); }
  [[nodiscard]] std::size_t Threshold(int actuator) const { return Delay(actuator) + 1; }
  [[nodiscard]] std::size_t TargetEmpty(int actuator) const { return Delay(actuator) + 2; }
  [[nodiscard]] std::size_t TargetFull(int actuator) const { return Delay(actuator) + 3; }
  [[nodiscard]] std::size_t Tau(int actuator) const { return Delay(actuator) + 4; }
  [[nodiscard]] GeneGroups GroupsOf(int node) const {
    GeneGroups groups(Node(node));
    groups.Add("weights", GeneRole::kList, Inputs()).Add("delay", GeneRole::kNumber, 1);
    if (IsActuator(node)) {
      groups.Add("threshold", GeneRole::kNumber, 1)
          .Add("targets", GeneRole::kList, 2)
          .Add("tau", GeneRole::kNumber, 1);
    }
    return groups;
  }

 private:
  static constexpr int kActuatorGenes = 4;  // in addition to those of a hidden node
};

/// "touch 3", "angle 2", "node 7". Inputs count from 1 like endpoints and joints.
[[nodiscard]] std::string InputName(const NetworkShape&, int input);

/// The state of W networks between steps.
template <int W>
struct NetworkState {
  using F = typename Lane<W>::F;
  std::array<F, kMaxInputs> input{};  // 0 or 1
  std::array<F, kMaxNodes> charge{};  // [0, 1]
};

/// W networks of one shape side by side.
template <int W>
class Network {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  /// @param genomes 1 to W of them, all of this shape; missing lanes repeat the last one
  /// @param limits  least and greatest angle of each joint [rad], shape.joints pairs
  /// @param step_s  time step
  Network(const NetworkShape& shape, const SenseSpec& senses, std::span<const std::span<const Gene>> genomes,
          std::span<const std::array<float, 2>> limits, float step_s)
      : shape_(shape),
        weight_(shape.Connection(shape.Nodes(), 0)),
        charging_(static_cast<std::size_t>(shape.Nodes())),
        threshold_(static_cast<std::size_t>(shape.joints)),
        target_empty_(threshold_.size()),
        target_span_(threshold_.size()),
        decay_(threshold_.size()),
        inverse_tau_(threshold_.size()) {
    for (int lane = 0; lane < W; ++lane) {
      const auto& genes = genomes[std::min(static_cast<std::size_t>(lane), genomes.size() - 1)];
      for (int node = 0; node < shape.Nodes(); ++node) {
        for (int input = 0; input < shape.Inputs(); ++input) {
          weight_[shape.Connection(node, input)][lane] =
              Decode(genes[shape.Weight(node, input)], -kMaxWeight, kMaxWeight);
        }
        charging_[static_cast<std::size_t>(node)][lane] =
            step_s / DecodeTau(genes[shape.Delay(node)], senses);
      }
      for (int joint = 0; joint < shape.joints; ++joint) {
        const auto j = static_cast<std::size_t>(joint);
        const int actuator = shape.hidden + joint;
        const auto angle = [&](std::size_t gene) { return Decode(genes[gene], limits[j][0], limits[j][1]); };
        threshold_[j][lane] = angle(shape.Threshold(actuator));
        target_empty_[j][lane] = angle(shape.TargetEmpty(actuator));
        target_span_[j][lane] = angle(shape.TargetFull(actuator)) - angle(shape.TargetEmpty(actuator));
        const float tau = DecodeTau(genes[shape.Tau(actuator)], senses);
        decay_[j][lane] = static_cast<float>(Exp(-static_cast<double>(step_s) / static_cast<double>(tau)));
        inverse_tau_[j][lane] = 1.0f / tau;
      }
    }
  }

  /// Empties all nodes and sets their outputs to 0.
  void Begin(NetworkState<W>& state, ActuatorTargets<W>& targets) const {
    state = {};
    for (std::size_t j = 0; j < threshold_.size(); ++j) {
      targets.target[j] = target_empty_[j];
      targets.decay[j] = decay_[j];
      targets.inverse_tau[j] = inverse_tau_[j];
    }
  }

  /// Advances all nodes by one step, each from the outputs of the previous step.
  /// @param angle_rad of each joint
  /// @param push      of the ground at each endpoint, any unit; only its sign counts
  void Advance(std::span<const F> angle_rad, std::span<const F> push, NetworkState<W>& state,
               ActuatorTargets<W>& targets) const {
    const auto touches = static_cast<std::size_t>(shape_.touches);
    const auto joints = static_cast<std::size_t>(shape_.joints);
    const auto hidden = static_cast<std::size_t>(shape_.hidden);
    const std::size_t inputs = touches + joints + hidden;
    const F one = L::Splat(1.0f);
    for (std::size_t k = 0; k < touches; ++k) state.input[k] = L::Select(push[k] > 0.0f, one, F{});
    for (std::size_t j = 0; j < joints; ++j) {
      state.input[touches + j] = L::Select(angle_rad[j] > threshold_[j], one, F{});
    }
    for (std::size_t node = 0; node < hidden + joints; ++node) {
      F sum{};
      const F* weight = &weight_[node * inputs];
      for (std::size_t i = 0; i < inputs; ++i) sum += weight[i] * state.input[i];
      const F step = L::Select(sum > 0.0f, charging_[node], -charging_[node]);
      state.charge[node] = L::Max(L::Min(state.charge[node] + step, one), F{});
    }
    for (std::size_t node = 0; node < hidden; ++node) {
      F& output = state.input[touches + joints + node];
      const F charge = state.charge[node];
      output = L::Select(charge >= 1.0f, one, L::Select(charge <= 0.0f, F{}, output));
    }
    for (std::size_t j = 0; j < joints; ++j) {
      targets.target[j] = target_empty_[j] + target_span_[j] * state.charge[hidden + j];
    }
  }

  [[nodiscard]] const NetworkShape& Shape() const { return shape_; }

  // The decoded numbers of one lane.
  [[nodiscard]] float WeightOf(int node, int input, int lane) const {
    return L::At(weight_[shape_.Connection(node, input)], lane);
  }
  /// Share of a full charge per step.
  [[nodiscard]] float ChargingOf(int node, int lane) const {
    return L::At(charging_[static_cast<std::size_t>(node)], lane);
  }
  struct JointNumbers {
    float threshold_rad, empty_rad, span_rad, decay;
  };
  [[nodiscard]] JointNumbers NumbersOf(int joint, int lane) const {
    const auto j = static_cast<std::size_t>(joint);
    return {L::At(threshold_[j], lane), L::At(target_empty_[j], lane), L::At(target_span_[j], lane),
            L::At(decay_[j], lane)};
  }

 private:
  NetworkShape shape_;
  std::vector<F> weight_;                                  // (nodes x inputs)
  std::vector<F> charging_;                                // share of a full charge per step, (nodes)
  std::vector<F> threshold_, target_empty_, target_span_;  // [rad] (joints)
  std::vector<F> decay_, inverse_tau_;                     // (joints), [1], [1/s]
};

}  // namespace gaitsmith
