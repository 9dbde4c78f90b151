// SPDX-License-Identifier: MIT
#include "core/document/composite.h"

#include <algorithm>
#include <functional>

#include "core/document/parts.h"

namespace gaitsmith {

namespace {

// The first step at which two lists, sorted by step, differ. kMaxSteps if they are equal.
template <class Item, class Same, class StepOf>
int FirstDifference(const std::vector<Item>& a, const std::vector<Item>& b, Same same, StepOf step_of) {
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same);
  const int in_a = x == a.end() ? kMaxSteps : step_of(*x);
  const int in_b = y == b.end() ? kMaxSteps : step_of(*y);
  return std::min(in_a, in_b);
}

}  // namespace

int PartingStep(const Document& a, const Document& b) {
  if (!SameParts(a, b, kScene)) return 0;
  const auto same_clip = [&](const Clip& x, const Clip& y) {
    return x.start_step == y.start_step &&
           SameBehaviour(a.controllers[static_cast<std::size_t>(x.controller)],
                         b.controllers[static_cast<std::size_t>(y.controller)]);
  };
  return std::min(
      FirstDifference(a.timeline, b.timeline, same_clip, [](const Clip& c) { return c.start_step; }),
      FirstDifference(a.pushes, b.pushes, std::equal_to<Push>(), [](const Push& p) { return p.step; }));
}

Motion SimulateAnew(const Document& d, const Document& before, Motion known) {
  return {std::move(known), PartingStep(d, before), ScriptOf(d)};
}

}  // namespace gaitsmith
