// SPDX-License-Identifier: MIT
// Every number in the lessons about rules, senses, timers and timelines is measured here, in the documents
// that the lessons link to. Every goal can be reached.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/control/rule_edit.h"
#include "core/document/timeline_edit.h"
#include "core/document/transition.h"
#include "core/numeric/scalar_math.h"
#include "tests/flight_time.h"
#include "tests/lesson.h"

namespace gaitsmith::test {

namespace {

std::map<int, int> StepsOfRules(const Motion& motion) {
  std::map<int, int> steps;
  for (int frame = 1; frame < motion.Frames(); ++frame) ++steps[motion.At(frame).rule];
  return steps;
}

}  // namespace

TEST_CASE("lessons: what a rule is", "[lessons]") {
  const Lesson lesson = LessonOf("1-a-rule");
  Document kangaroo = Shipped("gallery/kangaroo-hop");
  const int rods = kangaroo.figure.Rods();
  const Motion motion = Simulate(kangaroo);
  Says(lesson, "This kangaroo hops 25.9 m in 8 s");
  CHECK(Rounded(motion.TermsAt(800).travel_m, 1) == 25.9);
  CHECK(kangaroo.duration_steps == 800);
  Says(lesson, "All it has is six **rules**.");
  CHECK(kangaroo.controllers[0].rules == 6);

  Says(lesson,
       "The **flying rule** is in charge for more than seven of the eight seconds. It holds the leg ready, "
       "and lets the kangaroo fly.");
  const auto steps = StepsOfRules(motion);
  CHECK(steps.size() == 2);
  CHECK(steps.at(0) > 700);
  int flights = 0, kicks = 0;
  for (int frame = 1; frame <= 800; ++frame) {
    if (InFlight(motion, frame)) ++flights;
    if (motion.At(frame).rule == 2) kicks += motion.At(frame - 1).rule != 2 ? 1 : 0;
  }
  CHECK(flights > 400);
  Says(lesson, "The **kicking rule** comes in eleven times, for half a second in all.");
  CHECK(kicks == 11);
  CHECK(std::abs(steps.at(2) - 50) <= 10);
  Says(lesson,
       "It waits until the tip of the foot presses on the ground with more than half of the kangaroo's "
       "weight.");
  // Index of the toe's force sense: the seventh endpoint, after the angles.
  const int toe = (rods - 1) + 6;
  const Stimulus kick = StimulusOf(kangaroo.controllers[0], rods, 2, toe);
  CHECK(kick.cares);
  CHECK(kick.low * kangaroo.senses.force_weights > 0.5f);
  CHECK(kick.low * kangaroo.senses.force_weights < 0.65f);
  Says(lesson, "Then it takes up another pose, fast");
  CHECK(TauOf(kangaroo.controllers[0], rods, 2) < 0.08f);

  Says(lesson, "Four rules can go, and nothing changes: it is the same motion, bit for bit.");
  for (const int rule : {5, 4, 3, 1}) DeleteRule(kangaroo.controllers[0], rods, rule);
  CHECK(Simulate(kangaroo).Hash() == motion.Hash());
  CHECK(Reaches(lesson.fields.at("goal"), kangaroo));
  for (const int rule : {0, 1}) {
    // "If the kangaroo falls over, that rule was needed"
    Document less = Shipped("gallery/kangaroo-hop");
    DeleteRule(less.controllers[0], rods, rule == 0 ? 0 : 2);
    CHECK_FALSE(TermsOf(less).travel_m > 10.0f);
  }
}

TEST_CASE("lessons: timer or senses", "[lessons]") {
  const Lesson lesson = LessonOf("3-timer-or-senses");
  const std::string& goal = lesson.fields.at("goal");
  const Document timer = Shipped("lessons/3-clock-pushed"), senses = Shipped("lessons/3-senses-pushed"),
                 behind = Shipped("lessons/3-senses-from-behind");
  const auto pushed = [](Document document, int step, float impulse_ns) {
    document.pushes = {{.step = step, .impulse_x_ns = impulse_ns}};
    return document;
  };
  Says(lesson, "Give both the same push: 10 N s (newton seconds), straight back, at 3 s.");
  CHECK(TermsOf(timer).travel_m == TermsOf(pushed(timer, 300, -10.0f)).travel_m);
  CHECK(TermsOf(senses).travel_m == TermsOf(pushed(senses, 300, -10.0f)).travel_m);
  CHECK(TermsOf(behind).travel_m == TermsOf(pushed(senses, 300, 10.0f)).travel_m);
  CHECK(timer.figure.Rods() == senses.figure.Rods());
  Says(lesson, "These legs weigh 3.4 kg, so it takes nearly 3 m/s off their speed.");
  CHECK(std::abs(Skeleton(timer.figure).mass_kg - 3.4f) < 1e-4f);
  Says(lesson, "a clock that starts anew every second");
  CHECK(timer.controllers[0].senses.period_steps == 100);

  Says(lesson, "The timer's legs are down by 3.6 s and end at 5 m.");
  const Motion fallen = Simulate(timer);
  CHECK(ToppledAt(fallen) < 3.6);
  CHECK(Rounded(TermsOf(timer).travel_m, 0) == 5);
  Says(lesson, "The legs with senses stumble, and reach 31 m.");
  CHECK(TermsOf(senses).travel_m > 31.0f);
  CHECK(TermsOf(senses).travel_m < 32.0f);
  Says(lesson, "Exactly what they would have done without the push.");
  Document alone = timer;
  alone.pushes.clear();
  const Motion unpushed = Simulate(alone);
  for (int frame = 0; frame < unpushed.Frames(); ++frame)
    REQUIRE(unpushed.At(frame).rule == fallen.At(frame).rule);

  Says(lesson,
       "We pushed both at ten moments: 3.0 s, 3.1 s, and so on to 3.9 s. Pushed back, senses stayed up ten "
       "times, the timer four times.");
  Says(lesson, "Pushed *from behind*, the timer stayed up five times, and senses never.");
  const auto survived = [&](const Document& document, float impulse_ns) {
    int times = 0;
    for (int step = 300; step < 400; step += 10) times += StaysUp(pushed(document, step, impulse_ns)) ? 1 : 0;
    return times;
  };
  CHECK(survived(senses, -10.0f) == 10);
  CHECK(survived(timer, -10.0f) == 4);
  CHECK(survived(timer, 10.0f) == 5);
  CHECK(survived(senses, 10.0f) == 0);
  CHECK_FALSE(StaysUp(behind));

  Says(lesson, "(Without any push they get 23 m: that does not count.)");
  CHECK(Rounded(TermsOf(alone).travel_m, 0) == 23);
  int moments = 0;
  for (int step = 300; step < 400; step += 2) moments += Reaches(goal, pushed(timer, step, -10.0f)) ? 1 : 0;
  CHECK(moments >= 15);  // of fifty, so a reader who tries a few moments finds one
}

TEST_CASE("lessons: wind-up toys", "[lessons]") {
  const Lesson lesson = LessonOf("6-wind-up-toys");
  const std::string& goal = lesson.fields.at("goal");
  Says(lesson,
       "Four Beryls, each found by the same search with 6,000 tries and the same seed. Only *t_p* differs");
  struct Toy {
    const char* says;
    const char* file;
    int period;
    double way, turns;
  };
  for (const Toy& toy : {Toy{"| 0.3 s | 28.6 m | 0.1 |", "6-clock-03", 30, 28.6, 0.1},
                         Toy{"| 0.8 s | 45.3 m | 0.0 |", "6-clock-08", 80, 45.3, 0.0},
                         Toy{"| 3 s | 25.6 m | 7.3 |", "6-clock-3", 300, 25.6, 7.3},
                         Toy{"| 12 s | 22.7 m | 1.9 |", "6-clock-12", 1200, 22.7, 1.9}}) {
    Says(lesson, toy.says);
    CAPTURE(toy.file);
    Document found = Shipped("lessons/6-clock-03");
    found.senses.period_steps = toy.period;
    found = FindWith(found, Algorithm::kSphc, 3, 6000).document;
    const Document shipped = Shipped(std::string("lessons/") + toy.file);
    const Motion motion = Simulate(found);
    CHECK(HashText(motion.Hash()) == HashText(*shipped.hash));
    CHECK(Rounded(motion.TermsAt(800).travel_m, 1) == toy.way);
    CHECK(Rounded(motion.TermsAt(800).rotations, 1) == toy.turns);
    CHECK(Reaches(goal, found) == (toy.period == 300));
    if (toy.period > 100) continue;
    // The joints of any timer repeat, so the body is what counts. The start is over after 3 s.
    for (int frame = 300 + toy.period; frame <= 800; ++frame) {
      const auto &now = motion.At(frame), &before = motion.At(frame - toy.period);
      for (int joint = 0; joint < motion.Bones().joints; ++joint) {
        REQUIRE(static_cast<double>(
                    std::abs(motion.AngleRad(frame, joint) - motion.AngleRad(frame - toy.period, joint))) <
                0.001 * kPi / 180.0);
      }
      REQUIRE(std::abs(now.y_m - before.y_m) < 1.5e-4f);
      REQUIRE(std::abs(static_cast<double>(now.turn_rad - before.turn_rad)) < 0.01 * kPi / 180.0);
    }
  }
  Says(lesson, "one period later it is up to 1.4 m higher or lower");
  const Motion somersaults = Simulate(Shipped("lessons/6-clock-3"));
  float most_m = 0.0f;
  for (int frame = 600; frame <= 800; ++frame)
    most_m = std::max(most_m, std::abs(somersaults.At(frame).y_m - somersaults.At(frame - 300).y_m));
  CHECK(Rounded(most_m, 1) == 1.4);
  Says(lesson, "Beryl patters 28.6 m in 8 s");
  Says(lesson, "The joints of any wind-up toy come back after each period");
  Says(lesson,
       "At 0.3 and 0.8 s it comes back as well: after a short start it is as high as one period before, to a "
       "tenth of a "
       "millimetre, and leans as much, to a hundredth of a degree.");
  Says(lesson,
       "She creeps, for 3 s, not much more than 1 m. Then she winds up for one leap, nearly 8 m high.");
  const Motion leap = Simulate(Shipped("lessons/6-clock-12"));
  CHECK(leap.At(300).x_m < 1.3);
  CHECK(leap.At(300).x_m > 1.0);
  CHECK(Rounded(leap.TermsAt(800).max_cm_height_m, 1) == 7.8);
  CHECK(LongestFlight(leap, 1, 800) > 200);
  Says(lesson, "With the clock at 0.9 s the second Beryl falls: 16 m instead of 45.3 m.");
  Document slower = Shipped("lessons/6-clock-08");
  slower.controllers[0].senses.period_steps = 90;
  CHECK(Rounded(TermsOf(slower).travel_m, 0) == 16);
  CHECK(ToppledAt(Simulate(slower)) < 8.0);
}

TEST_CASE("lessons: chaining", "[lessons]") {
  const Lesson lesson = LessonOf("7-chaining");
  const std::string& goal = lesson.fields.at("goal");
  // figure_12_test.cpp checks what each part of Figure 12 does.
  const Document figure = Shipped("figure-12");
  Says(lesson, "There are three sets of rules, each found alone");
  CHECK(figure.controllers.size() == 3);
  Says(lesson, "Find the borders on the timeline, under the stage: 2.6 s, 6.9 s, 8.5 s.");
  REQUIRE(figure.timeline.size() == 4);
  CHECK(figure.timeline[1].start_step == 260);
  CHECK(figure.timeline[2].start_step == 690);
  CHECK(figure.timeline[3].start_step == 850);

  const Document legs = Shipped("lessons/7-takeover");
  Says(lesson, "At 3.6 s, senses take over, and fall over at once. Both were good alone!");
  CHECK(legs.timeline[1].start_step == 360);
  CHECK(ToppledAt(Simulate(legs)) < 4.2);
  for (const int controller : {0, 1}) CHECK(UsualMotion(legs, controller).TermsAt(800).upright > 0.9f);
  CHECK_FALSE(Reaches(goal, legs));
  const auto moved = [&](int step) {
    Document document = legs;
    REQUIRE(MoveSwitch(document, 1, step));
    return document;
  };
  Says(lesson, "At 3.60 s the legs fall and get 8.7 m. At 3.65 s they get 31 m.");
  CHECK(Rounded(TermsOf(legs).travel_m, 1) == 8.7);
  CHECK(Rounded(TermsOf(moved(365)).travel_m, 0) == 31);
  CHECK(Reaches(goal, moved(365)));
  Says(lesson,
       "The legs stay up when the senses take over at 3.05, 4.05 or 5.05 s; at 3.35 or 4.35 s; at 3.65 or "
       "4.65 s. Halfway through a second, at 3.50 or 4.50 s, they fall.");
  for (const int step : {305, 405, 505, 335, 435, 365, 465}) CHECK(StaysUp(moved(step)));
  for (const int step : {350, 450}) CHECK(ToppledAt(Simulate(moved(step))) < 5.5);
  Says(lesson, "the timer's walk repeats every second");
  CHECK(legs.controllers[0].senses.period_steps == 100);
  Says(lesson,
       "We tried every twentieth of a second from 3.0 to 5.2 s. At 12 of 45 moments the legs get 25 m or "
       "more, "
       "and only 4 of them are after 4 s.");
  int moments = 0, good = 0, late = 0;
  for (int step = 300; step <= 520; step += 5, ++moments) {
    good += Reaches(goal, moved(step)) ? 1 : 0;
    late += step >= 400 && Reaches(goal, moved(step)) ? 1 : 0;
  }
  CHECK(moments == 45);
  CHECK(good == 12);
  CHECK(late == 4);
  Says(lesson,
       "at 4.05, 4.35 and 4.65 s they stay up and still miss the goal, with 24.5 m, 24.6 m and 23.2 m");
  CHECK(Rounded(TermsOf(moved(405)).travel_m, 1) == 24.5);
  CHECK(Rounded(TermsOf(moved(435)).travel_m, 1) == 24.6);
  CHECK(Rounded(TermsOf(moved(465)).travel_m, 1) == 23.2);

  // "The button goes to the best place." Of equally good places, the one scored first.
  const std::vector<int> steps = TransitionSteps(legs, 1);
  const TransitionMap map = TransitionMapOf(TransitionRequest(legs, 1));
  const std::vector<float> scores = map.Scores(0, map.Count());
  const std::vector<int> places = CoarseFirst(map.Count());
  const auto best = static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin());
  const int place = steps[static_cast<std::size_t>(places[best])];
  CAPTURE(place);
  CHECK(Reaches(goal, moved(place)));
}

}  // namespace gaitsmith::test
