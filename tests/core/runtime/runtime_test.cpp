// SPDX-License-Identifier: MIT
// The C header for games decides as core does, for random controllers of every kind, and refuses damaged
// texts. tests/runtime/replay_test.sh does the same with recorded motions.
#include <algorithm>
#include <array>
#include <bit>
#include <catch_amalgamated.hpp>
#include <memory>
#include <string>

#include "core/control/controllers.h"
#include "core/numeric/random.h"
#include "core/physics/joint_response.h"
#include "core/runtime/gaitsmith.h"
#include "shell/export/exporters.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

/// A document whose first controller has random genes.
Document RandomDocument(ControllerKind kind, SenseKind senses, CurveEnd at_end, std::uint64_t seed) {
  Document document;
  document.figure = RandomFigure(seed);
  Controller controller;
  controller.kind = kind;
  controller.senses.kind = kind == ControllerKind::kTrajectory ? SenseKind::kTimer : senses;
  controller.senses.period_steps = 7 + static_cast<int>(seed % 90);
  controller.senses.at_end = at_end;
  controller.rules = 1 + static_cast<int>(seed % 32);
  const Skeleton skeleton(document.figure);
  RandomStream random(seed, 0, 0);
  controller.genes.resize(controller.Shape(PortsOf(skeleton).Count()).Genes());
  for (Gene& gene : controller.genes) gene = static_cast<Gene>(random.Below(65536));
  document.controllers = {controller};
  document.timeline = {{.controller = 0, .start_step = 0}};
  return document;
}

/// A text in memory of exactly its size, so that a sanitizer sees every byte read beyond it.
struct Exact {
  explicit Exact(const std::string& text) : size(text.size()), bytes(std::make_unique<char[]>(size)) {
    std::ranges::copy(text, bytes.get());
  }
  std::size_t size;
  std::unique_ptr<char[]> bytes;
};

int Load(const std::string& text, gaitsmith_controller& controller, std::size_t& where) {
  const Exact exact(text);
  return gaitsmith_load(&controller, exact.bytes.get(), exact.size, &where);
}

std::uint32_t BitPattern(float value) { return std::bit_cast<std::uint32_t>(value); }

}  // namespace

TEST_CASE("runtime: decides as core does, bit for bit", "[runtime]") {
  const auto kind = GENERATE(ControllerKind::kRules, ControllerKind::kNetwork, ControllerKind::kTrajectory);
  const auto senses = GENERATE(SenseKind::kPhysical, SenseKind::kTimer, SenseKind::kSight);
  const auto at_end = GENERATE(CurveEnd::kRepeat, CurveEnd::kRest);
  if (kind != ControllerKind::kRules && senses != SenseKind::kPhysical) return;
  if (kind != ControllerKind::kTrajectory && at_end != CurveEnd::kRepeat) return;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(kind, senses, at_end, seed);
    const Document document = RandomDocument(kind, senses, at_end, seed);
    const Controller& controller = document.controllers[0];
    auto loaded = std::make_unique<gaitsmith_controller>();
    std::size_t where = 0;
    REQUIRE(Load(shell::ControllerJson(document), *loaded, where) == GAITSMITH_OK);
    const Skeleton skeleton(document.figure);
    const Ports ports = PortsOf(skeleton);
    const std::span<const Gene> genes(controller.genes);
    const auto decoded = DecodeControllers<1>(controller.Shape(ports.Count()), controller.senses,
                                              std::span(&genes, 1), ports, kStep);
    ControllerState<1> control;
    ActuatorTargets<1> targets{};
    gaitsmith_state state;
    std::visit([&](const auto& one) { Begin(one, control, targets); }, decoded);
    gaitsmith_begin(loaded.get(), &state);

    RandomStream random(seed, 0, 1);
    const auto draw = [&random](float low, float high) {
      return low + (high - low) * (1.0f / 65535.0f) * static_cast<float>(random.Below(65536));
    };
    std::array<Lane<1>::F, kMaxJoints> angle{}, rate{}, turn{};
    std::array<Lane<1>::F, kMaxContacts> impulse{};
    std::array<float, kMaxJoints> own_angle{}, own_rate{};
    int different = 0;
    for (int step = 0; step < 300; ++step) {
      MoveJoints<1>(skeleton, targets, kStep, angle, rate, turn);
      for (int j = 0; j < skeleton.joints; ++j) {
        const auto i = static_cast<std::size_t>(j);
        gaitsmith_move(loaded.get(), &state, j, &own_angle[i], &own_rate[i]);
        if (BitPattern(own_angle[i]) != BitPattern(angle[i][0]) ||
            BitPattern(own_rate[i]) != BitPattern(rate[i][0]))
          ++different;
      }
      for (int k = 0; k < skeleton.endpoints; ++k)
        impulse[static_cast<std::size_t>(k)][0] = std::max(0.0f, draw(-0.2f, 0.3f));
      const Lane<1>::F height{draw(0.0f, 3.0f)}, rise{draw(-4.0f, 4.0f)};
      const Readings<1> readings{.position = angle.data(),
                                 .rate = rate.data(),
                                 .change = turn.data(),
                                 .impulse = impulse.data(),
                                 .height = &height,
                                 .rise = &rise};
      ++control.steps;
      std::visit([&](const auto& one) { Advance(one, readings, control, targets); }, decoded);
      // What core sensed. Heights and joint angles also as the header senses them.
      std::array<float, GAITSMITH_SENSES> felt{};
      for (int i = 0; i < loaded->senses; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto limb = static_cast<std::size_t>(i - skeleton.endpoints);
        felt[at] = kind == ControllerKind::kRules ? control.senses[at][0]
                   : i < skeleton.endpoints       ? impulse[at][0]
                                                  : angle[limb][0];
        if (kind != ControllerKind::kRules || controller.senses.kind == SenseKind::kTimer) continue;
        const int rest = i - skeleton.joints - skeleton.endpoints;
        if (i < skeleton.joints &&
            BitPattern(gaitsmith_normalise(loaded.get(), i, angle[at][0])) != BitPattern(felt[at]))
          ++different;
        if (rest == 0 && BitPattern(gaitsmith_normalise(loaded.get(), i, height[0])) != BitPattern(felt[at]))
          ++different;
        if (rest == 1 && BitPattern(gaitsmith_normalise(loaded.get(), i, rise[0])) != BitPattern(felt[at]))
          ++different;
      }
      gaitsmith_step(loaded.get(), &state, felt.data());
      const int rule = std::visit([&](const auto& one) { return ActivityOf(one, control).rule; }, decoded);
      if (state.rule != rule) ++different;
      for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton.joints); ++j) {
        if (BitPattern(state.target[j]) != BitPattern(targets.target[j][0])) ++different;
        if (BitPattern(state.decay[j]) != BitPattern(targets.decay[j][0])) ++different;
        if (BitPattern(1.0f / state.tau[j]) != BitPattern(targets.inverse_tau[j][0])) ++different;
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("runtime: a text that is cut anywhere is refused there", "[runtime]") {
  const auto kind = GENERATE(ControllerKind::kRules, ControllerKind::kNetwork, ControllerKind::kTrajectory);
  const std::string whole =
      shell::ControllerJson(RandomDocument(kind, SenseKind::kSight, CurveEnd::kRest, 3));
  const std::string text = whole.substr(0, whole.rfind('}') + 1);
  auto controller = std::make_unique<gaitsmith_controller>();
  for (std::size_t size = 0; size < text.size(); ++size) {
    std::size_t where = text.size() + 1;
    const int error = Load(text.substr(0, size), *controller, where);
    if (error == GAITSMITH_OK || where > size) FAIL("of " << size << " bytes: " << error << " at " << where);
  }
  std::size_t where = 0;
  CHECK(Load(text, *controller, where) == GAITSMITH_OK);
  CHECK(where == text.size());
  CHECK(Load(text + "x", *controller, where) == GAITSMITH_SYNTAX);
  CHECK(where == text.size());
}

TEST_CASE("runtime: numbers out of range, unknown words and wrong lengths are refused", "[runtime]") {
  const std::string text =
      R"({"version": 1, "kind": "rules", "step_s": 0.01, "joints": [{"min_rad": -1, "max_rad": 1}],
  "senses": [{"at_zero": -1, "at_one": 1, "clip": "none"}],
  "rules": [{"targets_rad": [0.5], "tau_s": 0.3, "decay": 0.96, "when": [[0, 0.5, 2.5]]}]})";
  auto controller = std::make_unique<gaitsmith_controller>();
  std::size_t where = 0;
  REQUIRE(Load(text, *controller, where) == GAITSMITH_OK);
  struct Change {
    const char *from, *to;
    int error;
  };
  for (const auto& [from, to, error] : std::to_array<Change>({
           {"\"version\": 1", "\"version\": 2", GAITSMITH_RANGE},
           {"\"rules\", \"step", "\"reflex\", \"step", GAITSMITH_RANGE},
           {"\"none\"", "\"some\"", GAITSMITH_RANGE},
           {"0.01", "0.0", GAITSMITH_RANGE},
           {"0.3", "-0.3", GAITSMITH_RANGE},
           {"0.3", "1e99", GAITSMITH_RANGE},
           {"0.3", "1e999999999999", GAITSMITH_RANGE},
           {"0.3", "\"0.3\"", GAITSMITH_SYNTAX},
           {"0.3", "0.", GAITSMITH_SYNTAX},
           {"0.3", "nan", GAITSMITH_SYNTAX},
           {"[0.5]", "[5]", GAITSMITH_RANGE},
           {"[0.5]", "[0.5, 0.5]", GAITSMITH_SHAPE},
           {"[0.5]", "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]", GAITSMITH_RANGE},
           {"[0, 0.5, 2.5]", "[1, 0.5, 2.5]", GAITSMITH_SHAPE},
           {"[0, 0.5, 2.5]", "[-1, 0.5, 2.5]", GAITSMITH_SHAPE},
           {"[0, 0.5, 2.5]", "[0.5, 0.5, 2.5]", GAITSMITH_SHAPE},
           {"[0, 0.5, 2.5]", "[0, 0.5]", GAITSMITH_SHAPE},
           {", \"decay\": 0.96", "", GAITSMITH_SHAPE},
           {"\"clip\": \"none\"", "\"clip\": \"none\", \"tau_s\": 1", GAITSMITH_SHAPE},
           {"\"step_s\"", "\"at_end\": \"rest\", \"step_s\"", GAITSMITH_SHAPE},
           {"\"step_s\"", "\"period_steps\": 20.5, \"step_s\"", GAITSMITH_SHAPE},
           {"\"step_s\"", "\"note\": [[1, {\"a\": \"]\\\"\"}], null], \"step_s\"", GAITSMITH_OK},
           {"\"step_s\"", "\"period_steps\": 20, \"step_s\"", GAITSMITH_OK},
       })) {
    CAPTURE(from, to);
    std::string changed = text;
    changed.replace(changed.find(from), std::string(from).size(), to);
    CHECK(Load(changed, *controller, where) == error);
    CHECK(where <= changed.size());
  }
}

}  // namespace gaitsmith::test
