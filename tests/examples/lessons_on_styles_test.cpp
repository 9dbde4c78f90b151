// SPDX-License-Identifier: MIT
// Every number of the lesson about the map of styles is searched for and measured again here, as
// examples/lessons/make does.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <functional>
#include <vector>

#include "tests/lesson.h"
#include "tests/style_map.h"

namespace gaitsmith::test {

TEST_CASE("lessons: many ways to walk", "[lessons]") {
  const Lesson lesson = LessonOf("9-many-ways");
  const Document champion = Shipped("lessons/9-champion"), slider = Shipped("lessons/9-slider");
  const Document champion_on_mars = Shipped("lessons/9-champion-on-mars");
  const Document slider_on_mars = Shipped("lessons/9-slider-on-mars");
  Document searched = champion;
  searched.controllers.clear();
  searched.timeline.clear();
  Says(lesson, "The map has 512 squares.");
  Says(lesson, "after 12,000 tries");
  CHECK(searched.search.evaluations == 12000);
  const shell::EliteMap map = MapOf(searched);
  CHECK(map.Bins() * map.Bins() * map.Bins() == 512);
  Says(lesson, "Our search found 46 styles.");
  CHECK(map.Count() == 46);

  const float mars = champion_on_mars.environment.gravity_mps2;
  Says(lesson, "things weigh 38 % of what they weigh here");
  CHECK(Rounded(100.0f * mars / champion.environment.gravity_mps2, 0) == 38.0);
  std::vector<float> on_earth, on_mars;
  for (int square = 0; square < 512; ++square) {
    if (map.At(square / 64, square / 8 % 8, square % 8) == nullptr) continue;
    Document motion = map.MotionAt(square / 64, square / 8 % 8, square % 8);
    on_earth.push_back(std::abs(TermsOf(motion).travel_m));
    motion.environment.gravity_mps2 = mars;
    on_mars.push_back(std::abs(TermsOf(motion).travel_m));
  }
  std::ranges::sort(on_earth, std::greater());
  CHECK(TermsOf(champion).travel_m == on_earth[0]);
  Says(lesson, "on Earth it was only third");
  CHECK(TermsOf(slider).travel_m == on_earth[2]);
  CHECK(TermsOf(slider_on_mars).travel_m == *std::ranges::max_element(on_mars));
  Says(lesson, "| the champion | 6.2 m | [16.3 m]");
  CHECK(Rounded(TermsOf(champion).slip_sum_m, 1) == 6.2);
  CHECK(Rounded(TermsOf(champion).travel_m, 1) == 16.3);
  Says(lesson, "[4.4 m]");
  CHECK(Rounded(TermsOf(champion_on_mars).travel_m, 1) == 4.4);
  Says(lesson, "| another square | 14.7 m | [16.1 m]");
  CHECK(Rounded(TermsOf(slider).slip_sum_m, 1) == 14.7);
  CHECK(Rounded(TermsOf(slider).travel_m, 1) == 16.1);
  Says(lesson, "[15.7 m]");
  CHECK(Rounded(TermsOf(slider_on_mars).travel_m, 1) == 15.7);
}

}  // namespace gaitsmith::test
