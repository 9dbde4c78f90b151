// SPDX-License-Identifier: MIT
#include "core/document/document.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <functional>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// A document with a non-standard value in every field.
Document Everything(SenseKind kind) {
  Document d = StarManTravel(kind);
  d.title = "Tumble \"two\" \\ π";
  d.figure = ShippedFigure("beryl-biped");
  d.environment = {3.7f, 0.55f, -0.12f};
  d.start = {0.4f, 1.5f, -0.25f, 2.5f};
  d.pushes = {{10, kCentreOfMass, 1.5f, -2.0f}, {90, 3, 0.1f, 0.0f}};
  d.task = {TaskKind::kTravelLeft, 731, {0.25f, -1.5f, 3.0f}};
  d.senses.period_steps = 77;
  d.senses.tau_min_s = 0.08f;
  d.rules = 7;
  d.search.seed = 4000000001u;
  d.search.evaluations = 12345;
  d.search.variation.creep = 0.07f;
  d.controllers = {RandomController(d.figure, d.senses, 1), RandomController(d.figure, SenseSpec{}, 2)};
  d.controllers[0].name = "first";
  d.timeline = {{1, 0}, {0, 120}, {1, 300}};
  d.duration_steps = 450;
  d.view = {0.5f, 3, false, true, false};
  REQUIRE(Validate(d));
  return d;
}

std::string JsonFault(const std::string& json) {
  const auto document = DecodeJson(json);
  return document ? "valid" : document.error().Sentence();
}

std::string Changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("document: JSON -> binary -> link -> JSON is the identity", "[document]") {
  for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
    Document d = Everything(kind);
    d.hash = Simulate(d).Hash();
    const std::string json = EncodeJson(d);
    const auto from_json = DecodeJson(json);
    REQUIRE(from_json);
    REQUIRE(EncodeJson(*from_json) == json);
    const auto binary = EncodeBinary(*from_json);
    const auto from_binary = DecodeBinary(binary);
    REQUIRE(from_binary);
    const std::string link = EncodeLink(*from_binary);
    const auto from_link = DecodeLink("https://example.org/play/#" + link + "\n");
    REQUIRE(from_link);
    REQUIRE(EncodeJson(*from_link) == json);
    REQUIRE(Simulate(*from_link).Hash() == *d.hash);
  }
}

TEST_CASE("document: links of ten-rule Star-Man controllers are short", "[document]") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
      Document d = StarManTravel(kind);
      d.controllers = {RandomController(d.figure, d.senses, seed)};
      d.timeline = {{0, 0}};
      REQUIRE(EncodeLink(d).size() <= (kind == SenseKind::kPhysical ? 900u : 400u));
    }
  }
  // The longest possible document: every rule uses every sense.
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 1)};
  for (Gene& gene : d.controllers[0].genes) gene = 12345;
  d.timeline = {{0, 0}};
  REQUIRE(EncodeLink(d).size() <= 900);
}

TEST_CASE("link: every truncation and every changed character is refused", "[document]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 3)};
  d.timeline = {{0, 0}};
  const std::string link = EncodeLink(d);
  REQUIRE(DecodeLink(link));
  for (std::size_t length = 0; length < link.size(); ++length) {
    const auto cut = DecodeLink(std::string_view(link).substr(0, length));
    REQUIRE(!cut);
    REQUIRE(cut.error().where == "link");
  }
  for (std::size_t at = 0; at < link.size(); ++at) {
    for (const char c : std::string("AZaz09-_ %é")) {
      std::string changed = link;
      if (changed[at] == c) continue;
      changed[at] = c;
      CAPTURE(at, c);
      // White space around a link is ignored, but then the link is one character short.
      REQUIRE(!DecodeLink(changed));
    }
  }
  REQUIRE(!DecodeLink(link + "A"));
}

TEST_CASE("binary: every flipped bit is refused", "[document]") {
  Document d = StarManTravel(SenseKind::kTimer);
  d.controllers = {RandomController(d.figure, d.senses, 3)};
  d.timeline = {{0, 0}};
  const auto bytes = EncodeBinary(d);
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    auto flipped = bytes;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ (1u << (bit % 8)));
    REQUIRE(!DecodeBinary(flipped));
  }
  auto newer = bytes;
  newer[0] = static_cast<std::uint8_t>(LatestBinaryVersion() + 1);
  REQUIRE(DecodeBinary(newer).error().code == ErrorCode::kUnknownVersion);
  REQUIRE(DecodeBinary(std::span(bytes).first(30)).error().code == ErrorCode::kTruncated);
  REQUIRE(DecodeBinary(std::span(bytes).first(30)).error().what ==
          "was cut: 30 bytes arrived of " + std::to_string(bytes.size()));
}

TEST_CASE("binary: values out of range are refused even when the checksum is right", "[document]") {
  Document d = StarManTravel(SenseKind::kTimer);
  d.environment.friction = 99.0f;  // the encoder does not check, so this is well-formed but invalid
  const auto decoded = DecodeBinary(EncodeBinary(d));
  REQUIRE(!decoded);
  REQUIRE(decoded.error().Sentence() == "environment.friction: must be from 0 to 10, is 99");
  d = StarManTravel(SenseKind::kTimer);
  d.timeline = {{5, 0}};
  REQUIRE(DecodeBinary(EncodeBinary(d)).error().Sentence() ==
          "timeline[0].controller: there is no controller 5, the document has 0");
}

TEST_CASE("document: a link made before version 2 decodes and encodes to the same characters", "[document]") {
  // Written by a Gaitsmith with version 1 only.
  constexpr std::string_view kLink =
      "AVMAACHSFkZWBiKWB2JXJjeX9uYGEjOgu3srAIMzMzM_"
      "AADGJQAMHgAAAMSBAQBM4XrsMVAwS5OboxuXABCSAcDUgamDOIG7gD4YgMEBm1OfZEsppCsNEtKOyA";
  const auto document = DecodeLink(kLink);
  REQUIRE(document);
  REQUIRE(document->search.algorithm == Algorithm::kSphc);
  REQUIRE(document->search.start == -1);
  REQUIRE(document->search.genetic.population == 200);
  REQUIRE(EncodeLink(*document) == kLink);
  for (const std::string& name : GoldenMotions()) {
    const std::string json = ReadFile(name);
    const auto golden = DecodeJson(json);
    REQUIRE(golden);
    // Networks came with version 2.
    const bool network = std::ranges::any_of(
        golden->controllers, [](const Controller& one) { return one.kind == ControllerKind::kNetwork; });
    REQUIRE(EncodeBinary(*golden)[0] == (network ? 2 : 1));
    REQUIRE(EncodeJson(*golden) == json);
  }
}

TEST_CASE("document: every parameter of every search travels, and costs a version only when it is set",
          "[document]") {
  const std::vector<std::function<void(Document&)>> edits = {
      [](Document& d) { d.search.genetic.rates.copies = Copies::kPerturbed; },
      [](Document& d) { d.search.variation.heedless = Heedless::kForbidden; },
      // From here on those of version 2.
      [](Document& d) { d.search.start = 0; },
      [](Document& d) { d.search.genetic.population = 64; },
      [](Document& d) { d.search.genetic.rates.mutation = 0.0f; },
      [](Document& d) { d.search.genetic.rates.crossover = 1.0f; },
      [](Document& d) { d.search.genetic.rates.reading = RateReading::kPerComponent; },
      [](Document& d) { d.search.genetic.rank_bias = 1.75f; },
      [](Document& d) { d.search.torus.side = 16; },
      [](Document& d) { d.search.torus.walk_steps = 3; },
      [](Document& d) { d.search.refine.step = 0.25f; },
      [](Document& d) { d.search.cma.covariance = Covariance::kSeparable; },
      [](Document& d) { d.search.cma.genes = CmaGenes::kAll; },
      [](Document& d) { d.search.cma.draws = 7; },
      [](Document& d) { d.search.cma.population = 30; },
      [](Document& d) { d.search.cma.step = 0.5f; },
      [](Document& d) { d.search.cma.growth = 1.0f; },
      [](Document& d) { d.search.elites.initial = 500; },
      [](Document& d) { d.search.elites.batch = 8; },
      [](Document& d) { d.search.elites.bins = 12; },
      [](Document& d) { d.search.elites.most[0] = 5.0f; },
      [](Document& d) { d.search.elites.most[1] = 6.0f; },
      [](Document& d) { d.search.elites.most[2] = 7.0f; },
      [](Document& d) { d.search.elites.crossover = 0.5f; },
      [](Document& d) { d.search.elites.emitters = 3; },
      [](Document& d) { d.search.elites.learning = 0.5f; },
      [](Document& d) { d.search.cma.restarts = Restarts::kBipop; },
      [](Document& d) { d.search.genetic.niching = Niching::kKept; },
      [](Document& d) { d.search.genetic.rates.crossing = Crossing::kBlended; },
      [](Document& d) { d.search.difference.population = 30; },
      [](Document& d) { d.search.difference.weight = 0.7f; },
      [](Document& d) { d.search.difference.crossover = 0.4f; },
      [](Document& d) { d.search.cost = Cost::kSlip; },
  };
  Document plain = StarManTravel(SenseKind::kTimer);
  plain.controllers = {RandomController(plain.figure, plain.senses, 3)};
  const std::size_t shortest = EncodeBinary(plain).size();
  Document all = plain;
  for (const auto& edit : edits) {
    Document d = plain;
    edit(d);
    edit(all);
    CAPTURE(&edit - edits.data());
    REQUIRE(Validate(d));
    const auto bytes = EncodeBinary(d);
    const auto at = static_cast<std::size_t>(&edit - edits.data());
    const bool newest = at + 10 >= edits.size();
    REQUIRE(bytes[0] == (at < 2 ? 3 : newest ? 13 : 2));
    // 21 more bits for the others, 33 for this one, one byte of rounding; a later version has more fields.
    REQUIRE(bytes.size() <= shortest + (newest ? 16 : 8));
    const auto from_binary = DecodeBinary(bytes);
    REQUIRE(from_binary);
    REQUIRE(EncodeBinary(*from_binary) == bytes);
    const std::string json = EncodeJson(d);
    REQUIRE(json != EncodeJson(plain));
    REQUIRE(EncodeJson(*from_binary) == json);
    const auto from_json = DecodeJson(json);
    REQUIRE(from_json);
    REQUIRE(EncodeBinary(*from_json) == bytes);
  }
  const auto back = DecodeBinary(EncodeBinary(all));
  REQUIRE(back);
  REQUIRE(EncodeJson(*back) == EncodeJson(all));
}

TEST_CASE("document: algorithms alone need no new version; version 2 with nothing new is refused",
          "[document]") {
  Document d = StarManTravel(SenseKind::kTimer);
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    d.search.algorithm = static_cast<Algorithm>(i);
    const auto bytes = EncodeBinary(d);
    REQUIRE(bytes[0] == 1);
    d.search.evaluations = 4096;
    REQUIRE(DecodeBinary(EncodeBinary(d))->search.algorithm == d.search.algorithm);
    // The same body with the newer version number and a valid checksum is a second encoding of the same
    // document.
    auto other = bytes;
    other[0] = 2;
    other.resize(other.size() - 4);
    for (int k = 0; k < 4; ++k) other.push_back(0);
    const std::uint32_t crc = Crc32(std::span(other).first(other.size() - 4));
    for (std::size_t k = 0; k < 4; ++k)
      other[other.size() - 4 + k] = static_cast<std::uint8_t>(crc >> (8 * k));
    REQUIRE(!DecodeBinary(other));
  }
}

TEST_CASE("document: settings that no search can have are refused with what is allowed", "[document]") {
  const auto fault = [](const std::function<void(Document&)>& edit) {
    Document d = StarManTravel(SenseKind::kTimer);
    d.controllers = {RandomController(d.figure, d.senses, 3)};
    edit(d);
    const auto valid = Validate(d);
    return valid ? std::string("valid") : valid.error().Sentence();
  };
  CHECK(fault([](Document& d) { d.search.genetic.population = 0; }) ==
        "search.genetic.population: must be from 2 to 10000, is 0");
  CHECK(fault([](Document& d) { d.search.genetic.rates.mutation = 1.5f; }) ==
        "search.genetic.mutation_rate: must be from 0 to 1, is 1.5");
  CHECK(fault([](Document& d) { d.search.genetic.rank_bias = NAN; }) ==
        "search.genetic.rank_bias: must be a finite number");
  CHECK(fault([](Document& d) { d.search.torus.side = 1; }) ==
        "search.torus.side: must be from 2 to 128, is 1");
  CHECK(fault([](Document& d) { d.search.elites.bins = 33; }) ==
        "search.elites.bins: must be from 1 to 32, is 33");
  CHECK(fault([](Document& d) { d.search.start = 1; }) ==
        "search.start: there is no controller 1, the document has 1");
  CHECK(fault([](Document& d) {
          d.search.start = 0;
          d.rules = 9;
        }) ==
        "search.start: must be a controller of the kind, the senses and the number of rules that are "
        "searched for");
  CHECK(fault([](Document& d) {
          d.search.algorithm = Algorithm::kGga;
          d.search.evaluations = 199;
        }) == "search.evaluations: must be at least the population, 200, is 199");
  CHECK(fault([](Document& d) {
          d.search.algorithm = Algorithm::kMpga;
          d.search.evaluations = 4000;
        }) == "search.evaluations: must be at least the population, 4096, is 4000");
  CHECK(fault([](Document& d) {
          d.search.algorithm = Algorithm::kCmaEs;
          d.search.cma.population = 3;
        }) == "search.cma.population: must be 0 (automatic) or at least 4, is 3");
  CHECK(fault([](Document& d) {
          d.search.algorithm = Algorithm::kCmaEs;
          d.search.cma.covariance = Covariance::kFull;
          d.senses.kind = SenseKind::kPhysical;
          d.rules = 32;
        }) == "search.cma.covariance: can be full for at most 600 genes, there are 928");
}

TEST_CASE("CRC-32: the check value of the standard", "[document]") {
  const std::string digits = "123456789";
  REQUIRE(Crc32({reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size()}) == 0xcbf43926u);
}

TEST_CASE("JSON: what is wrong is said with its place", "[document]") {
  const std::string json = EncodeJson(Everything(SenseKind::kPhysical));
  CHECK(JsonFault("") == "line 1, column 1: the text ends where a value should be");
  CHECK(JsonFault("[]") == "a document must be an object, this is a list");
  CHECK(JsonFault("{\n  \"title\": nope}") == "line 2, column 12: expected a value");
  CHECK(JsonFault(json + "x").ends_with("there is more text after the end of the document"));
  CHECK(JsonFault(Changed(json, "\"friction\": 0.55", "\"friction\": 12")) ==
        "environment.friction: must be from 0 to 10, is 12");
  CHECK(JsonFault(Changed(json, "\"friction\": 0.55", "\"friction\": \"a\"")) ==
        "environment.friction: must be a number, is a text");
  CHECK(JsonFault(Changed(json, "\"friction\": 0.55", "\"friktion\": 0.55")) ==
        "environment.friktion: there is no such field");
  CHECK(JsonFault(Changed(json, "\"friction\": 0.55", "\"friction\": 0.5, \"friction\": 0.55"))
            .ends_with("the field \"friction\" is there twice"));
  CHECK(JsonFault("{\"seed\": 1e999}") == "line 1, column 10: the number is too large");
  CHECK(JsonFault(Changed(json, "\"seed\": 4000000001", "\"seed\": 4294967296")) ==
        "search.seed: must be from 0 to 4294967295, is 4294967296");
  CHECK(JsonFault(Changed(json, "\"rules\": 7", "\"rules\": 1.5")) ==
        "rules: must be a whole number, is 1.5");
  CHECK(JsonFault(Changed(json, "\"sphc\"", "\"hpc\"")) ==
        "search.algorithm: \"hpc\" is unknown: choose from rgt, sphc, gga, ssga, shc, mpga, nelder-mead, "
        "powell, cma-es, map-elites, two-stage, pose-cycle, de, nsga-ii, cma-mae");
  CHECK(JsonFault(Changed(json, "\"start_step\": 120", "\"start_step\": 300")) ==
        "timeline[2].start_step: must be after the start of the clip before it");
  CHECK(JsonFault(std::string(100, '[')).ends_with("is nested too deeply"));
  CHECK(JsonFault("{\"title\": \"\xff\"}") == "title: must be printable UTF-8 text, but byte 0 is not");
  CHECK(JsonFault("{\"model\": 4}") ==
        "model: needs physical model 4, but this Gaitsmith has models up to 3: a newer one is needed");
  CHECK(DecodeJson("{\"model\": 4}").error().code == ErrorCode::kUnknownVersion);
  for (const std::string hash :
       {"", "0123456789abcde", "0123456789abcdefe", "0123456789abcdeg", "0123456789ABCDEF"}) {
    CHECK(JsonFault("{\"hash\": \"" + hash + "\"}") == "hash: must be 16 hexadecimal digits");
  }
  std::string crowded = "{";
  for (int i = 0; i < 100; ++i) crowded += "\"f" + std::to_string(i) + "\": 0,";
  CHECK(JsonFault(crowded + "\"z\": 0}").ends_with("there are more fields than any object has"));
  std::string zeros;
  for (int i = 0; i < 450000; ++i) zeros += "0,";
  CHECK(JsonFault("{\"a\": [" + zeros + "0]}").ends_with("there are more values than any document has"));
}

TEST_CASE("JSON: fields may be left out when they have a standard value", "[document]") {
  const auto document = DecodeJson(R"({"figure": {"rods": [{}, {"parent": 0}]}})");
  REQUIRE(document);
  REQUIRE(document->environment.friction == 0.8f);
  REQUIRE(document->figure.rods[1].parent == 0);
}

TEST_CASE("JSON: a controller of another figure is refused", "[document]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(ShippedFigure("inchworm"), d.senses, 1)};
  const auto valid = Validate(d);
  REQUIRE(!valid);
  REQUIRE(valid.error().where == "controllers[0].rules");
}

}  // namespace gaitsmith::test
