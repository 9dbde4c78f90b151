// SPDX-License-Identifier: MIT
// Explanations of the active rule: the sentences have the numbers of the choice, with units.
#include "shell/words/rule_words.h"

#include <catch_amalgamated.hpp>

#include "core/control/rule_edit.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

/// Three rules over a timer of 1 s: rule 1 from 0 to 0.4 s, rule 2 from 0.2 to 1 s, rule 3 from 0.6 to 0.7 s.
struct Clockwork {
  Document document;

  Clockwork() {
    document.figure = gaitsmith::test::ShippedFigure("inchworm");
    document.senses.kind = SenseKind::kTimer;
    document.duration_steps = 250;
    document.timeline = {{0, 0}};
    Controller controller{"clockwork", ControllerKind::kRules, document.senses, 3, {}};
    controller.genes.assign(controller.Shape(3).Genes(), 30000);
    RuleEdit(controller, 3, 0).SetInterval(0, 0.0f, 0.4f);
    RuleEdit(controller, 3, 1).SetInterval(0, 0.2f, 1.0f);
    RuleEdit(controller, 3, 2).SetInterval(0, 0.6f, 0.7f);
    document.controllers = {controller};
  }
  [[nodiscard]] std::string Why(int frame, int rule) const {
    const Motion motion = Simulate(document);
    const auto moment = MomentOf(document.controllers[0], motion, 0, frame);
    REQUIRE(moment);
    return WhyWords(*moment, rule);
  }
};

}  // namespace

TEST_CASE("why: the winner's sense, how well it matches, and the next rule", "[shell][rule_words]") {
  const Clockwork clockwork;
  // Depth of rule 1: 1 - 0.1 / 0.2. Depth of rule 2: 1 - 0.3 / 0.4.
  CHECK(clockwork.Why(30, 0) ==
        "Rule 1 is active: timer at 0.30 s is in range (match 50 %). Next best is rule 2 (match 25 %).");
  CHECK(clockwork.Why(30, 1) == "Rule 2 matches too (25 %), but rule 1 matches better (50 %).");
  CHECK(clockwork.Why(30, 2) == "Rule 3 is inactive: timer at 0.30 s is 0.30 s below its range.");
  // The timer's period is 1 s, so 1.10 s is equivalent to 0.10 s.
  CHECK(clockwork.Why(110, 0) ==
        "Rule 1 is active: timer at 0.10 s is in range (match 50 %). No other rule matches. Nearest "
        "is rule 2: timer at 0.10 s, 0.10 s below its range.");
}

TEST_CASE("why: the first rule is active before any sensing, and without a match the last one stays active",
          "[shell][rule_words]") {
  Clockwork clockwork;
  CHECK(clockwork.Why(0, 0) ==
        "Rule 1 is active: a controller starts with its first rule, before it senses anything.");
  CHECK(clockwork.Why(0, 2) ==
        "Rule 3 is inactive: a controller starts with rule 1, before it senses anything.");
  RuleEdit(clockwork.document.controllers[0], 3, 1).SetInterval(0, 0.2f, 0.5f);
  CHECK(clockwork.Why(55, 1) ==
        "Rule 2 stays active, because no rule matches. Nearest is rule 1: timer at 0.55 s, 0.15 s above its "
        "range.");
  RuleEdit(clockwork.document.controllers[0], 3, 2).SetCares(0, false);
  CHECK(clockwork.Why(55, 2).starts_with("Rule 3 is active: it uses no sense, so it always matches."));
}

TEST_CASE("why: no explanation for a clip that is not active", "[shell][rule_words]") {
  Clockwork clockwork;
  clockwork.document.timeline = {{0, 0}, {0, 100}};
  const Motion motion = Simulate(clockwork.document);
  CHECK_FALSE(MomentOf(clockwork.document.controllers[0], motion, 0, 120));
  // A clip that takes over starts with its first rule, whatever rule was active before.
  const auto taken = MomentOf(clockwork.document.controllers[0], motion, 1, 101);
  REQUIRE(taken);
  CHECK(taken->choice.rule == motion.At(101).rule);
}

TEST_CASE("why: quantities have their units", "[shell][rule_words]") {
  CHECK(QuantityWords(SenseQuantity::kAngle, -0.5f) == "−29°");
  CHECK(QuantityWords(SenseQuantity::kForce, 3.21f) == "3.2 N");
  CHECK(QuantityWords(SenseQuantity::kForce, 123.4f) == "123 N");
  CHECK(QuantityWords(SenseQuantity::kHeight, 0.834f) == "0.83 m");
  CHECK(QuantityWords(SenseQuantity::kVelocity, -0.3f) == "−0.30 m/s");
  CHECK(QuantityWords(SenseQuantity::kTime, 0.42f) == "0.42 s");
}

}  // namespace gaitsmith::shell::test
