// SPDX-License-Identifier: MIT
// A controller's decoded numbers as JSON, for core/runtime/gaitsmith.h and web/runtime/runtime.js.
#include <array>
#include <span>
#include <string>

#include "core/control/controllers.h"
#include "core/document/joints.h"
#include "core/document/schema.h"
#include "core/physics/mechanism.h"
#include "core/rollout/models.h"
#include "shell/export/exporters.h"
#include "shell/export/json_parts.h"

namespace gaitsmith::shell {

namespace {

constexpr std::array<std::string_view, 3> kClipNames = {"none", "above", "both"};  // of SenseClip

std::string Number(float value) { return Digits(static_cast<double>(value), 9); }

class ControllerText {
 public:
  ControllerText(const Document& document, const Controller& controller)
      : document_(document),
        controller_(controller),
        ports_(PortsOf(document.figure)),
        shape_(controller.Shape(ports_.Count())) {}

  std::string Whole() {
    whole_.Add("format", "gaitsmith-controller");
    whole_.Add("version", 1);
    whole_.Add("title", document_.title);
    whole_.Add("name", controller_.name);
    whole_.Add("kind", RowOf(controller_.kind).name);
    whole_.Add("step_s", kStep);
    const std::span<const Gene> genes(controller_.genes);
    const Controllers<1> decoded =
        DecodeControllers<1>(shape_, controller_.senses, std::span(&genes, 1), ports_, kStep);
    std::visit([&](const auto& one) { Add(one); }, decoded);
    whole_.AddJson("figure", document_.figure.HasSprings() ? Springs() : Rods());
    JsonParts world;
    world.Add("gravity_mps2", document_.environment.gravity_mps2);
    world.Add("friction", document_.environment.friction);
    whole_.AddJson("world", world.Object());
    return whole_.ObjectOfLines() + "\n";
  }

 private:
  [[nodiscard]] std::size_t Index(int i) const { return static_cast<std::size_t>(i); }
  [[nodiscard]] float Tau(std::size_t gene) const {
    return DecodeTau(controller_.genes[gene], controller_.senses);
  }

  /// @param more adds what else this kind of controller has for each joint
  template <class More>
  void AddJoints(More more) {
    JsonParts joints = JsonParts::Lines();
    for (int joint = 0; joint < ports_.Actuators(); ++joint) {
      JsonParts one;
      one.Add("name", (ports_.muscles ? "muscle " : "joint ") + std::to_string(joint + 1));
      if (ports_.muscles) {
        one.Add("rod", -1);
        one.Add("spring", MuscleSpring(joint));
      } else {
        one.Add("rod", joint + 1);
      }
      one.Add("min_rad", ports_.actuator_range[Index(joint)][0]);
      one.Add("max_rad", ports_.actuator_range[Index(joint)][1]);
      if (HasLimitedJoints(document_))
        one.Add("greatest_torque_nm", Mechanism(document_.figure).torque_nm[Index(joint) + 1]);
      more(joint, one);
      joints.Add(one.Object());
    }
    whole_.AddJson("joints", joints.ListOfLines());
  }

  static std::string Sense(std::string_view name, std::string_view unit, float at_zero, float at_one,
                           SenseClip clip) {
    JsonParts sense;
    sense.Add("name", name);
    sense.Add("unit", unit);
    sense.Add("at_zero", at_zero);
    sense.Add("at_one", at_one);
    sense.Add("clip", kClipNames[static_cast<std::size_t>(clip)]);
    return sense.Object();
  }

  void Add(const Bank<1>& bank) {
    const SenseSpec& spec = controller_.senses;
    const BankShape& shape = shape_.Bank();
    if (spec.kind == SenseKind::kTimer) whole_.Add("period_steps", spec.period_steps);
    if (spec.kind == SenseKind::kSight)
      whole_.Add("facing", kFacingNames[static_cast<std::size_t>(spec.facing)]);
    AddJoints([](int, JsonParts&) {});
    JsonParts senses = JsonParts::Lines();
    for (int i = 0; i < shape.senses; ++i) {
      const SenseScale scale = ScaleOf(spec, ports_, i);
      const SenseGroup& group = *PlaceOf(spec.kind, ports_.Count(), i).group;
      const bool length = scale.quantity == SenseQuantity::kLength;
      senses.Add(Sense(SenseName(spec.kind, ports_.Count(), i), length ? "drawn lengths" : group.unit,
                       scale.at_zero, scale.at_one, group.clip));
    }
    whole_.AddJson("senses", senses.ListOfLines());
    std::vector<JsonParts> when(Index(shape.rules));
    bank.ForEachInterval(0, [&](int rule, int sense, float middle, float inverse_half_width) {
      when[Index(rule)].Add("[" + std::to_string(sense) + ", " + Number(middle) + ", " +
                            Number(inverse_half_width) + "]");
    });
    JsonParts rules = JsonParts::Lines();
    for (int rule = 0; rule < shape.rules; ++rule) {
      ActuatorTargets<1> response{};
      bank.Respond(rule, 0, response);
      JsonParts one, targets;
      for (int joint = 0; joint < shape.joints; ++joint)
        targets.Add(Number(response.target[Index(joint)][0]));
      one.AddJson("targets_rad", targets.List());
      one.Add("tau_s", Tau(shape.Tau(rule)));
      one.Add("decay", response.decay[0][0]);
      one.AddJson("when", when[Index(rule)].List());
      rules.Add(one.Object());
    }
    whole_.AddJson("rules", rules.ListOfLines());
  }

  void Add(const Network<1>& network) {
    const NetworkShape& shape = network.Shape();
    AddJoints([&](int joint, JsonParts& one) {
      const auto numbers = network.NumbersOf(joint, 0);
      one.Add("threshold_rad", numbers.threshold_rad);
      one.Add("empty_rad", numbers.empty_rad);
      one.Add("span_rad", numbers.span_rad);
      one.Add("tau_s", Tau(shape.Tau(shape.hidden + joint)));
      one.Add("decay", numbers.decay);
    });
    JsonParts senses = JsonParts::Lines();
    for (int i = 0; i < shape.touches + shape.joints; ++i)
      senses.Add(Sense(InputName(shape, i), i < shape.touches ? "N" : "rad", 0.0f, 1.0f, SenseClip::kNone));
    whole_.AddJson("senses", senses.ListOfLines());
    JsonParts nodes = JsonParts::Lines();
    for (int node = 0; node < shape.Nodes(); ++node) {
      JsonParts one, weights;
      for (int input = 0; input < shape.Inputs(); ++input)
        weights.Add(Number(network.WeightOf(node, input, 0)));
      one.Add("charging", network.ChargingOf(node, 0));
      one.AddJson("weights", weights.List());
      nodes.Add(one.Object());
    }
    whole_.AddJson("nodes", nodes.ListOfLines());
  }

  void Add(const JointCurves<1>& curves) {
    const SenseSpec& spec = controller_.senses;
    whole_.Add("period_steps", spec.period_steps);
    whole_.Add("at_end", kCurveEndNames[static_cast<std::size_t>(spec.at_end)]);
    whole_.Add("tau_s", spec.tau_min_s);
    whole_.Add("decay", curves.Decay());
    AddJoints([](int, JsonParts&) {});
    whole_.AddJson("senses", JsonParts().List());
    JsonParts knots = JsonParts::Lines();
    for (int knot = 0; knot < shape_.Curves().knots; ++knot) {
      JsonParts angles;
      for (int joint = 0; joint < shape_.Curves().joints; ++joint)
        angles.Add(Number(curves.AngleOf(knot, joint, 0)));
      knots.Add(angles.List());
    }
    whole_.AddJson("knots_rad", knots.ListOfLines());
  }

  /// The rods in walking order: joint j turns rod j + 1. Endpoint 0 is the start of rod 0, endpoint i + 1 the
  /// end of rod i.
  [[nodiscard]] std::string Rods() const {
    const Skeleton body(document_.figure);
    JsonParts rods = JsonParts::Lines();
    for (int i = 0; i < body.rods; ++i) {
      const Skeleton::Limb& limb = body.limbs[Index(i)];
      JsonParts rod;
      rod.Add("length_m", limb.length_m);
      rod.Add("mass_kg", limb.mass_kg);
      rod.Add("parent", limb.parent);
      rod.Add("parent_end", kRodEndNames[limb.start == limb.parent + 1 && limb.parent >= 0 ? 1 : 0]);
      rod.Add("rest_rad", i == 0 ? body.start_angle_rad : limb.rest_rad);
      rods.Add(rod.Object());
    }
    JsonParts figure;
    figure.Add("name", document_.figure.name);
    figure.AddJson("rods", rods.ListOfLines());
    return figure.Object();
  }

  /// Nodes and springs in the document's order. Endpoint i is node i.
  [[nodiscard]] std::string Springs() const {
    JsonParts nodes = JsonParts::Lines(), springs = JsonParts::Lines();
    for (const Node& node : document_.figure.nodes) {
      JsonParts one;
      one.Add("x_m", node.x_m);
      one.Add("y_m", node.y_m);
      one.Add("mass_kg", node.mass_kg);
      nodes.Add(one.Object());
    }
    for (const Spring& spring : document_.figure.springs) {
      JsonParts one;
      one.Add("from", spring.from);
      one.Add("to", spring.to);
      one.Add("drawn_m", DrawnLength(document_.figure, spring));
      one.Add("stiffness_npm", spring.stiffness_npm);
      one.Add("damping_nspm", spring.damping_nspm);
      one.Add("rest", spring.rest);
      springs.Add(one.Object());
    }
    JsonParts figure;
    figure.Add("name", document_.figure.name);
    figure.AddJson("rods", JsonParts().List());
    figure.AddJson("nodes", nodes.ListOfLines());
    figure.AddJson("springs", springs.ListOfLines());
    return figure.Object();
  }

  /// Which spring a muscle is.
  [[nodiscard]] int MuscleSpring(int muscle) const {
    int spring = 0;
    while (!document_.figure.springs[Index(spring)].IsMuscle() || muscle-- > 0) ++spring;
    return spring;
  }

  const Document& document_;
  const Controller& controller_;
  Ports ports_;
  ControllerShape shape_;
  JsonParts whole_ = JsonParts::Lines();
};

}  // namespace

Result<void> HasController(const Document& document) {
  if (!document.timeline.empty()) return {};
  return Fail(ErrorCode::kMissing, "timeline", "has no controller");
}

std::string ControllerJson(const Document& document, std::size_t clip) {
  const auto controller = static_cast<std::size_t>(document.timeline[clip].controller);
  return ControllerText(document, document.controllers[controller]).Whole();
}

}  // namespace gaitsmith::shell
