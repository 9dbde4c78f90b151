// SPDX-License-Identifier: MIT
// Every number in the lessons about searches and styles is measured here, with the searches that the lessons'
// buttons start. Every goal can be reached.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/document/style_weights.h"
#include "tests/flight_time.h"
#include "tests/lesson.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// The best fitness after a number of evaluations.
float BestAfter(const Outcome& outcome, int evaluations) {
  float best = kVoidScore;
  for (const auto& point : outcome.curve) {
    if (point.evaluation <= evaluations) best = point.best;
  }
  return best;
}

}  // namespace

TEST_CASE("lessons: how search finds", "[lessons]") {
  const Lesson lesson = LessonOf("2-how-search-finds");
  const std::string& goal = lesson.fields.at("goal");
  const Document stuck = Shipped("lessons/2-stuck-horse"), lucky = Shipped("lessons/2-lucky-horse");
  Says(lesson,
       "This horse is the best of 4,000 tries, and it is dreadful: 4.4 m in 8 s, and halfway it topples "
       "over.");
  CHECK(stuck.search.evaluations == 4000);
  CHECK(stuck.search.seed == 6);
  CHECK(stuck.duration_steps == 800);
  CHECK(Rounded(TermsOf(stuck).travel_m, 1) == 4.4);
  CHECK(std::abs(ToppledAt(Simulate(stuck)) - 4.0) < 0.2);

  std::vector<Found> climbed;
  for (std::uint32_t seed = 1; seed <= 8; ++seed)
    climbed.push_back(FindWith(stuck, Algorithm::kShc, seed, 4000));
  const Outcome& third = climbed[2].outcome;
  Says(lesson, "Seed 3 begins with 0.2 m. After 500 tries it gets 32 m, after 4,000 tries 46 m");
  CHECK(Rounded(BestAfter(third, 1), 1) == 0.2);
  CHECK(Rounded(BestAfter(third, 500), 0) == 32);
  CHECK(Rounded(third.fitness, 0) == 46);
  CHECK(third.best == lucky.controllers[0].genes);
  Says(lesson, "of 4,000 only 97 set a record");
  CHECK(third.curve.size() == 97);
  Says(lesson, "Seed 6, our dreadful horse, set more records, 146 of them. But most were tiny");
  const Outcome& sixth = climbed[5].outcome;
  CHECK(sixth.best == stuck.controllers[0].genes);
  CHECK(sixth.curve.size() == 146);
  int tiny = 0;
  for (std::size_t i = 1; i < sixth.curve.size(); ++i)
    tiny += sixth.curve[i].best - sixth.curve[i - 1].best < 0.02f ? 1 : 0;
  CHECK(2 * tiny > static_cast<int>(sixth.curve.size()));
  Says(lesson, "Mere guessing finds 10.8 m with the same seed, more than twice as much.");
  CHECK(Rounded(FindWith(stuck, Algorithm::kRandomSearch, 6, 4000).outcome.fitness, 1) == 10.8);
  // docs/lesson-answers.md: "with seed 3 the climber gets 46 m, and 4,000 guesses get 23 m"
  CHECK(Rounded(FindWith(stuck, Algorithm::kRandomSearch, 3, 4000).outcome.fitness, 0) == 23);
  Says(lesson, "Of the seeds 1 to 8, three climb past 30 m.");
  CHECK(std::ranges::count_if(climbed, [&](const Found& one) { return Reaches(goal, one.document); }) == 3);
  CHECK(Reaches(goal, climbed[2].document));
  Says(lesson, "gets 8,000 more tries, 12,000 in all.");
  Says(lesson, "It gets 9.4 m.");
  CHECK(Rounded(FindWith(stuck, Algorithm::kShc, 6, 12000).outcome.fitness, 1) == 9.4);
}

TEST_CASE("lessons: style", "[lessons]") {
  const Lesson lesson = LessonOf("4-style");
  const std::string& goal = lesson.fields.at("goal");
  const Document plain = Shipped("lessons/4-no-style");
  CHECK(plain.search.evaluations == 6000);  // "the same 6,000 tries each"
  CHECK(plain.search.seed == 1);
  Says(lesson, "Mr. Star-Man gets 6.8 m in 10 s");
  CHECK(Rounded(std::abs(TermsOf(plain).travel_m), 1) == 6.8);
  const auto usual = UsualWeights(plain);
  // In tenths of the usual weight, like the slider.
  const auto wished = [&](StyleTerm term, int tenths) {
    Document document = plain;
    const auto index = static_cast<std::size_t>(term);
    document.task.weights[index] = static_cast<float>(tenths * 0.1 * static_cast<double>(usual[index]));
    return FindWith(document, Algorithm::kSphc, 1, 6000).document;
  };
  struct Row {
    const char* says;
    const char* file;
    Document found;
    double way, slip, turns, height;
  };
  const std::vector<Row> rows = {{"| none | 6.8 m | 9.0 m | 0.3 | 1.03 m |", "4-no-style",
                                  FindWith(plain, Algorithm::kSphc, 1, 6000).document, 6.8, 9.0, 0.3, 1.03},
                                 {"| slip | 5.1 m | 25.9 m | 0.0 | 0.99 m |", "4-shuffle",
                                  wished(StyleTerm::kSlipSum, 10), 5.1, 25.9, 0.0, 0.99},
                                 {"| rotations | 7.5 m | 2.6 m | 3.2 | 1.00 m |", "4-cartwheel",
                                  wished(StyleTerm::kRotations, 10), 7.5, 2.6, 3.2, 1.00},
                                 {"| height | 4.2 m | 4.3 m | 0.2 | 1.25 m |", "4-hop",
                                  wished(StyleTerm::kMaxCmHeight, 10), 4.2, 4.3, 0.2, 1.25}};
  for (const Row& row : rows) {
    Says(lesson, row.says);
    const Terms terms = TermsOf(row.found);
    CHECK(Rounded(std::abs(terms.travel_m), 1) == row.way);
    CHECK(Rounded(terms.slip_sum_m, 1) == row.slip);
    CHECK(Rounded(terms.rotations, 1) == row.turns);
    CHECK(Rounded(terms.max_cm_height_m, 2) == row.height);
    CHECK(HashText(Simulate(row.found).Hash()) ==
          HashText(Shipped(std::string("lessons/") + row.file).hash.value()));
  }
  CHECK(Reaches(goal, rows[2].found));
  Says(lesson, "The first is a **shuffle**, on feet that hardly ever leave the ground.");
  const Motion shuffle = Simulate(rows[1].found);
  int flights = 0;
  for (int frame = 1; frame <= 1000; ++frame) flights += InFlight(shuffle, frame) ? 1 : 0;
  CHECK(flights < 50);
  Says(lesson, "The second is a **cartwheel**");
  CHECK(LongestFlight(Simulate(rows[2].found), 1, 1000) == 0);
  Says(lesson, "The third rears up and hops, once.");
  const int flight = LongestFlight(Simulate(rows[3].found), 1, 1000);
  CHECK(flight >= 20);
  CHECK(flight <= 30);
  Says(lesson, "He rubs more than ever, but where does he go?");
  const Terms rubbed = TermsOf(wished(StyleTerm::kSlipSum, 30));
  // docs/lesson-answers.md: "With the slider at 3 he slips 32 m and gets less than 3 m"
  CHECK(Rounded(rubbed.slip_sum_m, 0) == 32);
  CHECK(std::abs(rubbed.travel_m) < 3.0f);
}

TEST_CASE("lessons: which search wins", "[lessons]") {
  const Lesson lesson = LessonOf("5-which-search-wins");
  const std::string& goal = lesson.fields.at("goal");
  const Document stuck = Shipped("lessons/5-stuck-hopper"), other = Shipped("lessons/5-population-hopper");
  Says(lesson,
       "This hopper has three rods and one wish: to jump. After 5,000 tries it rises by 0.4 m, and falls on "
       "its face.");
  CHECK(stuck.figure.Rods() == 3);
  const Motion motion = Simulate(stuck);
  const Terms terms = TermsOf(stuck);
  CHECK(Rounded(terms.max_cm_height_m - terms.start_height_m, 1) == 0.4);
  Says(lesson, "counts from where its centre of mass starts, 1 m above the ground");
  Says(lesson, "It starts at 1 m, so it has to rise by 3 m.");
  CHECK(Rounded(terms.start_height_m, 1) == 1.0);
  CHECK(ToppledAt(motion) < 1.0);
  Says(lesson, "found with just as many tries and the same seed, and it rises by 3.8 m");
  CHECK(other.search.evaluations == stuck.search.evaluations);
  CHECK(other.search.seed == stuck.search.seed);
  CHECK(Rounded(TermsOf(other).max_cm_height_m - TermsOf(other).start_height_m, 1) == 3.8);
  Says(lesson, "ten climbers, each from a start of its own. Every 200 rounds");
  CHECK(other.search.population == 10);
  CHECK(other.search.reseed_interval == 200);

  const auto jumps = [&](Algorithm algorithm, const std::string& row, const std::vector<double>& told) {
    Says(lesson, row);
    std::vector<float> found;
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      const Found one = FindWith(stuck, algorithm, seed, 5000);
      found.push_back(one.outcome.fitness);
      CHECK(Rounded(one.outcome.fitness, 1) == told[seed - 1]);
      if (algorithm == Algorithm::kSphc) CHECK(Reaches(goal, one.document));
      if (algorithm == Algorithm::kRandomSearch) CHECK_FALSE(Reaches(goal, one.document));
    }
    std::ranges::sort(found);
    return found;
  };
  jumps(Algorithm::kRandomSearch, "| guessing | 0.3 m | 0.4 m | 0.6 m | 0.6 m | 1.2 m |",
        {0.3, 0.4, 0.6, 0.6, 1.2});
  const auto single = jumps(Algorithm::kShc, "| one climber | 5.8 m | 5.4 m | 4.6 m | 0.4 m | 0.4 m |",
                            {5.8, 5.4, 4.6, 0.4, 0.4});
  const auto population = jumps(Algorithm::kSphc, "| population | 4.4 m | 3.8 m | 3.9 m | 3.8 m | 4.3 m |",
                                {4.4, 3.8, 3.9, 3.8, 4.3});
  Says(lesson, "The three best jumps belong to the single climber.");
  CHECK(single[2] > population[4]);

  // The study of docs/search.md: "with twenty seeds: the median of the population is 5.8 m, and that of
  // the single climber 5.4 m; but a quarter of the single climbers get no more than 1.6 m."
  Says(lesson,
       "the median of the population is 5.8 m, and that of the single climber 5.4 m; but a quarter of "
       "the single climbers get no more than 1.6 m.");
  std::istringstream study(ReadFile("docs/studies/searches/hopper-jump-physical.csv"));
  std::map<std::string, std::vector<float>> best;
  for (std::string line; std::getline(study, line);) {
    std::istringstream cells(line);
    std::string problem, search, seed, evaluations, score;
    for (std::string* cell : {&problem, &search, &seed, &evaluations, &score})
      std::getline(cells, *cell, ',');
    if (problem == "hopper-jump") best[search].push_back(std::stof(score));
  }
  for (auto& [search, scores] : best) std::ranges::sort(scores);
  REQUIRE(best["sphc"].size() == 20);
  CHECK(Rounded(0.5f * (best["sphc"][9] + best["sphc"][10]), 1) == 5.8);
  CHECK(Rounded(0.5f * (best["shc"][9] + best["shc"][10]), 1) == 5.4);
  CHECK(best["shc"][4] <= 1.6f);
}

}  // namespace gaitsmith::test
