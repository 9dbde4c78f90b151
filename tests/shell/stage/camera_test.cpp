// SPDX-License-Identifier: MIT
// What the camera shows of every motion of the gallery.
#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/document/standing.h"
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

TEST_CASE("camera: a figure without motion is some 90 points high on a low stage, if its width allows") {
  for (const ImVec2 size : {ImVec2(640, 194), ImVec2(320, 118)}) {
    const ImRect rect(0.0f, 0.0f, size.x, size.y);
    const float ground = rect.Max.y - GroundRoom(size.y, false);
    for (const std::string& name : gaitsmith::test::ShippedFigureFiles()) {
      Document document;
      document.figure = gaitsmith::test::ShippedFigure(name);
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
    for (const std::string& name : gaitsmith::test::ShippedFigureFiles()) {
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
