// SPDX-License-Identifier: MIT
// Rows of docs/studies/peers/searches.csv, in which our searches stand beside another library's, come out
// again as they were written. Only of functions that need no library's sine or power, whose last bit may
// differ.
#include <catch_amalgamated.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/peers/search_trials.h"

namespace gaitsmith::test {

namespace {

/// The rows of the table that the other library was asked for, as texts.
std::vector<std::vector<std::string>> RowsAsWritten() {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/docs/studies/peers/searches.csv");
  std::vector<std::vector<std::string>> rows;
  std::string line, cell;
  while (std::getline(file, line)) {
    std::vector<std::string>& cells = rows.emplace_back();
    for (std::istringstream rest(line); std::getline(rest, cell, ',');) cells.push_back(cell);
  }
  return rows;
}

}  // namespace

TEST_CASE("searches beside another library's: as written, and within its quartiles", "[search][peers]") {
  const std::vector<std::vector<std::string>> written = RowsAsWritten();
  REQUIRE(written.at(0).at(13) == "within");
  int beside = 0;
  for (const SearchRow& row : kSearchRows) {
    if (row.function != "sphere" && row.function != "zdt1") continue;
    std::vector<double> reached;
    for (std::uint32_t seed = 1; seed <= kSearchTrials; ++seed) reached.push_back(row.Reached(seed));
    std::ranges::sort(reached);
    const double ours = reached[kSearchTrials / 2];
    char median[32];
    std::snprintf(median, sizeof median, "%.9g", ours);
    const std::vector<std::string> expected = {std::string(row.search),
                                               std::string(row.function),
                                               std::to_string(row.numbers),
                                               std::to_string(row.population),
                                               std::to_string((row.generations + 1) * row.population),
                                               std::to_string(kSearchTrials),
                                               median};
    for (const std::vector<std::string>& one : written) {
      if (one.at(0) != row.search || one.at(1) != row.function) continue;
      CHECK(std::vector(one.begin(), one.begin() + 7) == expected);
      if (one.at(9) != row.search) continue;  // another algorithm of theirs
      CHECK(std::stod(one.at(11)) <= ours);
      CHECK(ours <= std::stod(one.at(12)));
      CHECK(one.at(13) == "yes");
      ++beside;
    }
  }
  CHECK(beside == 3);
}

}  // namespace gaitsmith::test
