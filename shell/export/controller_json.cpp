// SPDX-License-Identifier: MIT
// A controller's decoded numbers as JSON, for core/runtime/gaitsmith.h and web/runtime/runtime.js. Numbers
// have 9 significant digits, which give back the same float.
#include <array>
#include <cstdio>
#include <span>
#include <string>

#include "core/control/controllers.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"
#include "core/physics/mechanism.h"
#include "shell/export/exporters.h"

namespace gaitsmith::shell {

namespace {

constexpr std::array<std::string_view, 3> kClipNames = {"none", "above", "both"};  // of SenseClip

std::string Real(float value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  return text;
}

/// An object's members, or the elements of a list, with commas between them.
class Parts {
 public:
  void Add(const std::string& text) { text_ += (text_.empty() ? "" : separator_) + text; }
  void Add(std::string_view name, const std::string& value) { Add(QuoteJson(name) + ": " + value); }
  void Add(std::string_view name, float value) { Add(name, Real(value)); }
  void Add(std::string_view name, int value) { Add(name, std::to_string(value)); }
  void Add(std::string_view name, std::string_view word) { Add(name, QuoteJson(word)); }

  [[nodiscard]] std::string Object() const { return "{" + text_ + "}"; }
  [[nodiscard]] std::string List() const { return "[" + text_ + "]"; }

  /// A part in each line.
  static Parts Lines() {
    Parts parts;
    parts.separator_ = ",\n";
    return parts;
  }

 private:
  std::string text_, separator_ = ", ";
};

std::string Block(const Parts& lines) {
  const std::string list = lines.List();
  return "[\n" + list.substr(1, list.size() - 2) + "\n]";
}

class ControllerText {
 public:
  ControllerText(const Document& document, const Controller& controller)
      : document_(document),
        controller_(controller),
        body_(document.figure),
        ports_(PortsOf(body_)),
        shape_(controller.Shape(ports_.Count())) {}

  std::string Whole() {
    whole_.Add("format", std::string_view("gaitsmith-controller"));
    whole_.Add("version", 1);
    whole_.Add("title", std::string_view(document_.title));
    whole_.Add("name", std::string_view(controller_.name));
    whole_.Add("kind", RowOf(controller_.kind).name);
    whole_.Add("step_s", kStep);
    const std::span<const Gene> genes(controller_.genes);
    const Controllers<1> decoded =
        DecodeControllers<1>(shape_, controller_.senses, std::span(&genes, 1), ports_, kStep);
    std::visit([&](const auto& one) { Add(one); }, decoded);
    whole_.Add("figure", Figure());
    Parts world;
    world.Add("gravity_mps2", document_.environment.gravity_mps2);
    world.Add("friction", document_.environment.friction);
    whole_.Add("world", world.Object());
    const std::string text = whole_.Object();
    return "{\n" + text.substr(1, text.size() - 2) + "\n}\n";
  }

 private:
  [[nodiscard]] std::size_t Index(int i) const { return static_cast<std::size_t>(i); }
  [[nodiscard]] float Tau(std::size_t gene) const {
    return DecodeTau(controller_.genes[gene], controller_.senses);
  }

  /// @param more adds what else this kind of controller has for each joint
  template <class More>
  void AddJoints(More more) {
    Parts joints = Parts::Lines();
    for (int joint = 0; joint < body_.joints; ++joint) {
      Parts one;
      one.Add("name", std::string_view("joint " + std::to_string(joint + 1)));
      one.Add("rod", joint + 1);
      one.Add("min_rad", ports_.actuator_range[Index(joint)][0]);
      one.Add("max_rad", ports_.actuator_range[Index(joint)][1]);
      if (document_.model > 1) one.Add("greatest_torque_nm", body_.torque_nm[Index(joint) + 1]);
      more(joint, one);
      joints.Add(one.Object());
    }
    whole_.Add("joints", Block(joints));
  }

  static std::string Sense(std::string_view name, std::string_view unit, float at_zero, float at_one,
                           SenseClip clip) {
    Parts sense;
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
    AddJoints([](int, Parts&) {});
    Parts senses = Parts::Lines();
    for (int i = 0; i < shape.senses; ++i) {
      const SenseScale scale = ScaleOf(spec, ports_, i);
      const SenseGroup& group = *PlaceOf(spec.kind, ports_.Count(), i).group;
      senses.Add(Sense(SenseName(spec.kind, ports_.Count(), i), group.unit, scale.at_zero, scale.at_one,
                       group.clip));
    }
    whole_.Add("senses", Block(senses));
    std::vector<Parts> when(Index(shape.rules));
    bank.ForEachInterval(0, [&](int rule, int sense, float middle, float inverse_half_width) {
      when[Index(rule)].Add("[" + std::to_string(sense) + ", " + Real(middle) + ", " +
                            Real(inverse_half_width) + "]");
    });
    Parts rules = Parts::Lines();
    for (int rule = 0; rule < shape.rules; ++rule) {
      ActuatorTargets<1> response{};
      bank.Respond(rule, 0, response);
      Parts one, targets;
      for (int joint = 0; joint < shape.joints; ++joint) targets.Add(Real(response.target[Index(joint)][0]));
      one.Add("targets_rad", targets.List());
      one.Add("tau_s", Tau(shape.Tau(rule)));
      one.Add("decay", response.decay[0][0]);
      one.Add("when", when[Index(rule)].List());
      rules.Add(one.Object());
    }
    whole_.Add("rules", Block(rules));
  }

  void Add(const Network<1>& network) {
    const NetworkShape& shape = network.Shape();
    AddJoints([&](int joint, Parts& one) {
      const auto numbers = network.NumbersOf(joint, 0);
      one.Add("threshold_rad", numbers.threshold_rad);
      one.Add("empty_rad", numbers.empty_rad);
      one.Add("span_rad", numbers.span_rad);
      one.Add("tau_s", Tau(shape.Tau(shape.hidden + joint)));
      one.Add("decay", numbers.decay);
    });
    Parts senses = Parts::Lines();
    for (int i = 0; i < shape.touches + shape.joints; ++i)
      senses.Add(Sense(InputName(shape, i), i < shape.touches ? "N" : "rad", 0.0f, 1.0f, SenseClip::kNone));
    whole_.Add("senses", Block(senses));
    Parts nodes = Parts::Lines();
    for (int node = 0; node < shape.Nodes(); ++node) {
      Parts one, weights;
      for (int input = 0; input < shape.Inputs(); ++input)
        weights.Add(Real(network.WeightOf(node, input, 0)));
      one.Add("charging", network.ChargingOf(node, 0));
      one.Add("weights", weights.List());
      nodes.Add(one.Object());
    }
    whole_.Add("nodes", Block(nodes));
  }

  void Add(const JointCurves<1>& curves) {
    const SenseSpec& spec = controller_.senses;
    whole_.Add("period_steps", spec.period_steps);
    whole_.Add("at_end", kCurveEndNames[static_cast<std::size_t>(spec.at_end)]);
    whole_.Add("tau_s", spec.tau_min_s);
    whole_.Add("decay", curves.Decay());
    AddJoints([](int, Parts&) {});
    whole_.Add("senses", Parts().List());
    Parts knots = Parts::Lines();
    for (int knot = 0; knot < shape_.Curves().knots; ++knot) {
      Parts angles;
      for (int joint = 0; joint < shape_.Curves().joints; ++joint)
        angles.Add(Real(curves.AngleOf(knot, joint, 0)));
      knots.Add(angles.List());
    }
    whole_.Add("knots_rad", Block(knots));
  }

  /// The rods in walking order: joint j turns rod j + 1. Endpoint 0 is the start of rod 0, endpoint i + 1 the
  /// end of rod i.
  [[nodiscard]] std::string Figure() const {
    Parts rods = Parts::Lines();
    for (int i = 0; i < body_.rods; ++i) {
      const Skeleton::Limb& limb = body_.limbs[Index(i)];
      Parts rod;
      rod.Add("length_m", limb.length_m);
      rod.Add("mass_kg", limb.mass_kg);
      rod.Add("parent", limb.parent);
      rod.Add("parent_end", kRodEndNames[limb.start == limb.parent + 1 && limb.parent >= 0 ? 1 : 0]);
      rod.Add("rest_rad", i == 0 ? body_.start_angle_rad : limb.rest_rad);
      rods.Add(rod.Object());
    }
    Parts figure;
    figure.Add("name", std::string_view(document_.figure.name));
    figure.Add("rods", Block(rods));
    return figure.Object();
  }

  const Document& document_;
  const Controller& controller_;
  Mechanism body_;
  Ports ports_;
  ControllerShape shape_;
  Parts whole_ = Parts::Lines();
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
