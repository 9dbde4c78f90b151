// SPDX-License-Identifier: MIT
// Exported files agree with the motion. tests/web/export.test.mjs checks that other programs can read them.
#include <algorithm>
#include <bit>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/world/ground_preset.h"
#include "shell/export/exporters.h"
#include "shell/export/film_strip.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {
namespace {

Document ShippedMotion(const std::string& name) {
  return DecodeJson(gaitsmith::test::ReadFile("examples/" + name + ".json")).value();
}

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Reads the nodes and the animation of a glTF file.
class Gltf {
 public:
  explicit Gltf(const std::string& text) : json_(ParseJson(text, 1000000).value()) {
    const std::string& uri = At(json_, "buffers").items[0].Find("uri")->text;
    unsigned bits = 0;
    int held = 0;
    for (const char c : uri.substr(uri.find(',') + 1)) {
      constexpr std::string_view kLetters =
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      if (c == '=') break;
      bits = bits << 6 | static_cast<unsigned>(kLetters.find(c));
      held += 6;
      if (held >= 8) bytes_.push_back(static_cast<std::uint8_t>(bits >> (held -= 8)));
    }
  }

  static const JsonValue& At(const JsonValue& value, std::string_view name) {
    const JsonValue* found = value.Find(name);
    REQUIRE(found != nullptr);
    return *found;
  }
  [[nodiscard]] const JsonValue& Json() const { return json_; }

  [[nodiscard]] std::vector<float> Numbers(double accessor) const {
    const JsonValue& what = At(json_, "accessors").items[static_cast<std::size_t>(accessor)];
    const JsonValue& view =
        At(json_, "bufferViews").items[static_cast<std::size_t>(At(what, "bufferView").number)];
    const auto offset = static_cast<std::size_t>(At(view, "byteOffset").number);
    const auto length = static_cast<std::size_t>(At(view, "byteLength").number);
    REQUIRE(offset % 4 == 0);
    REQUIRE(offset + length <= bytes_.size());
    std::vector<float> numbers;
    for (std::size_t i = offset; i < offset + length; i += 4) {
      std::uint32_t word = 0;
      for (std::size_t k = 4; k-- > 0;) word = word << 8 | bytes_[i + k];
      numbers.push_back(std::bit_cast<float>(word));
    }
    return numbers;
  }

  struct Channel {
    std::vector<float> times, values;
  };
  [[nodiscard]] Channel ChannelOf(int node, std::string_view path) const {
    const JsonValue& animation = At(json_, "animations").items[0];
    for (const JsonValue& channel : At(animation, "channels").items) {
      const JsonValue& target = At(channel, "target");
      if (At(target, "node").number != node || At(target, "path").text != path) continue;
      const JsonValue& sampler =
          At(animation, "samplers").items[static_cast<std::size_t>(At(channel, "sampler").number)];
      return {Numbers(At(sampler, "input").number), Numbers(At(sampler, "output").number)};
    }
    return {};
  }

 private:
  JsonValue json_;
  std::vector<std::uint8_t> bytes_;
};

/// A rigid transformation of the plane.
struct Place {
  double x = 0.0, y = 0.0, cosine = 1.0, sine = 0.0;

  [[nodiscard]] Place Of(double dx, double dy, double z, double w) const {
    const double c = w * w - z * z, s = 2.0 * z * w;
    return {x + cosine * dx - sine * dy, y + sine * dx + cosine * dy, cosine * c - sine * s,
            sine * c + cosine * s};
  }
};

/// Computes the rods' ends from the node hierarchy, as a glTF reader does, and compares them with the motion.
void CheckForwardKinematics(const Document& document) {
  const Motion motion = Simulate(document);
  const Gltf gltf(SkeletonGltf(document, motion));
  const auto& nodes = Gltf::At(gltf.Json(), "nodes").items;
  const Skeleton& bones = motion.Bones();
  const int ground = document.environment.ground.empty() ? 0 : 1;
  REQUIRE(static_cast<int>(nodes.size()) == bones.rods + 1 + ground);
  const Gltf::Channel path = gltf.ChannelOf(1, "translation");
  std::vector<Gltf::Channel> turns;
  for (int rod = 0; rod < bones.rods; ++rod) {
    turns.push_back(gltf.ChannelOf(rod + 1, "rotation"));
    REQUIRE(turns.back().values.size() == 4 * turns.back().times.size());
    for (std::size_t i = 4; i < turns.back().values.size(); i += 4) {
      const float* q = &turns.back().values[i];
      CHECK(q[2] * q[-2] + q[3] * q[-1] > 0.0f);  // interpolation takes the shorter way between keyframes
    }
  }
  REQUIRE(path.times.back() == Catch::Approx((motion.Frames() - 1) * 0.01));

  double worst = 0.0;
  for (std::size_t key = 0; key < path.times.size(); ++key) {
    const auto frame = static_cast<int>(std::lround(path.times[key] * 100.0f));
    std::vector<Place> rods(static_cast<std::size_t>(bones.rods));
    const auto visit = [&](const auto& self, std::size_t node, const Place& parent) -> void {
      const JsonValue& what = nodes[node];
      const std::size_t rod = node - 1;
      const auto shift = [&](std::size_t axis) {
        return node == 1 ? static_cast<double>(path.values[3 * key + axis])
                         : Gltf::At(what, "translation").items[axis].number;
      };
      const float* q = &turns[rod].values[4 * key];
      rods[rod] = parent.Of(shift(0), shift(1), static_cast<double>(q[2]), static_cast<double>(q[3]));
      const JsonValue* children = what.Find("children");
      for (std::size_t i = 0; children != nullptr && i < children->items.size(); ++i)
        self(self, static_cast<std::size_t>(children->items[i].number), rods[rod]);
    };
    visit(visit, 1, Place{});
    for (int rod = 0; rod < bones.rods; ++rod) {
      const Place& at = rods[static_cast<std::size_t>(rod)];
      const double length = static_cast<double>(bones.limbs[static_cast<std::size_t>(rod)].length_m);
      const Motion::Point end = motion.Endpoint(frame, rod + 1);
      const Motion::Frame& centre = motion.At(frame);
      worst = std::max({worst, std::abs(at.x + length * at.cosine - centre.x_m - static_cast<double>(end.x)),
                        std::abs(at.y + length * at.sine - static_cast<double>(centre.y_m + end.y))});
    }
  }
  CHECK(worst < 1e-3);
}

TEST_CASE("export: the film strip has the requested number of poses, each with its letter") {
  for (const char* name : {"star-man-shuffle", "there-and-back", "beryl-wind-up", "star-man-network"}) {
    const Document document = ShippedMotion(name);
    const Motion motion = Simulate(document);
    for (const int poses : {3, 8, 9, 10, 19, 26}) {
      const std::string svg = FilmStripSvg(document, motion, {.poses = poses});
      CHECK(Count(svg, "<g class=\"pose\"") == static_cast<std::size_t>(poses));
      CHECK(Count(svg, std::string(">") + static_cast<char>('A' + poses - 1) + "</text>") == 1);
      CHECK(Count(svg, ">0.00 s</text>") == 1);
      CHECK(svg == FilmStripSvg(document, motion, {.poses = poses}));
      CHECK(Count(svg, "nan") + Count(svg, "inf") == 0);
    }
  }
}

TEST_CASE("export: names on a film strip are escaped") {
  Document document = ShippedMotion("star-man-shuffle");
  document.title = "</title><script>alert(1)</script> & \"so\" 'on'";
  document.figure.name = "<b>{1}</b>";
  FilmStripOptions options;
  options.words.decimal_mark = ",";
  const std::string svg = FilmStripSvg(document, Simulate(document), options);
  CHECK(Count(svg, "<script") + Count(svg, "<b>") == 0);
  CHECK(
      Count(svg, "&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;so&quot; &apos;on&apos;") ==
      2);
  CHECK(Count(svg, "8 poses of &lt;b&gt;{1}&lt;/b&gt; from 0,00 s to 10,00 s, lettered A to H.") == 1);
}

TEST_CASE("export: poses of a film strip do not overlap, and times are clamped to the motion") {
  Document document = ShippedMotion("there-and-back");
  document.duration_steps = 1;
  const Motion shortest = Simulate(document);
  CHECK(Count(FilmStripSvg(document, shortest, {.poses = 26, .from_s = 5.0, .to_s = 7.0}),
              "<g class=\"pose\"") == 26);
  // Distant poses share one ground, in the order of time.
  const Document far = ShippedMotion("star-man-shuffle");
  const std::string shared = FilmStripSvg(far, Simulate(far), {.poses = 3});
  CHECK(Count(shared, "rx=\"7\"") == 0);
  CHECK(Count(FilmStripSvg(far, Simulate(far), {.poses = 12}), "rx=\"7\"") == 12);
}

TEST_CASE("export: a film strip draws the ground that its document draws") {
  Document document = ShippedMotion("star-man-shuffle");
  const Motion motion = Simulate(document);
  const auto strip = [&] { return FilmStripSvg(document, motion, {.poses = 4}); };
  const std::string level = strip();
  document.model = 2;
  document.environment.ground = GroundOf(GroundPreset::kStepUp);
  CHECK(strip() != level);
  CHECK(Count(strip(), "Z\" fill=\"#efebe3\"/>") > 0);
  // Before and after what is drawn the ground is level.
  document.environment.ground = {{-200.0f, 0.0f}, {200.0f, 0.0f}};
  const std::string flat = strip();
  CHECK(Count(flat, "<rect") + Count(flat, "Z\" fill") == Count(level, "<rect"));
}

TEST_CASE("export: a film strip of springs has a belly for each muscle, and a disc for each node",
          "[shell][export]") {
  const Document table = DecodeJson(gaitsmith::test::ReadFile("examples/gallery/table-trip.json")).value();
  const std::string strip = FilmStripSvg(table, Simulate(table), {.poses = 5});
  const auto muscles = static_cast<std::size_t>(table.figure.Muscles());
  CHECK(Count(strip, "Z\" fill=\"#1d2733\"") == 5 * muscles);
  CHECK(Count(strip, "<circle") == 5 * table.figure.nodes.size());
  CHECK(Count(strip, "fill=\"none\" stroke=\"#8a929b\"") == 5 * (table.figure.springs.size() - muscles));
}

TEST_CASE("export: forward kinematics of the glTF scene yields the motion's endpoints") {
  for (const char* name : {"star-man-shuffle", "there-and-back", "beryl-wind-up", "star-man-network"})
    CheckForwardKinematics(ShippedMotion(name));
  for (const std::string& name : gaitsmith::test::GoldenLimitedMotions())
    CheckForwardKinematics(DecodeJson(gaitsmith::test::ReadFile(name)).value());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Document document = ShippedMotion("star-man-shuffle");
    document.figure = gaitsmith::test::RandomFigure(seed);
    document.controllers = {gaitsmith::test::RandomController(document.figure, {}, seed)};
    document.timeline = {{0, 0}};
    document.duration_steps = static_cast<int>(100 + seed);
    document.start.spin_radps = 15.0f;  // several whole turns
    document.start.drop_height_m = 3.0f;
    CheckForwardKinematics(document);
  }
}

TEST_CASE("export: a slope tilts the whole glTF scene") {
  Document document = ShippedMotion("star-man-shuffle");
  const auto root = [&document] {
    const Gltf gltf(SkeletonGltf(document, Simulate(document)));
    return Gltf::At(gltf.Json(), "nodes").items[0];
  };
  CHECK(root().Find("rotation") == nullptr);
  document.environment.slope_rad = 0.2f;
  CHECK(Gltf::At(root(), "rotation").items[2].number == Catch::Approx(std::sin(0.1)).margin(1e-6));
}

TEST_CASE("export: a drawn ground is the last node of the glTF scene") {
  Document document = ShippedMotion("star-man-shuffle");
  const auto nodes = [&document] {
    return Gltf::At(Gltf(SkeletonGltf(document, Simulate(document))).Json(), "nodes");
  };
  const std::size_t rods = document.figure.rods.size();
  CHECK(nodes().items.size() == rods + 1);
  document.model = 2;
  document.environment.ground = GroundOf(GroundPreset::kRubble);
  REQUIRE(nodes().items.size() == rods + 2);
  CHECK(Gltf::At(nodes().items.back(), "name").text == "ground");
  CHECK(Gltf::At(nodes().items[0], "children").items.size() == 2);
}

TEST_CASE("export: limited joints have the same columns, and every format takes them") {
  Document document = ShippedMotion("star-man-shuffle");
  const auto head = [&] {
    const std::string csv = TrajectoryCsv(document, Simulate(document));
    return csv.substr(0, csv.find('\n'));
  };
  const std::string strong = head();
  LimitJoints(document);
  CHECK(head() == strong);
  // theta is where a joint is, not where its rule wants it: limp joints hang.
  SetJointStrength(0.0f, document);
  const Motion motion = Simulate(document);
  const std::string csv = TrajectoryCsv(document, motion);
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  std::istringstream cells(last);
  std::string cell;
  for (int column = 0; column <= 8; ++column) std::getline(cells, cell, ',');
  CHECK(std::strtof(cell.c_str(), nullptr) == motion.AngleRad(motion.Frames() - 1, 0));
  for (const ExporterRow& row : kExporters) {
    CAPTURE(row.id);
    CHECK_FALSE(MakeFile(row, document, motion, {}).value().empty());
  }
}

TEST_CASE("export: the centre of mass of a CSV is that of its nodes") {
  Document document = ShippedMotion("beryl-wind-up");
  document.model = GENERATE(1, 2);
  const Motion motion = Simulate(document);
  const Skeleton& bones = motion.Bones();
  std::istringstream csv(TrajectoryCsv(document, motion));
  std::string line;
  std::getline(csv, line);
  std::vector<std::string> names;
  std::istringstream header(line);
  for (std::string name; std::getline(header, name, ',');) names.push_back(name);
  const auto column = [&names](const std::string& name) {
    const auto found = std::ranges::find(names, name);
    REQUIRE(found != names.end());
    return static_cast<std::size_t>(found - names.begin());
  };
  int rows = 0;
  for (; std::getline(csv, line); ++rows) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::strtod(cell.c_str(), nullptr));
    REQUIRE(row.size() == names.size());
    for (const char* axis : {"x", "y"}) {
      double weighed = 0.0, mass = 0.0;
      for (int rod = 0; rod < bones.rods; ++rod) {
        const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(rod)];
        const auto node = [&](int k) { return row[column("node" + std::to_string(k) + "_" + axis)]; };
        weighed += static_cast<double>(limb.mass_kg) * 0.5 * (node(limb.start) + node(rod + 1));
        mass += static_cast<double>(limb.mass_kg);
      }
      CHECK(weighed / mass == Catch::Approx(row[column(axis)]).margin(1e-5));
    }
  }
  CHECK(rows == motion.Frames());
}

}  // namespace
}  // namespace gaitsmith::shell::test
