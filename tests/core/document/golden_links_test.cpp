// SPDX-License-Identifier: MIT
// Pins: the links of tests/golden/links, one file for each version of the binary form. Each link opens, shows
// the same motion as always, and is encoded again with exactly the same characters, both directly and through
// JSON. Does not pin: which documents a version can hold (document_test.cpp). To bless again: never, because
// shared links cannot be recalled. Lines may be added to the newest version's file:
//   gaitsmith hash DOC && gaitsmith link encode DOC
// Has caught: nothing yet.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/json.h"
#include "core/document/link.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

struct GoldenLink {
  std::string name;  // the comment line before it
  std::string hash, payload;
};

/// The links of a file. Each line has a hash and a payload, after a comment line with the name.
std::vector<GoldenLink> LinksOf(int version) {
  std::istringstream file(ReadFile("tests/golden/links/version-" + std::to_string(version) + ".txt"));
  std::vector<GoldenLink> links;
  std::string line, name;
  while (std::getline(file, line)) {
    if (line.starts_with("#")) {
      name = line;
    } else if (!line.empty()) {
      CAPTURE(line);
      REQUIRE(line.find(' ') == 16);
      REQUIRE_FALSE(name.empty());
      links.push_back({name, line.substr(0, 16), line.substr(17)});
      name.clear();
    }
  }
  return links;
}

/// The first byte of a payload, read without the decoder under test.
int VersionOf(const std::string& payload) {
  return static_cast<int>((kAlphabet.find(payload.at(0)) << 2u) | (kAlphabet.find(payload.at(1)) >> 4u));
}

void CheckLinks(int version, std::size_t least) {
  const auto links = LinksOf(version);
  REQUIRE(links.size() >= least);
  for (const GoldenLink& link : links) {
    CAPTURE(link.name);
    CHECK(VersionOf(link.payload) == version);
    const auto document = DecodeLink(link.payload);
    REQUIRE(document);
    REQUIRE(document->hash);
    CHECK(HashText(*document->hash) == link.hash);
    CHECK(HashText(Simulate(*document).Hash()) == link.hash);
    CHECK(EncodeLink(*document) == link.payload);
    const auto from_json = DecodeJson(EncodeJson(*document));
    REQUIRE(from_json);
    CHECK(EncodeLink(*from_json) == link.payload);
  }
}

void CheckDamage(int version) {
#if defined(__GNUC__) && !defined(__clang__)
  constexpr std::size_t kStep = 1;
#else
  constexpr std::size_t kStep = 7;  // with sanitizers and as WASM every 7th character: all would take minutes
#endif
  for (const GoldenLink& link : LinksOf(version)) {
    CAPTURE(link.name);
    int opened = 0;
    for (std::size_t at = 0; at < link.payload.size(); at += kStep) {
      opened += DecodeLink(std::string_view(link.payload).substr(0, at)) ? 1 : 0;
      std::string changed = link.payload;
      for (int byte = 0; byte < 256; ++byte) {
        changed[at] = static_cast<char>(byte);
        if (changed[at] != link.payload[at]) opened += DecodeLink(changed) ? 1 : 0;
      }
    }
    REQUIRE(opened == 0);
  }
}

}  // namespace

TEST_CASE("golden links: every link of version 1 opens with its motion", "[golden][links]") {
  CheckLinks(1, 12);
}

TEST_CASE("golden links: every link of version 2 opens with its motion", "[golden][links]") {
  CheckLinks(2, 10);
}

TEST_CASE("golden links: every link of version 3 opens with its motion", "[golden][links]") {
  CheckLinks(3, 3);
}

TEST_CASE("golden links: every link of version 4 opens with its motion", "[golden][links]") {
  CheckLinks(4, 3);
}

TEST_CASE("golden links: every link of version 5 opens with its motion", "[golden][links]") {
  CheckLinks(5, 2);
}

TEST_CASE("golden links: every link of version 6 opens with its motion", "[golden][links]") {
  CheckLinks(6, 1);
}

TEST_CASE("golden links: every link of version 7 opens with its motion", "[golden][links]") {
  CheckLinks(7, 3);
}

TEST_CASE("golden links: every link of version 8 opens with its motion", "[golden][links]") {
  CheckLinks(8, 1);
}

TEST_CASE("golden links: every link of version 9 opens with its motion", "[golden][links]") {
  CheckLinks(9, 1);
}

TEST_CASE("golden links: every link of version 10 opens with its motion", "[golden][links]") {
  CheckLinks(10, 2);
}

TEST_CASE("golden links: every link of version 11 opens with its motion", "[golden][links]") {
  CheckLinks(11, 1);
}

TEST_CASE("golden links: every link of version 12 opens with its motion", "[golden][links]") {
  CheckLinks(12, 1);
}

TEST_CASE("golden links: every link of version 13 opens with its motion", "[golden][links]") {
  CheckLinks(13, 1);
}

TEST_CASE("golden links: every link of version 14 opens with its motion", "[golden][links]") {
  CheckLinks(14, 3);
}

// Separate cases, which run side by side: this is the longest test.
TEST_CASE("golden links: no link of version 1 that was changed in one byte or cut short opens",
          "[golden][links][exhaustive]") {
  CheckDamage(1);
}

TEST_CASE("golden links: no link of version 2 that was changed in one byte or cut short opens",
          "[golden][links][exhaustive]") {
  CheckDamage(2);
}

TEST_CASE("golden links: no link of version 3 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(3);
}

TEST_CASE("golden links: no link of version 4 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(4);
}

TEST_CASE("golden links: no link of version 5 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(5);
}

TEST_CASE("golden links: no link of version 6 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(6);
}

TEST_CASE("golden links: no link of version 7 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(7);
}

TEST_CASE("golden links: no link of version 8 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(8);
}

TEST_CASE("golden links: no link of version 9 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(9);
}

TEST_CASE("golden links: no link of version 10 opens after it was damaged in one character or cut off",
          "[golden][links]") {
  CheckDamage(10);
}

TEST_CASE("golden links: no link of version 11 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(11);
}

TEST_CASE("golden links: no link of version 12 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(12);
}

TEST_CASE("golden links: no link of version 13 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(13);
}

TEST_CASE("golden links: no link of version 14 that was changed in one byte or cut short opens",
          "[golden][links]") {
  CheckDamage(14);
}

}  // namespace gaitsmith::test
