// SPDX-License-Identifier: MIT
// The queue, found motions and the samples of a population's spread, as plain data.
#include "shell/results/search_queue.h"

#include <catch_amalgamated.hpp>
#include <map>
#include <sstream>

#include "core/document/binary.h"
#include "core/document/link.h"
#include "core/rollout/evaluator.h"
#include "shell/results/found_motions.h"
#include "shell/results/spread_curve.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

Document Problem(std::uint32_t seed = 1) {
  Document document;
  document.title = "A title of its own";
  document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  document.task.duration_steps = 60;
  document.search.seed = seed;
  return document;
}

Genome Genes(const Document& document, Gene gene) {
  return Genome(ProblemOf(document).Shape().Genes(), gene);
}

FoundMotion Found(std::uint32_t seed, double when_s, Gene gene = 20000) {
  const Document problem = Problem(seed);
  FoundMotion found = Measured(FoundDocument(problem, Genes(problem, gene)), Origin::kDone, 100);
  found.when_s = when_s;
  return found;
}

std::vector<std::uint32_t> Seeds(const SearchQueue& queue) {
  std::vector<std::uint32_t> seeds;
  for (const SearchQueue::Entry& entry : queue.Waiting()) seeds.push_back(entry.document.search.seed);
  return seeds;
}

std::vector<std::uint32_t> Seeds(const FoundMotions& found, FoundMotions::Order order) {
  std::vector<std::uint32_t> seeds;
  for (const FoundMotions::Entry* entry : found.Sorted(order))
    seeds.push_back(entry->motion.document.search.seed);
  return seeds;
}

using List = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("queue: order, move up, remove, clear and restore", "[shell][queue]") {
  SearchQueue queue;
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) REQUIRE(queue.Add(Problem(seed)));
  const auto number = [&](std::size_t place) { return queue.Waiting()[place].number; };
  queue.MoveUp(number(2));
  CHECK(Seeds(queue) == List{1, 3, 2, 4});
  queue.MoveUp(number(0));
  CHECK(Seeds(queue) == List{1, 3, 2, 4});
  queue.Remove(number(1));
  CHECK(Seeds(queue) == List{1, 2, 4});
  queue.BringBack();
  CHECK(Seeds(queue) == List{1, 3, 2, 4});
  CHECK(queue.Removed() == 0);
  queue.BringBack();
  CHECK(Seeds(queue) == List{1, 3, 2, 4});
  queue.Clear();
  CHECK(queue.Waiting().empty());
  CHECK(queue.Removed() == 4);
  queue.BringBack();
  CHECK(Seeds(queue) == List{1, 3, 2, 4});
  CHECK(queue.TakeFirst()->search.seed == 1);
  CHECK(Seeds(queue) == List{3, 2, 4});
  queue.Remove(4711);
  CHECK(queue.Waiting().size() == 3);
}

TEST_CASE("queue: bounded, also for restored searches", "[shell][queue]") {
  SearchQueue queue;
  for (std::size_t i = 0; i < SearchQueue::kMax; ++i) REQUIRE(queue.Add(Problem()));
  CHECK(queue.Full());
  CHECK_FALSE(queue.Add(Problem()));
  queue.Clear();
  CHECK(queue.Removed() == SearchQueue::kMax);
  REQUIRE(queue.Add(Problem(9)));
  queue.BringBack();  // no effect after Add
  CHECK(queue.Waiting().size() == 1);
}

TEST_CASE("queue: an entry holds exactly what its search depends on", "[shell][queue]") {
  Document document = Problem(5);
  document.environment.friction = 0.25f;
  document.search.algorithm = Algorithm::kShc;
  const Document before = document;
  const Genome genes = Genes(document, 30000);
  document.controllers = {{"first", document.kind, document.senses, document.rules, Genes(document, 10)},
                          {"second", document.kind, document.senses, document.rules, genes}};
  document.timeline = {{1, 0}};
  document.view.panel = 3;
  CHECK(SameSearch(document, before));
  document.search.start = 1;
  CHECK_FALSE(SameSearch(document, before));
  const Document search = SearchOf(document);
  REQUIRE(Validate(search));
  CHECK(SpaceOf(search).start == genes);
  CHECK(search.controllers.size() == 1);
  CHECK(search.environment.friction == 0.25f);
  document.controllers[0].genes[0] = 77;
  CHECK(SameSearch(document, search));
  document.controllers[1].genes[0] = 77;
  CHECK_FALSE(SameSearch(document, search));
  CHECK_FALSE(SameSearch(Problem(1), Problem(2)));
}

TEST_CASE("queue: further seeds skip those of the same search that run or wait", "[shell][queue]") {
  Document other = Problem(8);
  other.task.kind = TaskKind::kJump;
  const std::vector<Document> others = {Problem(7), Problem(9), other};
  CHECK(FreeSeeds(Problem(7), others, 3) == List{8, 10, 11});
  CHECK(FreeSeeds(Problem(1), {}, 5) == List{1, 2, 3, 4, 5});
  CHECK(FreeSeeds(Problem(0xfffffffeu), {}, 5) == List{0xfffffffeu, 0xffffffffu});
}

TEST_CASE("found motions: sorted by time or score, and finding a motion again keeps one entry",
          "[shell][found]") {
  FoundMotions found;
  CHECK(found.Best(Problem()) == nullptr);
  const FoundMotion first = Found(1, 100.0, 1000);
  const FoundMotion second = Found(2, 200.0, 52000);
  REQUIRE(first.Score() != second.Score());
  const std::uint32_t better = first.Score() > second.Score() ? 1 : 2;
  const std::string id = found.Add(first);
  found.Add(second);
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{2, 1});
  CHECK(Seeds(found, FoundMotions::Order::kBest) == List{better, 3 - better});
  CHECK(found.Best(Problem())->motion.document.search.seed == better);
  REQUIRE(found.Keep(id, true));
  FoundMotion again = first;
  again.when_s = 300.0;
  CHECK(found.Add(again) == id);
  CHECK(found.Count() == 2);
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{1, 2});
  CHECK(found.Find(id)->motion.kept);
  // New entries stay newest when the clock is set back.
  found.Add(Found(3, 50.0));
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{3, 1, 2});
}

TEST_CASE("found motions: the best of this figure and task comes before a better one of another",
          "[shell][found]") {
  FoundMotions found;
  const FoundMotion mine = Found(1, 1.0, 1000);
  FoundMotion foreign = Found(2, 2.0, 52000);
  foreign.document.figure.name = "Somebody else";
  foreign.terms.travel_m = 1000.0f;
  found.Add(mine);
  found.Add(foreign);
  CHECK(found.Best(Problem())->motion.document.search.seed == 1);
  Document jump = Problem();
  jump.task.kind = TaskKind::kJump;
  CHECK(found.Best(jump)->motion.document.search.seed == 2);
}

TEST_CASE("found motions: the oldest unsaved entries are removed first, by number and by size",
          "[shell][found]") {
  const std::size_t one = EncodeFound(Found(1, 1.0)).size();
  const bool by_size = GENERATE(false, true);
  CAPTURE(by_size);
  FoundMotions found(by_size ? FoundMotions::Limits{.motions = 100, .bytes = 3 * one + one / 2}
                             : FoundMotions::Limits{.motions = 3, .bytes = 1'000'000});
  std::map<std::string, std::string> stored;
  found.on_change = [&](const std::string& id, const std::string& text) {
    if (text.empty()) {
      stored.erase(id);
    } else {
      stored[id] = text;
    }
  };
  found.Keep(found.Add(Found(1, 1.0)), true);
  for (const std::uint32_t seed : {2u, 3u, 4u, 5u}) CHECK_FALSE(found.Add(Found(seed, seed)).empty());
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{5, 4, 1});
  CHECK(stored.size() == 3);
  for (const FoundMotions::Entry* entry : found.Sorted(FoundMotions::Order::kNewest))
    CHECK(found.Keep(entry->id, true));
  CHECK(found.Add(Found(6, 6.0)).empty());
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{5, 4, 1});
  CHECK(stored.size() == 3);
}

TEST_CASE("found motions: a removed entry can be restored to its place, once", "[shell][found]") {
  FoundMotions found;
  found.Add(Found(1, 1.0));
  const std::string id = found.Add(Found(2, 2.0));
  found.Add(Found(3, 3.0));
  std::string stored;
  found.on_change = [&](const std::string& changed, const std::string& text) {
    CHECK(changed == id);
    stored = text;
  };
  stored = "there";
  found.Remove(id);
  CHECK(stored.empty());
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{3, 1});
  REQUIRE(found.Removed() != nullptr);
  CHECK(found.BringBack());
  CHECK_FALSE(stored.empty());
  CHECK(Seeds(found, FoundMotions::Order::kNewest) == List{3, 2, 1});
  CHECK(found.Removed() == nullptr);
  CHECK_FALSE(found.BringBack());
}

TEST_CASE("found motions: encoding as text and decoding restore bits and order", "[shell][found]") {
  FoundMotion found = Found(4, 1763761234.567);
  found.origin = Origin::kStopped;
  found.kept = true;
  const std::string text = EncodeFound(found);
  const auto back = DecodeFound(text);
  REQUIRE(back);
  CHECK(EncodeBinary(back->document) == EncodeBinary(found.document));
  CHECK(EncodeFound(*back) == text);
  CHECK(back->Score() == found.Score());
  CHECK(back->terms.max_cm_height_m == found.terms.max_cm_height_m);
  CHECK(back->when_s == found.when_s);
  CHECK(back->origin == Origin::kStopped);

  FoundMotions list;
  bool told = false;
  list.on_change = [&](const std::string&, const std::string&) { told = true; };
  for (const std::uint32_t seed : {3u, 1u, 2u})
    CHECK_FALSE(list.Restore(EncodeFound(Found(seed, seed))).empty());
  CHECK_FALSE(told);
  CHECK(Seeds(list, FoundMotions::Order::kNewest) == List{3, 2, 1});
  CHECK_FALSE(list.Restore(EncodeFound(Found(1, 1.0))).empty());
  CHECK(list.Count() == 3);
  for (const std::string& bad : {std::string("no JSON"), std::string("{}"), text.substr(0, text.size() / 2),
                                 std::string(text).replace(text.find("\"link\":\"") + 12, 4, "AAAA"),
                                 std::string(text).replace(text.find("stopped"), 7, "begun"),
                                 std::string(text).replace(text.find("\"terms\":["), 9, "\"terms\":[1,")}) {
    CAPTURE(bad);
    CHECK(list.Restore(bad).empty());
  }
}

// They pin the text that version 0.1.0 keeps in browsers. No line is ever changed or taken away.
TEST_CASE("found motions: results kept by version 0.1.0 open", "[shell][found]") {
  std::istringstream lines(gaitsmith::test::ReadFile("tests/golden/kept_results.txt"));
  int kept = 0;
  for (std::string text; std::getline(lines, text); ++kept) {
    const auto found = DecodeFound(text);
    REQUIRE(found);
    CHECK(found->kept);
    CHECK(found->name == "Shuffle");
    CHECK(found->evaluations == 1);
    CHECK(found->document.controllers.size() == 1);
    CHECK(EncodeFound(*found) == text);
  }
  CHECK(kept == 2);
}

TEST_CASE("found motions: texts from before the last terms are read, and the terms measured",
          "[shell][found]") {
  const Document problem = Problem(3);
  const FoundMotion found = Measured(FoundDocument(problem, Genes(problem, 41000)), Origin::kDone, 1);
  REQUIRE(found.terms.effort_rad > 0.0f);
  const std::string text = EncodeFound(found);
  const std::size_t first = text.find("\"terms\":[") + 9;
  for (std::size_t left = kFreeTerms + 1; left >= 5; --left) {
    CAPTURE(left);
    std::size_t end = first;
    for (std::size_t number = 0; number < left; ++number) end = text.find(',', end + 1);
    const auto back = DecodeFound(text.substr(0, end) + "]}");
    REQUIRE(back);
    CHECK(EncodeFound(*back) == text);
  }
  std::size_t end = first;
  for (std::size_t number = 0; number < 4; ++number) end = text.find(',', end + 1);
  CHECK_FALSE(DecodeFound(text.substr(0, end) + "]}"));
}

TEST_CASE("found motions: a motion that broke physics has no score, but can be encoded", "[shell][found]") {
  FoundMotion found = Found(1, 1.0);
  found.terms.broke_physics = true;
  found.terms.travel_m = std::numeric_limits<float>::quiet_NaN();
  const auto back = DecodeFound(EncodeFound(found));
  REQUIRE(back);
  CHECK(back->Score() == kVoidScore);
}

TEST_CASE("found motions: a found document has the score and the hash that its search reported",
          "[shell][found]") {
  const Document problem = Problem(3);
  const Genome genes = Genes(problem, 41000);
  const FoundMotion found = Measured(FoundDocument(problem, genes), Origin::kDone, 1);
  REQUIRE(Validate(found.document));
  Evaluator evaluator(ProblemOf(problem));
  const std::vector<Genome> one = {genes};
  CHECK(found.Score() == evaluator.Evaluate(one).front().fitness);
  CHECK(SameSearch(found.document, problem));
  CHECK(found.document.title == "Mr. Star-Man · travel, 10 rules with physical senses, seed 3");
  CHECK(DecodeLink(EncodeLink(found.document))->hash == found.document.hash);
}

TEST_CASE("spread curve: samples keep a distance, and the newest is always present", "[shell][spread]") {
  SpreadCurve curve;
  curve.Begin(10'000);
  for (int i = 1; i <= 10'000; ++i) {
    const auto value = static_cast<float>(i);
    curve.Add(i, {2, value, value, value, value, value});
    REQUIRE(curve.Points().back().evaluation == i);
  }
  CHECK(curve.Points().size() <= SpreadCurve::kMaxPoints + 2);
  CHECK(curve.Points().size() >= SpreadCurve::kMaxPoints - 2);
  for (std::size_t i = 1; i + 1 < curve.Points().size(); ++i)
    CHECK(curve.Points()[i].evaluation - curve.Points()[i - 1].evaluation >=
          10'000 / SpreadCurve::kMaxPoints);
}

TEST_CASE("spread curve: after a return to a checkpoint, samples are replaced", "[shell][spread]") {
  SpreadCurve curve;
  curve.Begin(1000);
  for (const int evaluation : {100, 200, 300}) curve.Add(evaluation, {2, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f});
  curve.Add(200, {2, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f});
  REQUIRE(curve.Points().size() == 2);
  CHECK(curve.Points().back().spread.median == 5.0f);
  curve.Begin(10);
  CHECK(curve.Points().empty());
}

}  // namespace gaitsmith::shell::test
