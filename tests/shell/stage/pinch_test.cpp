// SPDX-License-Identifier: MIT
// Fingers on the stage.
#include "shell/stage/pinch.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith::shell {
namespace {

constexpr ImVec2 kCanvas{400.0f, 800.0f};

class Fingers {
 public:
  Fingers() { pinch.area = ImRect(0.0f, 0.0f, 400.0f, 500.0f); }
  bool Down(int finger, float x, float y) { return Tell(SDL_FINGERDOWN, finger, x, y); }
  void Move(int finger, float x, float y) { Tell(SDL_FINGERMOTION, finger, x, y); }
  void Up(int finger) { Tell(SDL_FINGERUP, finger, 0.0f, 0.0f); }

  Pinch pinch;

 private:
  bool Tell(Uint32 type, int finger, float x, float y) {
    SDL_TouchFingerEvent event{};
    event.type = type;
    event.fingerId = finger;
    event.x = x / kCanvas.x;
    event.y = y / kCanvas.y;
    return pinch.Take(event, kCanvas);
  }
};

}  // namespace

TEST_CASE("Spreading fingers zooms by the ratio of their distances, about their midpoint") {
  Fingers fingers;
  REQUIRE_FALSE(fingers.Down(7, 150.0f, 200.0f));
  REQUIRE_FALSE(fingers.pinch.Holds());
  REQUIRE(fingers.Down(9, 250.0f, 200.0f));
  REQUIRE(fingers.pinch.Holds());
  fingers.Move(7, 100.0f, 200.0f);
  fingers.Move(9, 300.0f, 200.0f);
  const Pinch::Change change = fingers.pinch.TakeChange();
  REQUIRE(change.zoom == Catch::Approx(2.0f));
  REQUIRE(change.to.x == Catch::Approx(change.from.x));
  REQUIRE(fingers.pinch.TakeChange().zoom == 1.0f);  // reported once
}

TEST_CASE("Moving two fingers in parallel pans without zooming") {
  Fingers fingers;
  fingers.Down(1, 100.0f, 100.0f);
  fingers.Down(2, 160.0f, 180.0f);
  fingers.Move(1, 130.0f, 100.0f);
  fingers.Move(2, 190.0f, 180.0f);
  const Pinch::Change change = fingers.pinch.TakeChange();
  REQUIRE(change.zoom == Catch::Approx(1.0f));
  REQUIRE(change.to.x - change.from.x == Catch::Approx(30.0f));
}

TEST_CASE("The end of a pinch is not a tap, and the next finger starts a new gesture") {
  Fingers fingers;
  fingers.Down(1, 100.0f, 100.0f);
  fingers.Down(2, 200.0f, 100.0f);
  fingers.Up(1);
  REQUIRE(fingers.pinch.Holds());
  fingers.Move(2, 390.0f, 400.0f);
  REQUIRE(fingers.pinch.TakeChange().zoom == 1.0f);
  fingers.Up(2);
  REQUIRE_FALSE(fingers.pinch.Holds());
  fingers.Down(3, 100.0f, 100.0f);
  REQUIRE_FALSE(fingers.pinch.Holds());
}

TEST_CASE("Fingers outside the stage are ignored, and fingers close together do not zoom") {
  Fingers fingers;
  fingers.Down(1, 100.0f, 100.0f);
  REQUIRE_FALSE(fingers.Down(2, 200.0f, 700.0f));
  REQUIRE_FALSE(fingers.pinch.Holds());
  REQUIRE(fingers.Down(3, 120.0f, 100.0f));
  fingers.Move(3, 100.0f, 100.0f);
  REQUIRE(fingers.pinch.TakeChange().zoom == Catch::Approx(1.0f));
}

}  // namespace gaitsmith::shell
