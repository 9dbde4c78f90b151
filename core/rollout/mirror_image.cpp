// SPDX-License-Identifier: MIT
#include "core/rollout/mirror_image.h"

#include "core/physics/symmetry.h"
#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

// The image of "Shuffle" is "Shuffle, mirrored", and the other way round.
std::string NameOfImage(const std::string& name) {
  static const std::string kSuffix = ", mirrored";
  constexpr std::size_t kRoom = 80;  // maximum length of a name in a document, in bytes
  if (name.ends_with(kSuffix)) return name.substr(0, name.size() - kSuffix.size());
  return name.empty() || name.size() + kSuffix.size() > kRoom ? name : name + kSuffix;
}

Gene Opposite(Gene gene) { return static_cast<Gene>(kGeneMax - gene); }

// The counterpart of a sense in the mirror image, and whether its interval is reversed there.
struct ImageOfSense {
  int sense;
  bool reversed;
};
ImageOfSense ImageOf(const Symmetry& symmetry, SenseKind kind, const PortCount& ports, int sense) {
  const auto [group, index] = PlaceOf(kind, ports, sense);
  const auto i = static_cast<std::size_t>(index);
  switch (group->per) {
    case SensePer::kActuator:
      return {sense - index + symmetry.joint[i], group->reverses && symmetry.reversed[i]};
    case SensePer::kContact:
      return {sense - index + symmetry.endpoint[i], false};
    case SensePer::kBody:
      break;
  }
  return {sense, false};
}

}  // namespace

Result<Controller> MirrorImageOf(const Controller& controller, const Figure& figure) {
  if (controller.kind == ControllerKind::kNetwork)
    return Fail(ErrorCode::kStructure, "",
                "a network has no mirror image: its sensors cannot feel the opposite");
  const auto symmetry = SymmetryOf(figure);
  if (!symmetry) return std::unexpected(symmetry.error());
  const PortCount ports = CountPorts(figure.HasSprings() ? kSpringModel : 1, figure);
  Controller image = controller;
  image.name = NameOfImage(controller.name);
  // Swaps the angles of a pose.
  const auto pose = [&](auto at) {
    for (int joint = 0; joint < ports.actuators; ++joint) {
      const Gene angle = controller.genes[at(joint)];
      const auto j = static_cast<std::size_t>(joint);
      image.genes[at(symmetry->joint[j])] = symmetry->reversed[j] ? Opposite(angle) : angle;
    }
  };
  if (controller.kind == ControllerKind::kTrajectory) {
    const CurveShape curves(controller.rules, ports);
    for (int knot = 0; knot < curves.knots; ++knot)
      pose([&](int joint) { return curves.Angle(knot, joint); });
    return image;
  }
  const BankShape shape(controller.rules, controller.senses.kind, ports);
  if (image.senses.kind == SenseKind::kSight)
    image.senses.facing = image.senses.facing == Facing::kRight ? Facing::kLeft : Facing::kRight;
  for (int rule = 0; rule < shape.rules; ++rule) {
    pose([&](int joint) { return shape.Target(rule, joint); });
    for (int sense = 0; sense < shape.senses; ++sense) {
      const auto [to, reversed] = ImageOf(*symmetry, controller.senses.kind, ports, sense);
      const Gene low = controller.genes[shape.Low(rule, sense)];
      const Gene high = controller.genes[shape.High(rule, sense)];
      image.genes[shape.Low(rule, to)] = reversed ? Opposite(high) : low;
      image.genes[shape.High(rule, to)] = reversed ? Opposite(low) : high;
    }
  }
  return image;
}

}  // namespace gaitsmith
