// SPDX-License-Identifier: MIT
// A motion continues from a saved and restored moment without any difference. Scrubbing, chaining and
// transition maps rely on this.
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/physics/figure_plant.h"
#include "core/rollout/rollout.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

using FigureRollout = Rollout<FigurePlant, 1>;

/// Plays a document's motion step by step.
class Player {
 public:
  explicit Player(const Document& document)
      : document_(document),
        bones_(document.figure),
        takeovers_(DecodeClips(document.timeline, document.controllers, PortsOf(bones_), kStep)) {}

  [[nodiscard]] FigureRollout Begin() const {
    return {bones_, document_.environment, document_.start, document_.pushes, takeovers_};
  }
  /// @return hash of the positions after the step
  static std::uint64_t Step(FigureRollout& rollout) {
    TrajectoryHash hash;
    rollout.RunTo(rollout.StepNow() + 1, kNothing, [&] { rollout.PlantNow().AddTo(hash, 0); });
    return hash.Value();
  }

 private:
  const Document& document_;
  Skeleton bones_;
  std::vector<Takeover<1>> takeovers_;
};

}  // namespace

TEST_CASE("moment: restored after any step of a motion dense with contacts, it goes on bit by bit",
          "[physics][moment]") {
  // Feet on the ground in most steps: with pushes on a slope, with a network, and with a change of clips.
  const char* name = GENERATE("horse-slope-pushed", "star-man-network", "star-man-composite");
  CAPTURE(name);
  const auto document = DecodeJson(ReadFile("tests/golden/motions/" + std::string(name) + ".json"));
  REQUIRE(document);
  const Player player(*document);
  const int steps = document->duration_steps;
  std::vector<std::uint64_t> bits;
  bits.reserve(static_cast<std::size_t>(steps));
  FigureRollout whole = player.Begin();
  for (int step = 0; step < steps; ++step) bits.push_back(Player::Step(whole));

  constexpr int kAhead = 40;
  int touching = 0;
  FigureRollout going = player.Begin();  // restored after every step
  for (int step = 0; step < steps; ++step) {
    CAPTURE(step);
    REQUIRE(Player::Step(going) == bits[static_cast<std::size_t>(step)]);
    for (const auto& normal : going.PlantNow().Save().last_normal) {
      if (normal[0] <= 0.0f) continue;
      ++touching;
      break;
    }
    const Moment<FigurePlant, 1> moment = going.Save();
    FigureRollout restored = player.Begin();
    restored.Restore(moment);
    for (int later = step + 1; later < std::min(steps, step + kAhead); ++later) {
      REQUIRE(Player::Step(restored) == bits[static_cast<std::size_t>(later)]);
    }
    going.Restore(moment);
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
      motion = Motion(std::move(motion), parting, ScriptOf(d));
      CHECK(motion.Hash() == hash);
      CHECK(motion.Frames() == d.duration_steps + 1);
    }
  }
}

}  // namespace gaitsmith::test
