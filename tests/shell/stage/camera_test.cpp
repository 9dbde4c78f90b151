// SPDX-License-Identifier: MIT
// What the camera shows of every motion of the gallery.
#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/standing.h"
#include "core/world/ground_preset.h"
#include "shell/stage/ground/ground_drawing.h"
#include "shell/stage/invitation.h"
#include "shell/stage/scene.h"
#include "tests/scene.h"

namespace gaitsmith::shell {

TEST_CASE("camera: the figure stands tall, and no motion of the gallery leaves the stage") {
  struct Stage {
    float width, height;
  };
  // A desk, a large screen, a phone upright and lying, a small phone lying, and text enlarged fourfold.
  for (const Stage& stage : {Stage{932, 485}, Stage{1572, 845}, Stage{390, 424}, Stage{496, 272},
                             Stage{640, 194}, Stage{320, 118}}) {
    const ImRect rect(0.0f, 44.0f, stage.width, 44.0f + stage.height);
    // With buttons on the ground, where the stage has room for them (HasStageActions).
    const float ground = rect.Max.y - GroundRoom(stage.height, stage.height >= 230.0f);
    for (const std::string& name : gaitsmith::test::GalleryDocuments()) {
      const auto document = DecodeJson(gaitsmith::test::ReadFile(name));
      REQUIRE(document);
      Playback player;
      player.Load(*document, true);
      CAPTURE(name, stage.width, stage.height);
      float scale_before = 0.0f;
      for (double time_s = 0.0; time_s < player.DurationS(); time_s += 0.05) {
        player.Seek(time_s);
        const Camera camera = AimCamera(player, document->environment, {}, rect, ground);
        CAPTURE(time_s);
        // Smooth: nothing grows or shrinks by more than an eighth in a twentieth of a second.
        if (scale_before > 0.0f) CHECK(std::abs(camera.scale / scale_before - 1.0f) < 0.125f);
        scale_before = camera.scale;
        const float standing = player.StandingM() * camera.scale;
        CHECK(standing <= std::max(0.51f * stage.height, 111.0f));
        // A long figure is limited by the width.
        const bool wide = 3.2f * player.ReachM() * camera.scale > 0.66f * stage.width ||
                          (stage.width < 700.0f ? 2.0f : 5.0f) * camera.scale > 0.66f * stage.width;
        CHECK((wide || standing >= 0.33f * stage.height));
        if (document->environment.slope_rad != 0.0f || document->environment.sway_rad != 0.0f) continue;
        const Playback::Point centre = player.CentreAt(time_s);
        CHECK(camera.ToScreen(centre.x_m, centre.y_m).y > rect.Min.y);
        // On the lowest stage the figure fills all of it, so a raised arm may leave it.
        if (stage.height < 150.0f) continue;
        for (const Playback::Point& point : player.EndpointsAt(time_s)) {
          const ImVec2 at = camera.ToScreen(point.x_m, point.y_m);
          CHECK(at.y > rect.Min.y - (stage.height < 250.0f ? 0.12f * stage.height : 0.0f));
          CHECK(at.y < rect.Max.y);
          CHECK(at.x > rect.Min.x - 0.1f * stage.width);
          CHECK(at.x < rect.Max.x + 0.1f * stage.width);
        }
      }
    }
  }
}

TEST_CASE("camera: it rises and falls with a drawn ground, smoothly") {
  const ImRect rect(0.0f, 0.0f, 932.0f, 485.0f);
  const float ground_y = rect.Max.y - GroundRoom(rect.GetHeight(), false);
  auto document = DecodeJson(gaitsmith::test::ReadFile("examples/star-man-shuffle.json"));
  REQUIRE(document);
  Playback level;
  level.Load(*document, true);
  LimitJoints(*document);
  for (const GroundPreset preset : {GroundPreset::kStairs, GroundPreset::kRamp, GroundPreset::kRubble}) {
    // To the side that this figure goes.
    document->environment.ground = GroundOf(preset);
    for (Corner& corner : document->environment.ground) corner.x_m *= -1.0f;
    std::ranges::reverse(document->environment.ground);
    REQUIRE(Validate(document->environment.ground));
    Playback player;
    player.Load(*document, true);
    float before = 0.0f;
    for (double time_s = 0.0; time_s < player.DurationS(); time_s += 0.05) {
      player.Seek(time_s);
      const Camera camera = AimCamera(player, document->environment, {}, rect, ground_y);
      CAPTURE(static_cast<int>(preset), time_s);
      const Playback::Point centre = player.CentreAt(time_s);
      const double level_m = player.Ground().HeightAt(centre.x_m);
      CHECK(std::abs(camera.ToScreen(centre.x_m, static_cast<float>(level_m)).y - ground_y) <
            0.3f * rect.GetHeight());
      CHECK(std::abs(camera.level_m - before) < 0.2f);
      before = camera.level_m;
      const Camera::Place there = camera.ToMetres(camera.ToScreen(centre.x_m, 0.4f));
      CHECK(there.x_m == Catch::Approx(centre.x_m).margin(1e-3));
      CHECK(there.y_m == Catch::Approx(0.4f).margin(1e-3));
    }
  }
}

TEST_CASE("camera: a text on a drawn ground lies below every part of the line over it") {
  const Terrain gap(GroundOf(GroundPreset::kGap));
  const Camera camera{.left_m = 0.0, .scale = 100.0f, .origin = {0.0f, 300.0f}};
  CHECK(BelowGround(camera, gap, 1.0, 20.0f, 19.0f).y == Catch::Approx(319.0f));
  CHECK(BelowGround(camera, gap, 1.9, 20.0f, 19.0f).y == Catch::Approx(419.0f));
  CHECK(BelowGround(camera, gap, 2.2, 20.0f, 19.0f).y == Catch::Approx(419.0f));
  // A motion that failed may be anywhere.
  CHECK(std::isfinite(BelowGround(camera, gap, 1e300, 20.0f, 19.0f).y));
}

TEST_CASE("camera: a figure without motion is some 90 points high on a low stage, if its width allows") {
  for (const ImVec2 size : {ImVec2(640, 194), ImVec2(320, 118)}) {
    const ImRect rect(0.0f, 0.0f, size.x, size.y);
    const float ground = rect.Max.y - GroundRoom(size.y, false);
    for (const std::string& name : gaitsmith::test::ShippedFigureFiles()) {
      const Document document = Standing(gaitsmith::test::ShippedFigure(name));
      Playback player;
      player.Load(document, true);
      CAPTURE(name, size.x, size.y);
      const Camera camera = AimCamera(player, document.environment, {}, rect, ground);
      const bool wide = std::max(2.0f, 3.2f * player.ReachM()) * camera.scale > 0.99f * size.x;
      CHECK((wide || player.StandingM() * camera.scale >= 86.0f));
    }
  }
}

TEST_CASE("camera: a figure that cannot move yet stands below the headline and beside the button") {
  for (const ImVec2 size : {ImVec2(1280, 532), ImVec2(1920, 892), ImVec2(390, 656), ImVec2(844, 272)}) {
    const ImRect stage(0.0f, 44.0f, size.x, 44.0f + size.y);
    const float ground = stage.Max.y - GroundRoom(size.y, !InvitesBeside(stage));
    for (const std::string& name : gaitsmith::test::AllShippedFigureFiles()) {
      const Document document = Standing(gaitsmith::test::ShippedFigure(name));
      Playback player;
      player.Load(document, true);
      CAPTURE(name, size.x, size.y);
      const Camera camera =
          AimCamera(player, document.environment, {}, stage, ground, InvitationFraming(stage));
      const float button = InvitesBeside(stage) ? stage.Min.x + 0.54f * size.x : stage.Max.x;
      for (const Playback::Point& point : player.EndpointsAt(0.0)) {
        const ImVec2 at = camera.ToScreen(point.x_m, point.y_m);
        CHECK(at.x > stage.Min.x);
        CHECK(at.x < button);
        CHECK(at.y > stage.Min.y + 48.0f);
        CHECK(at.y < ground + 1.0f);
      }
    }
  }
}

}  // namespace gaitsmith::shell
