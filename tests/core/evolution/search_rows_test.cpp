// SPDX-License-Identifier: MIT
// Rows of docs/studies/peers/searches.csv, in which our searches stand beside another library's, come out
// again as they were written. Only of functions that need no library's sine or power, whose last bit may
// differ.
#include <catch_amalgamated.hpp>
#include <cstdio>
#include <fstream>

#include "tests/peers/search_trials.h"

namespace gaitsmith::test {

TEST_CASE("searches beside another library's: rows come out as they were written", "[search][peers]") {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/docs/studies/peers/searches.csv");
  std::string line, all;
  while (std::getline(file, line)) all += line + "\n";
  REQUIRE(all.starts_with("search,function,numbers,"));
  int compared = 0;
  for (const SearchRow& row : kSearchRows) {
    if (row.function != "sphere" && row.function != "zdt1") continue;
    std::vector<double> reached;
    for (std::uint32_t seed = 1; seed <= kSearchTrials; ++seed) reached.push_back(row.Reached(seed));
    std::ranges::sort(reached);
    char text[200];
    std::snprintf(text, sizeof text, "\n%s,%s,%d,%d,%d,%d,%.9g,", std::string(row.search).c_str(),
                  std::string(row.function).c_str(), row.numbers, row.population,
                  (row.generations + 1) * row.population, kSearchTrials, reached[kSearchTrials / 2]);
    CAPTURE(std::string(text));
    CHECK(all.find(text) != std::string::npos);
    ++compared;
  }
  CHECK(compared == 3);
}

}  // namespace gaitsmith::test
