// SPDX-License-Identifier: MIT
// Cutting and joining clips, and the resulting composite motions.
#include "core/document/timeline_edit.h"

#include <catch_amalgamated.hpp>

#include "core/document/composite.h"
#include "core/document/link.h"
#include "core/physics/symmetry.h"
#include "core/rollout/mirror_image.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

// Three clips of two seconds with the controllers a, b, a.
Document ThreeClips(SenseKind kind = SenseKind::kTimer) {
  Document d = StarManTravel(kind);
  d.controllers = {RandomController(d.figure, d.senses, 3), RandomController(d.figure, d.senses, 4)};
  d.timeline = {{.controller = 0, .start_step = 0},
                {.controller = 1, .start_step = 200},
                {.controller = 0, .start_step = 400}};
  d.duration_steps = 600;
  REQUIRE(Validate(d));
  return d;
}

std::vector<int> Starts(const Document& d) {
  std::vector<int> starts;
  starts.reserve(d.timeline.size());
  for (const Clip& clip : d.timeline) starts.push_back(clip.start_step);
  return starts;
}
std::vector<int> Order(const Document& d) {
  std::vector<int> order;
  order.reserve(d.timeline.size());
  for (const Clip& clip : d.timeline) order.push_back(clip.controller);
  return order;
}

bool SameMotion(const Motion& a, const Motion& b) {
  if (a.Hash() != b.Hash() || a.Frames() != b.Frames()) return false;
  for (int frame = 0; frame < a.Frames(); ++frame) {
    const Motion::Frame &x = a.At(frame), &y = b.At(frame);
    if (x.x_m != y.x_m || x.turn_rad != y.turn_rad || x.clip != y.clip || x.rule != y.rule) return false;
    if (a.TermsAt(frame).effort_rad != b.TermsAt(frame).effort_rad) return false;
    if (a.TermsAt(frame).smoothness_radps2 != b.TermsAt(frame).smoothness_radps2) return false;
    for (int k = 0; k < a.Bones().endpoints; ++k) {
      if (a.Endpoint(frame, k).y != b.Endpoint(frame, k).y || a.Force(frame, k).y != b.Force(frame, k).y)
        return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("timeline: lengths travel with their clips", "[timeline]") {
  Document d = ThreeClips();
  REQUIRE(SetClipLength(d, 0, 300));
  CHECK(Starts(d) == std::vector{0, 300, 500});
  CHECK(d.duration_steps == 700);
  REQUIRE(ReorderClip(d, 0, 1));
  CHECK(Order(d) == std::vector{1, 0, 0});
  CHECK(Starts(d) == std::vector{0, 200, 500});
  REQUIRE(DuplicateClip(d, 0));
  CHECK(Order(d) == std::vector{1, 1, 0, 0});
  REQUIRE(RemoveClip(d, 2));
  CHECK(Order(d) == std::vector{1, 1, 0});
  CHECK(d.duration_steps == 600);
  REQUIRE(LoopTimeline(d, 3));
  CHECK(d.timeline.size() == 9);
  CHECK(d.duration_steps == 1800);
  CHECK(Validate(d));
}

TEST_CASE("timeline: a switch point stays between its neighbours", "[timeline]") {
  Document d = ThreeClips();
  REQUIRE(MoveSwitch(d, 1, 5000));
  CHECK(Starts(d) == std::vector{0, 400 - kShortestClip, 400});
  REQUIRE(MoveSwitch(d, 1, -5));
  CHECK(Starts(d) == std::vector{0, kShortestClip, 400});
  CHECK(d.duration_steps == 600);
  CHECK_FALSE(MoveSwitch(d, 0, 10));
  CHECK_FALSE(MoveSwitch(d, 3, 10));
}

TEST_CASE("timeline: splitting and inserting", "[timeline]") {
  Document d = ThreeClips();
  REQUIRE(SplitClip(d, 300));
  CHECK(Starts(d) == std::vector{0, 200, 300, 400});
  CHECK(Order(d) == std::vector{0, 1, 1, 0});
  CHECK_FALSE(SplitClip(d, 395));
  REQUIRE(InsertClips(d, {{.controller = 1, .steps = 150}}, 100));
  CHECK(Starts(d) == std::vector{0, 100, 250, 350, 450, 550});
  CHECK(Order(d) == std::vector{0, 1, 0, 1, 1, 0});
  CHECK(d.duration_steps == 750);
  REQUIRE(InsertClips(d, {{.controller = 0, .steps = 100}}, 750));  // at the end
  CHECK(Order(d).back() == 0);
  CHECK(d.duration_steps == 850);
  CHECK(Validate(d));
}

TEST_CASE("timeline: an insert cuts a clip where both parts are long enough, and else goes before or behind",
          "[timeline]") {
  // Each case: a step in the middle clip (200 to 400), and the starts of the clips after a cut and an
  // insertion there.
  const std::vector<std::pair<int, std::vector<int>>> cases = {
      {200 + kShortestClip - 1, {0, 200, 300, 500}},
      {200 + kShortestClip, {0, 200, 200 + kShortestClip, 300 + kShortestClip, 500}},
      {400 - kShortestClip, {0, 200, 400 - kShortestClip, 500 - kShortestClip, 500}},
      {400 - kShortestClip + 1, {0, 200, 400, 500}},
  };
  for (const auto& [step, starts] : cases) {
    CAPTURE(step);
    Document d = ThreeClips();
    REQUIRE(InsertClips(d, {{.controller = 0, .steps = 100}}, step));
    CHECK(Starts(d) == starts);
    CHECK(d.duration_steps == 700);
  }
}

TEST_CASE("timeline: a clip behind the end is brought in by an edit", "[timeline]") {
  Document d = ThreeClips();
  d.duration_steps = 350;
  REQUIRE(Validate(d));
  REQUIRE(DuplicateClip(d, 2));
  CHECK(Starts(d) == std::vector{0, 200, 350, 350 + kShortestClip});
  CHECK(d.duration_steps == 350 + 2 * kShortestClip);
  d = ThreeClips();
  d.timeline = {{.controller = 0, .start_step = 0}, {.controller = 1, .start_step = 400}};
  d.duration_steps = 300;
  REQUIRE(InsertClips(d, {{.controller = 1, .steps = 50}, {.controller = 0, .steps = 60}}, 300));
  CHECK(Order(d) == std::vector{0, 1, 0, 1});
  CHECK(Starts(d) == std::vector{0, 300, 350, 410});
  CHECK(d.duration_steps == 410 + kShortestClip);
  d = ThreeClips();
  d.duration_steps = d.timeline[2].start_step;  // the last clip starts at the end
  CHECK(StretchesOf(d)[2].steps == kShortestClip);
  // Too short for two shortest clips, so the border stays.
  d = ThreeClips();
  d.timeline = {{.controller = 0, .start_step = 0},
                {.controller = 1, .start_step = 85},
                {.controller = 0, .start_step = 95}};
  d.duration_steps = 100;
  REQUIRE(MoveSwitch(d, 2, 99));
  CHECK(Starts(d) == std::vector{0, 85, 95});
}

TEST_CASE("timeline: what goes over a limit changes nothing", "[timeline]") {
  Document d = ThreeClips();
  const auto before = Starts(d);
  CHECK(LoopTimeline(d, 21).error().what == "at most 120 s, there would be 126 s");
  CHECK(LoopTimeline(d, 1).error().what == "must be from 2 to 100, is 1");
  CHECK(LoopTimeline(d, 101).error().what == "must be from 2 to 100, is 101");
  CHECK_FALSE(InsertClips(d, {{.controller = 2, .steps = 100}}, 100));
  CHECK_FALSE(RemoveClip(d, -1));
  CHECK_FALSE(DuplicateClip(d, 3));
  CHECK(Starts(d) == before);
  for (int i = 0; i < kMaxControllers - 2; ++i) {
    Controller c = d.controllers[0];
    c.name = std::to_string(i);
    REQUIRE(AddController(d, c));
  }
  CHECK(AddController(d, d.controllers[0]) == 0);  // already in the document
  Controller more = d.controllers[0];
  more.name = "more";
  CHECK_FALSE(AddController(d, more));
  DropUnusedControllers(d, {});
  CHECK(d.controllers.size() == static_cast<std::size_t>(kMaxControllers));
  const std::vector<Clip> used = {{.controller = 0, .start_step = 0}, {.controller = 5, .start_step = 9}};
  DropUnusedControllers(d, used);
  CHECK(d.controllers.size() == static_cast<std::size_t>(kMaxControllers) - 1);
  DropUnusedControllers(d);
  CHECK(d.controllers.size() == 2);
}

TEST_CASE("composite: four timer controllers fit into a link", "[timeline][document]") {
  Document d = ThreeClips();
  d.title = "Mr. Star-Man shuffles right, cartwheels left, jumps, shuffles";
  d.controllers.clear();
  d.timeline.clear();
  for (int i = 0; i < 4; ++i) {
    d.controllers.push_back(RandomController(d.figure, d.senses, static_cast<std::uint64_t>(i) + 20));
    d.controllers.back().name = "Cartwheel number " + std::to_string(i);
    d.timeline.push_back({.controller = i, .start_step = 317 * i});
  }
  d.duration_steps = 1500;
  d.hash = Simulate(d).Hash();
  CHECK(EncodeLink(d).size() <= 1900);
}

TEST_CASE("composite: simulated anew from a change on, it is the same to the bit",
          "[timeline][determinism]") {
  for (const auto& [kind, model] :
       {std::pair(SenseKind::kTimer, 1), {SenseKind::kPhysical, 1}, {SenseKind::kPhysical, 2}}) {
    Document first = ThreeClips(kind);
    first.model = model;
    CAPTURE(model);
    const auto check = [&](const char* what, auto edit, int parts_at) {
      INFO(what);
      Document next = first;
      edit(next);
      REQUIRE(Validate(next));
      CHECK(PartingStep(next, first) == parts_at);
      CHECK(SameMotion(SimulateAnew(next, first, Simulate(first)), Simulate(next)));
    };
    check("nothing", [](Document&) {}, kMaxSteps);
    check("later switch", [](Document& d) { d.timeline[1].start_step = 333; }, 200);
    check("earlier switch", [](Document& d) { d.timeline[2].start_step = 250; }, 250);
    check("longer", [](Document& d) { d.duration_steps = 777; }, kMaxSteps);
    check("shorter", [](Document& d) { d.duration_steps = 431; }, kMaxSteps);
    check("shorter than a checkpoint", [](Document& d) { d.duration_steps = 40; }, kMaxSteps);
    check("another clip", [](Document& d) { d.timeline.push_back({1, 500}); }, 500);
    check("a clip less", [](Document& d) { d.timeline.pop_back(); }, 400);
    check("another rule", [](Document& d) { d.controllers[1].genes[0] ^= 0x5555; }, 200);
    check(
        "a push", [](Document& d) { d.pushes = {{.step = 317, .endpoint = 2, .impulse_x_ns = 3.0f}}; }, 317);
    check("another ground", [](Document& d) { d.environment.slope_rad = 0.1f; }, 0);
    check("another start", [](Document& d) { d.start.drop_height_m = 0.4f; }, 0);
    check(
        "a figure with a rod less",
        [](Document& d) {
          d.figure.rods.pop_back();
          d.controllers = {RandomController(d.figure, d.senses, 7), RandomController(d.figure, d.senses, 8)};
        },
        0);
    check("another figure", [](Document& d) { d.figure.rods[1].length_m = 0.9f; }, 0);
    check("other joints", [](Document& d) { d.model = 3 - d.model; }, 0);
    check("weaker joints", [](Document& d) { d.figure.rods[1].strength = 0.5f; }, 0);
  }
}

TEST_CASE("composite: a motion parts at the first push that differs, in whatever it differs", "[timeline]") {
  Document first = ThreeClips();
  first.pushes = {{.step = 90, .endpoint = 1, .impulse_x_ns = 2.0f, .impulse_y_ns = 1.0f},
                  {.step = 250, .endpoint = 0, .impulse_x_ns = -1.0f}};
  CHECK(PartingStep(first, first) == kMaxSteps);
  const auto parts_at = [&](std::size_t push, void (*edit)(Push&)) {
    Document next = first;
    edit(next.pushes[push]);
    return PartingStep(next, first);
  };
  for (const std::size_t push : {0u, 1u}) {
    CAPTURE(push);
    const int step = first.pushes[push].step;
    CHECK(parts_at(push, [](Push& p) { p.step += 7; }) == step);
    CHECK(parts_at(push, [](Push& p) { p.step -= 7; }) == step - 7);
    CHECK(parts_at(push, [](Push& p) { p.endpoint = 3; }) == step);
    CHECK(parts_at(push, [](Push& p) { p.impulse_x_ns += 0.5f; }) == step);
    CHECK(parts_at(push, [](Push& p) { p.impulse_y_ns += 0.5f; }) == step);
  }
  Document other_senses = first;
  other_senses.controllers[1].senses.tau_max_s += 0.1f;
  CHECK(PartingStep(other_senses, first) == 200);
}

TEST_CASE("composite: rocking ground and pushes before the change are kept in time",
          "[timeline][determinism]") {
  Document first = ThreeClips(SenseKind::kPhysical);
  first.environment.sway_rad = 0.2f;
  first.pushes = {{.step = 100, .endpoint = 1, .impulse_x_ns = 2.0f},
                  {.step = 420, .endpoint = 0, .impulse_y_ns = 3.0f}};
  Document next = first;
  next.timeline[2].start_step = 350;
  next.pushes[1].impulse_x_ns = -4.0f;
  CHECK(SameMotion(SimulateAnew(next, first, Simulate(first)), Simulate(next)));
}

TEST_CASE("mirror image: a symmetric figure goes the other way", "[timeline][physics]") {
  for (const SenseKind kind : {SenseKind::kTimer, SenseKind::kPhysical}) {
    Document d = ThreeClips(kind);
    d.timeline.resize(1);
    d.duration_steps = 60;  // rounding errors grow: a longer motion may differ
    const Motion there = Simulate(d);
    REQUIRE(MirrorClip(d, 0));
    CHECK(d.controllers.size() == 3);
    const Motion back = Simulate(d);
    for (int frame = 0; frame < there.Frames(); ++frame) {
      CHECK(std::abs(there.At(frame).x_m + back.At(frame).x_m) < 1e-3);
      CHECK(std::abs(there.At(frame).y_m - back.At(frame).y_m) < 1e-3f);
    }
    CHECK(std::abs(there.At(60).x_m) > 1e-3);
    REQUIRE(MirrorClip(d, 0));  // the image of the image
    CHECK(d.controllers.size() == 3);
    CHECK(d.timeline[0].controller == 0);
  }
}

TEST_CASE("mirror image: which figures have one", "[timeline]") {
  Figure chain{.name = "worm", .rods = {}};
  for (int i = 0; i < 4; ++i) chain.rods.push_back({.parent = i - 1, .min_rad = -1.0f, .max_rad = 0.5f});
  const auto symmetry = SymmetryOf(chain);
  REQUIRE(symmetry);
  // A flat chain is reversed: the first joint takes the role of the last one, in the same direction.
  CHECK(symmetry->joint[0] == 2);
  CHECK_FALSE(symmetry->reversed[0]);
  CHECK(symmetry->endpoint[0] == 4);
  chain.rods[3].length_m = 1.5f;
  CHECK(SymmetryOf(chain).error().what == "the figure is not its own mirror image as it is drawn");
  Figure star = ShippedFigure("mr-star-man");
  CHECK(SymmetryOf(star));
  star.rods[1].max_rad = 0.3f;
  CHECK(SymmetryOf(star).error().what.starts_with("joints "));
}

}  // namespace gaitsmith::test
