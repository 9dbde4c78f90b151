// SPDX-License-Identifier: MIT
// Decoding of search progress from the page: valid records, and errors that name the wrong field.
#include "shell/results/progress_record.h"

#include <catch_amalgamated.hpp>
#include <cstring>

#include "core/document/spread_json.h"

namespace gaitsmith::shell::test {
namespace {

template <class Item>
void Append(std::vector<std::uint8_t>& bytes, const std::vector<Item>& items) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(items.data());
  bytes.insert(bytes.end(), first, first + items.size() * sizeof(Item));
}

std::string Record(const std::string& evaluations, const std::string& spread, std::size_t curve,
                   std::size_t genome, std::size_t saved, std::size_t attempt = 0) {
  return R"({"state":"paused","evaluations":)" + evaluations +
         R"(,"budget":100000000,"rate":812.5,"secondsLeft":3.25,"bestFitness":-0.75,"spread":)" + spread +
         R"(,"curveBytes":)" + std::to_string(curve) + R"(,"genomeBytes":)" + std::to_string(genome) +
         R"(,"savedBytes":)" + std::to_string(saved) + R"(,"attemptBytes":)" + std::to_string(attempt) + "}";
}

}  // namespace

TEST_CASE("progress record: every number is decoded, evaluations beyond 2^24 exactly", "[shell][search]") {
  const Spread spread{.members = 7,
                      .least = -1.5f,
                      .lower_quartile = 0.1f,
                      .median = 0.25f,
                      .upper_quartile = 2.0f,
                      .best = 33.3f};
  const std::vector<Search::CurvePoint> curve = {{16'777'217, 1.25f}, {99'999'999, 4.5f}};
  const Genome genome = {0, 1, 65535};
  const std::vector<std::uint8_t> saved = {9, 8, 7};
  std::vector<std::uint8_t> bytes;
  Append(bytes, curve);
  Append(bytes, genome);
  Append(bytes, saved);
  const Genome attempt = {5, 6};
  Append(bytes, attempt);
  const auto progress = DecodeProgress(Record("99999999", SpreadJson(spread), 16, 6, 3, 4), bytes);
  REQUIRE(progress);
  CHECK(progress->state == SearchState::kPaused);
  CHECK(progress->evaluations == 99'999'999);
  CHECK(progress->budget == 100'000'000);
  CHECK(progress->evaluations_per_second == 812.5);
  CHECK(progress->seconds_left == 3.25);
  CHECK(progress->best_fitness == -0.75f);
  REQUIRE(progress->curve.size() == 2);
  CHECK(progress->curve[0].evaluation == 16'777'217);
  CHECK(progress->curve[1].evaluation == 99'999'999);
  CHECK(progress->curve[1].best == 4.5f);
  CHECK(progress->best_genome == genome);
  CHECK(progress->saved == saved);
  CHECK(progress->attempt == attempt);
  REQUIRE(progress->spread);
  CHECK(progress->spread->members == 7);
  CHECK(progress->spread->least == -1.5f);
  CHECK(progress->spread->lower_quartile == 0.1f);
  CHECK(progress->spread->median == 0.25f);
  CHECK(progress->spread->upper_quartile == 2.0f);
  CHECK(progress->spread->best == 33.3f);
}

TEST_CASE("progress record: an invalid record yields an error that names the field", "[shell][search]") {
  const std::vector<std::uint8_t> bytes(12);
  REQUIRE(DecodeProgress(Record("5", "null", 8, 4, 0), bytes));
  const auto where = [&](const std::string& json) {
    const auto progress = DecodeProgress(json, bytes);
    return progress ? "" : progress.error().where;
  };
  CHECK(where(Record("5.5", "null", 8, 4, 0)) == "evaluations");
  CHECK(where(Record("-1", "null", 8, 4, 0)) == "evaluations");
  CHECK(where(Record("4294967297", "null", 8, 4, 0)) == "evaluations");
  CHECK(where(Record("5", R"({"members":2,"least":1})", 8, 4, 0)) == "spread");
  CHECK(where(Record("5", R"({"members":1})", 8, 4, 0)) == "spread");
  CHECK(where(Record("5", "null", 9, 3, 0)) == "curveBytes");
  CHECK(where(Record("5", "null", 16, 0, 0)) == "curveBytes");
  CHECK(where(Record("5", "null", 8, 3, 1)) == "genomeBytes");
  CHECK(where(Record("5", "null", 8, 2, 3)) == "savedBytes");
  CHECK(where(Record("5", "null", 8, 2, 1)) == "attemptBytes");
  CHECK(where(Record("5", "null", 8, 2, 0, 1)) == "attemptBytes");
  CHECK(where(R"({"state":"asleep"})") == "state");
  CHECK(where("{}") == "state");
  CHECK(where("{") != "");
}

}  // namespace gaitsmith::shell::test
