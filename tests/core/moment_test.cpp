// SPDX-License-Identifier: MIT
// A moment that is saved and restored goes on as if the motion had never been left: what scrubbing, chaining
// and the transition maps stand on.
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/physics/simulation.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// A document's motion, step by step.
class Player {
 public:
  explicit Player(const Document& document) : document_(document), bones_(document.figure) {
    const auto limits = JointLimits(bones_);
    for (const Clip& clip : document.timeline) {
      const Controller& controller = document.controllers[static_cast<std::size_t>(clip.controller)];
      const std::span<const Gene> genes(controller.genes);
      controllers_.push_back(DecodeControllers<1>(controller.Shape(bones_.rods), controller.senses,
                                                  std::span(&genes, 1), limits, kStep));
    }
  }

  [[nodiscard]] Simulation<1> Begin() const {
    return {bones_, document_.environment, document_.start, document_.pushes};
  }
  /// @return the bits of where the step leads
  std::uint64_t Step(Simulation<1>& simulation, int step) const {
    for (std::size_t clip = 0; clip < controllers_.size(); ++clip) {
      if (document_.timeline[clip].start_step == step) simulation.Follow(controllers_[clip]);
    }
    simulation.Step();
    TrajectoryHash hash;
    simulation.AddTo(hash, 0);
    return hash.Value();
  }
  /// Who is in charge when a step ends.
  [[nodiscard]] const Controllers<1>* InCharge(int step) const {
    const Controllers<1>* in_charge = nullptr;
    for (std::size_t clip = 0; clip < controllers_.size(); ++clip) {
      if (document_.timeline[clip].start_step <= step) in_charge = &controllers_[clip];
    }
    return in_charge;
  }

 private:
  const Document& document_;
  Skeleton bones_;
  std::vector<Controllers<1>> controllers_;
};

}  // namespace

TEST_CASE("moment: restored after any step of a motion dense with contacts, it goes on bit by bit",
          "[physics][moment]") {
  // Feet on the ground in most steps: with pushes on a slope, with a network, with a change of clips.
  const char* name = GENERATE("horse-slope-pushed", "star-man-network", "star-man-composite");
  CAPTURE(name);
  const auto document = DecodeJson(ReadFile("tests/golden/motions/" + std::string(name) + ".json"));
  REQUIRE(document);
  const Player player(*document);
  const int steps = document->duration_steps;
  std::vector<std::uint64_t> bits;
  bits.reserve(static_cast<std::size_t>(steps));
  Simulation<1> whole = player.Begin();
  for (int step = 0; step < steps; ++step) bits.push_back(player.Step(whole, step));

  constexpr int kAhead = 40;
  int touching = 0;
  Simulation<1> going = player.Begin();  // itself restored after every step
  for (int step = 0; step < steps; ++step) {
    CAPTURE(step);
    REQUIRE(player.Step(going, step) == bits[static_cast<std::size_t>(step)]);
    for (const auto& normal : going.State().last_normal) {
      if (normal[0] <= 0.0f) continue;
      ++touching;
      break;
    }
    const Moment<1> moment = going.Save();
    Simulation<1> restored = player.Begin();
    restored.Restore(moment, player.InCharge(step));
    for (int later = step + 1; later < std::min(steps, step + kAhead); ++later) {
      REQUIRE(player.Step(restored, later) == bits[static_cast<std::size_t>(later)]);
    }
    going.Restore(moment, player.InCharge(step));
  }
  CAPTURE(touching, steps);
  CHECK(2 * touching > steps);
}

TEST_CASE("moment: a motion that shares its beginning with another has the same bits", "[physics][moment]") {
  for (const char* name : {"horse-slope-pushed", "star-man-network", "star-man-composite"}) {
    CAPTURE(name);
    const auto document = DecodeJson(ReadFile("tests/golden/motions/" + std::string(name) + ".json"));
    REQUIRE(document);
    const Document& d = *document;
    Motion motion = Simulate(d);
    const std::uint64_t hash = motion.Hash();
    for (const int parting : {0, 1, 99, 100, 101, 163, 200, 333, d.duration_steps - 1, d.duration_steps}) {
      CAPTURE(parting);
      motion = Motion(std::move(motion), parting, d.figure, d.environment, d.start, d.pushes, d.controllers,
                      d.timeline, d.duration_steps);
      CHECK(motion.Hash() == hash);
      CHECK(motion.Frames() == d.duration_steps + 1);
    }
  }
}

}  // namespace gaitsmith::test
