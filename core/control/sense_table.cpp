// SPDX-License-Identifier: MIT
#include "core/control/sense_table.h"

namespace gaitsmith {

SensePlace PlaceOf(SenseKind kind, const PortCount& ports, int sense) {
  const auto groups = SenseGroupsOf(kind);
  std::size_t group = 0;
  while (group + 1 < groups.size() && sense >= CountOf(groups[group].per, ports)) {
    sense -= CountOf(groups[group].per, ports);
    ++group;
  }
  return {&groups[group], sense};
}

std::string SenseName(SenseKind kind, const PortCount& ports, int sense) {
  const auto [group, index] = PlaceOf(kind, ports, sense);
  const bool length = group->quantity == SenseQuantity::kAngle && ports.muscles;
  const std::string name(length ? "length" : group->name);
  return group->per == SensePer::kBody ? name : name + " " + std::to_string(index + 1);
}

SenseScale ScaleOf(const SenseSpec& spec, const Ports& ports, int sense) {
  const auto [group, index] = PlaceOf(spec.kind, ports.Count(), sense);
  const SenseRange range = group->range(spec, ports, static_cast<std::size_t>(index));
  const bool length = group->quantity == SenseQuantity::kAngle && ports.muscles;
  return {length ? SenseQuantity::kLength : group->quantity, range.at_zero, range.at_one};
}

}  // namespace gaitsmith
