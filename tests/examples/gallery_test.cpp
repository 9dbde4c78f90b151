// SPDX-License-Identifier: MIT
// docs/gallery.md and examples/gallery contain the same motions: of many figures, each with a different
// title, with its hash and with visible movement.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

struct Entry {
  std::string title, path;
};

/// The entries of docs/gallery.md. Each has four lines: heading, film strip, empty line, what to look for.
std::vector<Entry> EntriesOfBook() {
  std::istringstream book(ReadFile("docs/gallery.md"));
  std::vector<Entry> entries;
  std::string line;
  REQUIRE(std::getline(book, line));
  REQUIRE(line == "# Gallery");
  while (std::getline(book, line)) {
    if (!line.starts_with("### ")) continue;
    CAPTURE(line);
    const std::size_t middle = line.find("](../"), end = line.size() - 1;
    REQUIRE(line.starts_with("### ["));
    REQUIRE(middle != std::string::npos);
    REQUIRE(line.ends_with(".json)"));
    entries.push_back({line.substr(5, middle - 5), line.substr(middle + 5, end - middle - 5)});
    const std::string picture = line.substr(middle);
    REQUIRE(std::getline(book, line));
    CHECK(line.starts_with("![Film strip: "));
    CHECK(line.ends_with(picture));
    REQUIRE(std::getline(book, line));
    CHECK(line.empty());
    REQUIRE(std::getline(book, line));
    CHECK(line.size() > 40);
    CHECK_FALSE(line.starts_with("#"));
  }
  return entries;
}

}  // namespace

TEST_CASE("gallery: the book and the folder hold the same motions", "[gallery]") {
  std::vector<std::string> told;
  for (const Entry& entry : EntriesOfBook()) {
    CAPTURE(entry.path);
    told.push_back(entry.path);
    const auto document = DecodeJson(ReadFile(entry.path));
    REQUIRE(document);
    CHECK(document->title == entry.title);
  }
  std::ranges::sort(told);
  CHECK(told == GalleryDocuments());
  CHECK(told.size() >= 24);
}

TEST_CASE("gallery: many figures, titles that differ, a hash and a motion in each", "[gallery]") {
  std::set<std::string> figures, titles;
  for (const std::string& name : GalleryDocuments()) {
    CAPTURE(name);
    const auto document = DecodeJson(ReadFile(name));
    REQUIRE(document);
    figures.insert(document->figure.name);
    CHECK(titles.insert(document->title).second);
    CHECK(document->title.size() <= 40);
    CHECK_FALSE(document->title.empty());
    CHECK(document->hash);
    CHECK(document->duration_steps >= 500);
    CHECK(document->duration_steps <= 1200);

    const Motion motion = Simulate(*document);
    const int end = document->duration_steps, last_second = end - 100;
    double way_m = 0.0, bent_rad = 0.0;
    for (int frame = 1; frame <= end; ++frame) {
      way_m = std::max(way_m, std::abs(motion.At(frame).x_m - motion.At(0).x_m));
      if (frame <= last_second) continue;
      for (int joint = 0; joint < motion.Connections().Actuators(); ++joint) {
        bent_rad += std::abs(static_cast<double>(motion.AngleRad(frame, joint)) -
                             static_cast<double>(motion.AngleRad(frame - 1, joint)));
      }
    }
    CHECK(way_m > 2.0);
    // The figure is not at rest: it still bends or rolls.
    CHECK((bent_rad > 0.5 || std::abs(motion.At(end).x_m - motion.At(last_second).x_m) > 1.0));
  }
  CHECK(figures.size() >= 12);
}

}  // namespace gaitsmith::test
