// SPDX-License-Identifier: MIT
#include "core/document/composite.h"

#include <algorithm>

#include "core/document/binary.h"

namespace gaitsmith {

namespace {

// Compares everything that acts on the figure at every step.
bool SameScene(const Document& a, const Document& b) {
  const auto bare = [](const Document& d) {
    Document scene;
    scene.model = d.model;
    scene.figure = d.figure;
    scene.environment = d.environment;
    scene.start = d.start;
    return EncodeBinary(scene);
  };
  return bare(a) == bare(b);
}

bool SameController(const Controller& a, const Controller& b) {
  return a.kind == b.kind && a.rules == b.rules && a.senses == b.senses && a.genes == b.genes;
}

bool SamePush(const Push& a, const Push& b) {
  return a.step == b.step && a.endpoint == b.endpoint && a.impulse_x_ns == b.impulse_x_ns &&
         a.impulse_y_ns == b.impulse_y_ns;
}

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
  if (!SameScene(a, b)) return 0;
  const auto same_clip = [&](const Clip& x, const Clip& y) {
    return x.start_step == y.start_step &&
           SameController(a.controllers[static_cast<std::size_t>(x.controller)],
                          b.controllers[static_cast<std::size_t>(y.controller)]);
  };
  return std::min(
      FirstDifference(a.timeline, b.timeline, same_clip, [](const Clip& c) { return c.start_step; }),
      FirstDifference(a.pushes, b.pushes, SamePush, [](const Push& p) { return p.step; }));
}

Motion SimulateAnew(const Document& d, const Document& before, Motion known) {
  return {std::move(known), PartingStep(d, before), ScriptOf(d)};
}

}  // namespace gaitsmith
