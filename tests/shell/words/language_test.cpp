// SPDX-License-Identifier: MIT
// Translation. tests/web/language.test.mjs checks that the tables are complete.
#include "shell/words/language.h"

#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "shell/words/wording.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {
namespace {

constexpr const char* kSmall = R"({
  "name": "Test", "decimal_mark": ",", "group_mark": ".",
  "words": {"Undo": "Zurück", "{1} of {2}": "von {2} sind {1}", "jump": "Sprung", "at {1} s": "bei {1} s"},
  "errors": {"must be from {1} to {2}, is {3}": "{3} liegt nicht in {1} bis {2}", "{1} is known": "kennt {1}"},
  "titles": {"My figure": "Meine Figur", "seed {1}": "Startwert {1}"}})";

// Restores English at the end of a test.
struct ScopedLanguage {
  explicit ScopedLanguage(std::string_view table) { REQUIRE(SetLanguage(table)); }
  ~ScopedLanguage() { CHECK(SetLanguage("")); }
  ScopedLanguage(const ScopedLanguage&) = delete;
  ScopedLanguage& operator=(const ScopedLanguage&) = delete;
};

std::string German() {
  std::ifstream file(GAITSMITH_SOURCE_DIR "/shell/words/languages/de.json", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// An error in English and in the present language.
std::pair<std::string, std::string> Sentences(const Error& error) {
  return {error.Sentence(), TrError(error)};
}

TEST_CASE("language: English texts are those in the source", "[shell][language]") {
  CHECK(std::string(Tr("Undo")) == "Undo");
  CHECK(Tr("{1} of {2}", 3, "seven") == "3 of seven");
  CHECK(Tr("{1} and {1}, not {3}, {x}", std::string("a")) == "a and a, not {3}, {x}");
  CHECK(TrSentence("must be from 1 to 2, is 3") == "must be from 1 to 2, is 3");
  CHECK(TrTitle("My figure · jump, seed 3") == "My figure · jump, seed 3");
  CHECK(TrError({ErrorCode::kSyntax, "line 1, column 2", "expected a digit"}) ==
        "line 1, column 2: expected a digit");
  CHECK(Fixed(1234.5, 1) == "1234.5");
  CHECK(Grouped(-1234567) == "−1,234,567");
}

TEST_CASE("language: a table replaces words, sentences, titles and marks", "[shell][language]") {
  const ScopedLanguage table(kSmall);
  CHECK(std::string(Tr("Undo")) == "Zurück");
  CHECK(std::string(Tr("Redo")) == "Redo");
  CHECK(Tr("{1} of {2}", 3, 7) == "von 7 sind 3");
  CHECK(Tr("at {1} s", Fixed(0.25, 2)) == "bei 0,25 s");
  CHECK(Tr("{1} of {2}", "{2}", "b") == "von b sind {2}");  // inserted text is not a pattern
  CHECK(TrSentence("must be from -1.5 to 1e-06, is 2E+5") == "2E+5 liegt nicht in -1.5 bis 1e-06");
  CHECK(TrSentence("\"no, 3\" is known") == "kennt \"no, 3\"");
  CHECK(TrSentence("something else") == "something else");
  CHECK(TrTitle("My figure · jump, 10 things, seed 3") == "Meine Figur · Sprung, 10 things, Startwert 3");
  CHECK(TrTitle("jump · jump") == "jump · Sprung");  // the first part is a name
  CHECK(TrTitle("jump, at 0.80 s") == "jump, bei 0,80 s");
  CHECK(TrTitle("").empty());
  CHECK(Fixed(1234.5, 1) == "1234,5");
  CHECK(Fixed(-0.001, 2) == "0,00");
  CHECK(PlainFixed(1234.5, 1) == "1234.5");
  CHECK(Grouped(-1234567) == "−1.234.567");
  REQUIRE(SetLanguage(""));
  CHECK(std::string(Tr("Undo")) == "Undo");
  CHECK(Fixed(0.5, 1) == "0.5");
}

TEST_CASE("language: a wrong table changes nothing", "[shell][language]") {
  const ScopedLanguage table(kSmall);
  for (const char* wrong :
       {"{", "[]", "{}", "3", R"({"decimal_mark": ",", "group_mark": "."})",
        R"({"decimal_mark": 1, "group_mark": ".", "words": {}})",
        R"({"decimal_mark": ",", "group_mark": ".", "words": []})",
        R"({"decimal_mark": ",", "group_mark": ".", "words": {"Undo": 1}})",
        R"({"decimal_mark": ";", "group_mark": ".", "words": {}, "errors": {"a": []}})"}) {
    CAPTURE(wrong);
    CHECK_FALSE(SetLanguage(wrong));
    CHECK(std::string(Tr("Undo")) == "Zurück");
    CHECK(DecimalMark() == ",");
  }
}

TEST_CASE("language: errors of documents are translated to German", "[shell][language]") {
  const ScopedLanguage german(German());
  const std::string rod = R"({"figure": {"rods": [{}, {"parent": 0}]}, )";
  const std::vector<std::string> texts = {
      "{",
      "[1]",
      "3",
      "",
      R"({"title": 3})",
      R"({"title": "a", "title": "b"})",
      R"({"title": "\x"})",
      R"({"title": "\ud800"})",
      R"({"title": "\u00g0"})",
      R"({"rules": 1.5})",
      R"({"rules": 1E5})",
      R"({"rules": 01})",
      R"({"rules": 1e999})",
      R"({"model": 99})",
      R"({"title": "a"} more)",
      R"({"no such thing": 1})",
      R"({"task": {"kind": "fly"}})",
      R"({"search": {"algorithm": "best"}})",
      R"({"figure": {"rods": []}})",
      R"({"figure": {"rods": [{"parent": 0}]}})",
      R"({"figure": {"rods": [{}, {}]}})",
      R"({"figure": {"rods": [{}, {"parent": 2}, {"parent": 1}]}})",
      R"({"figure": {"rods": [{}, {"parent": 9}]}})",
      R"({"figure": {"rods": [{"length_m": -1}]}})",
      R"({"hash": "xyz"})",
      rod + R"("timeline": [{"controller": 3}]})",
      rod + R"("pushes": [{"endpoint": 9}]})",
      rod + R"("pushes": [{"step": 5}, {"step": 4}]})",
      rod + R"("kind": "network", "senses": {"kind": "timer"}})",
      rod + R"("senses": {"tau_min_s": 2, "tau_max_s": 1}})",
      rod + R"("search": {"algorithm": "gga", "evaluations": 3}})",
      rod + R"("search": {"algorithm": "cma-es", "cma": {"population": 3}}})",
      rod + R"("search": {"start": 1}})",
      rod + R"("controllers": [{"rules": []}]})",
      rod + R"("controllers": [{"rules": [{"tau": 0}]}]})",
      rod + R"("controllers": [{"rules": [{"pose": [1, 2], "tau": 0}]}]})",
      rod + R"("controllers": [{"rules": [{"pose": [1.5], "tau": 0}]}]})",
      rod + R"("controllers": [{"rules": [{"pose": [1], "tau": 0, "when": {"height": [3, 2]}}]}]})",
      rod + R"("controllers": [{"kind": "network", "nodes": []}]})",
      "{\"title\": \"" + std::string(100, 'a') + "\"}",
      "{\"title\": \"\xff\"}",
      std::string(50, '['),
  };
  for (const std::string& text : texts) {
    CAPTURE(text);
    const auto document = DecodeJson(text);
    REQUIRE_FALSE(document);
    CAPTURE(document.error().Sentence());
    CHECK(TrSentence(document.error().what) != document.error().what);
    CHECK(TrError(document.error()) != document.error().Sentence());
  }
  const auto figure = DecodeFigureJson("[]");
  REQUIRE_FALSE(figure);
  CHECK(TrError(figure.error()) == "eine Figur muss ein Objekt sein, dies ist eine Liste");
  const auto digit = DecodeJson("{\"rules\": 1.}");
  REQUIRE_FALSE(digit);
  CHECK(TrError(digit.error()) == "Zeile 1, Spalte 13: nach dem Punkt fehlt eine Ziffer");
}

TEST_CASE("language: errors of links are translated to German", "[shell][language]") {
  const ScopedLanguage german(German());
  Document document;
  document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  const std::string link = EncodeLink(document);
  std::vector<std::string> links = {
      "", "#", "a!b", "A", "AAAA", "_____", link.substr(0, link.size() / 2), link + "AAAA"};
  links.push_back(link);
  links.back()[10] = link[10] == 'A' ? 'B' : 'A';
  for (const std::string& wrong : links) {
    CAPTURE(wrong);
    const auto opened = DecodeLink(wrong);
    REQUIRE_FALSE(opened);
    const auto [english, told] = Sentences(opened.error());
    CAPTURE(english);
    CHECK(told != english);
    CHECK(told.starts_with("Link: "));
    CHECK(TrSentence(opened.error().what) != opened.error().what);
  }
}

TEST_CASE("language: every wrong kind of value is named in German", "[shell][language]") {
  const ScopedLanguage german(German());
  for (const char* wanted : {R"("title")", R"("rules")", R"("figure")", R"("pushes")"}) {
    for (const char* given : {"null", "true", "2", "\"a\"", "[]", "{}"}) {
      const auto document = DecodeJson(std::string("{") + wanted + ": " + given + "}");
      if (document || !document.error().what.starts_with("must be")) continue;
      CAPTURE(document.error().what);
      CHECK(TrSentence(document.error().what) != document.error().what);
    }
  }
}

}  // namespace
}  // namespace gaitsmith::shell::test
