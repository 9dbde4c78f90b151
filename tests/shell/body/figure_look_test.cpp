// SPDX-License-Identifier: MIT
// How figures are clothed.
#include "shell/body/figure_look.h"

#include <catch_amalgamated.hpp>
#include <filesystem>

#include "core/numeric/scalar_math.h"
#include "tests/scene.h"

namespace gaitsmith::shell {
namespace {

using Side = FigureLook::Side;

FigureLook LookOfShipped(const std::string& file) {
  const Figure figure = gaitsmith::test::ShippedFigure(file);
  return LookOf(figure);
}

}  // namespace

TEST_CASE("look: a heavier rod is a thicker limb, and none is thinner than a hair") {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(GAITSMITH_SOURCE_DIR) + "/examples/figures")) {
    const Figure figure = gaitsmith::test::ShippedFigure(entry.path().stem().string());
    const FigureLook look = LookOf(figure);
    CAPTURE(figure.name);
    for (std::size_t limb = 0; limb < look.limbs.size(); ++limb) {
      CHECK(look.limbs[limb].start_m > 0.2f * look.middle_m);
      CHECK(look.limbs[limb].end_m > 0.2f * look.middle_m);
      CHECK(look.limbs[limb].start_m < 2.5f * look.middle_m);
    }
    CHECK(look.sole_m > 0.0f);
    CHECK(look.sole_m < 1.5f * look.middle_m);
  }
  Figure figure = gaitsmith::test::ShippedFigure("mr-star-man");
  figure.rods[2].mass_kg *= 3.0f;
  const FigureLook look = LookOf(figure);
  CHECK(look.limbs[2].start_m > 1.5f * look.limbs[3].start_m);
}

TEST_CASE("look: of two like limbs at a joint the first is far, a star's arms are not") {
  const FigureLook ostrich = LookOfShipped("ostrich");
  for (const std::size_t rod : {5u, 6u, 7u}) CHECK(ostrich.limbs[rod].side == Side::kFar);
  for (const std::size_t rod : {8u, 9u, 10u}) CHECK(ostrich.limbs[rod].side == Side::kNear);
  for (const std::size_t rod : {0u, 1u, 2u, 3u, 4u}) CHECK(ostrich.limbs[rod].side == Side::kMiddle);
  for (const char* star : {"mr-star-man", "seven-star"}) {
    const FigureLook look = LookOfShipped(star);
    for (const FigureLook::Limb& limb : look.limbs) CHECK(limb.side == Side::kMiddle);
    CHECK(look.hub_m > 0.0f);
  }
}

TEST_CASE("look: a head needs its rod to end freely, and its figure's name up to a comma") {
  Figure ostrich = gaitsmith::test::ShippedFigure("ostrich");
  ostrich.name = "Ostrich, limber";
  CHECK(LookOf(ostrich).head == Head::kBeak);
  ostrich.name = "My bird";
  CHECK(LookOf(ostrich).head == Head::kNone);
  ostrich.rods.push_back({.length_m = 0.2f, .parent = 4});
  ostrich.name = "Ostrich";
  CHECK(LookOf(ostrich).head == Head::kNone);
  const Figure rod{.name = "Ostrich", .rods = {Rod{}}};
  CHECK(LookOf(rod).head == Head::kNone);
}

TEST_CASE("look: a mirrored head keeps its top above") {
  for (const char* name : {"ostrich", "frog", "horse", "kangaroo", "inchworm"}) {
    Figure figure = gaitsmith::test::ShippedFigure(name);
    CAPTURE(name);
    CHECK(LookOf(figure).crown == 1.0f);
    for (Rod& rod : figure.rods)
      rod.rest_rad = rod.parent == kNoParent ? static_cast<float>(kPi) - rod.rest_rad : -rod.rest_rad;
    CHECK(LookOf(figure).crown == -1.0f);
  }
}

}  // namespace gaitsmith::shell
