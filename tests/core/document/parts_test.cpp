// SPDX-License-Identifier: MIT
// Each field of the schema belongs to exactly one part of a document: a change of that field alone is a
// change of that part alone, and copying the part copies the change.
#include "core/document/parts.h"

#include <catch_amalgamated.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "core/document/schema.h"
#include "core/rollout/models.h"
#include "tests/spring_scene.h"

namespace gaitsmith {

namespace {

// Walks a document as the encodings do, notes the path of each field and changes one of them.
class Changer : public Archive {
 public:
  explicit Changer(int wanted) : wanted_(wanted) {}
  [[nodiscard]] const std::vector<std::string>& Paths() const { return paths_; }
  /// Lists whose fields are not looked at.
  [[nodiscard]] const std::set<std::string>& Empty() const { return empty_; }

  void Real(std::string_view name, float& value, float, float, float) override {
    if (Turn(name)) value += 0.125f;
  }
  void Integer(std::string_view name, int& value, int, int, int) override {
    if (Turn(name)) ++value;
  }
  void Model(std::string_view name, int& model) override {
    if (Turn(name)) ++model;
  }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t) override {
    if (Turn(name)) ++value;
  }
  void Flag(std::string_view name, bool& value, bool) override {
    if (Turn(name)) value = !value;
  }
  void Text(std::string_view name, std::string& text) override {
    if (Turn(name)) text += "x";
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) override {
    if (Turn(name)) hash = hash.value_or(0) + 1;
  }
  void Genes(Controller& controller, const PortCount&) override {
    if (Turn("rules")) ++controller.rules;
    if (Turn("genes")) ++controller.genes.back();
  }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view>, int) override {
    if (Turn(name)) index = index == 0 ? 1 : 0;
  }
  bool BeginGroup(std::string_view name) override {
    groups_.emplace_back(name);
    return true;
  }
  void EndGroup() override { groups_.pop_back(); }
  bool BeginList(std::string_view name, std::size_t& size, int) override {
    if (size == 0) empty_.insert(std::string(name));
    if (Turn(name) && size > 0) --size;
    return BeginGroup(name);
  }
  void EndList() override { groups_.pop_back(); }
  bool Turn(std::string_view name) {
    std::string path;
    for (const std::string& group : groups_) path += group + "/";
    paths_.push_back(path + std::string(name));
    return static_cast<int>(paths_.size()) - 1 == wanted_;
  }
  int wanted_;
  std::vector<std::string> groups_;
  std::vector<std::string> paths_;
  std::set<std::string> empty_;
};

// The document after one of its fields has changed. @return the field's path; empty: there is no such field
std::string Change(Document& document, int field) {
  Changer changer(field);
  Describe(changer, document);
  const auto index = static_cast<std::size_t>(field);
  return index < changer.Paths().size() ? changer.Paths()[index] : "";
}

// With something in every list that a figure of rods may have.
Document Full() {
  Document d;
  d.title = "Full";
  d.figure = {"Hinge", {Rod{}, Rod{}}};
  d.figure.rods[1].parent = 0;
  d.figure.rods[1].length_m = 2.0f;
  d.drawn = d.figure.rods;
  d.model = 2;
  d.environment.ground = {{1.0f, 0.0f}, {2.0f, 0.5f}};
  d.pushes = {{.step = 3, .endpoint = 0, .impulse_x_ns = 1.0f}};
  Controller controller{.name = "One", .senses = d.senses, .rules = 2, .genes = {}};
  controller.genes.assign(BankShape(2, d.senses.kind, 2).Genes(), 7);
  d.controllers = {controller, controller};
  d.timeline = {{.controller = 0, .start_step = 0}, {.controller = 1, .start_step = 100}};
  d.search.handovers = {{.controller = 1, .step = 50}};
  d.task.shown.way = {{.step = 5, .x_m = 1.0f, .y_m = 2.0f}, {.step = 50, .x_m = 2.0f, .y_m = 1.0f}};
  d.task.shown.pose_rad = {0.5f};
  BreedRound round;
  round.task = d.task;
  d.plan.keyframes = {{.step = 5, .pose_rad = {0.5f}, .marks = {{.endpoint = 1, .x_m = 1.0f}}},
                      {.step = 9, .pose_rad = {0.25f}, .marks = {{.x_m = 2.0f}}}};
  d.plan.stances = {{.endpoint = 0, .first_step = 0, .last_step = 3},
                    {.endpoint = 0, .first_step = 5, .last_step = 9}};
  d.plan.solved.unknowns.assign(static_cast<std::size_t>(UnknownsOf(SceneOf(d), {})), 0.5f);
  d.lineage = {.founders = {controller, controller}, .rounds = {round, round}};
  d.hash = 0x1234;
  return d;
}

// With something in every list that a figure of springs may have.
Document FullOfSprings() {
  Document d;
  d.title = "Springs";
  SetFigure(Box(), d);
  d.environment.ground = {{1.0f, 0.0f}, {2.0f, 0.5f}};
  d.pushes = {{.step = 3, .endpoint = 0, .impulse_x_ns = 1.0f}};
  Controller controller{.name = "One", .senses = d.senses, .rules = 2, .genes = {}};
  controller.genes.assign(controller.Shape(CountPorts(d.model, d.figure)).Genes(), 7);
  d.controllers = {controller, controller};
  d.timeline = {{.controller = 0, .start_step = 0}, {.controller = 1, .start_step = 100}};
  d.search.handovers = {{.controller = 1, .step = 50}};
  d.task.shown.way = {{.step = 5, .x_m = 1.0f, .y_m = 2.0f}, {.step = 50, .x_m = 2.0f, .y_m = 1.0f}};
  BreedRound round;
  round.task = d.task;
  d.lineage = {.founders = {controller, controller}, .rounds = {round, round}};
  d.hash = 0x1234;
  return d;
}

std::set<std::string> EmptyLists(Document document) {
  Changer changer(-1);
  Describe(changer, document);
  return changer.Empty();
}

// By the JSON key, or by the path where a group is of two parts.
const std::map<std::string, Part>& ExpectedParts() {
  static const std::map<std::string, Part> kParts = {
      {"title", Part::kTitle},
      {"model", Part::kModel},
      {"figure", Part::kFigure},
      {"environment", Part::kEnvironment},
      {"start", Part::kStart},
      {"pushes", Part::kPushes},
      {"task", Part::kGoal},
      {"task/duration_steps", Part::kTaskLength},
      {"senses", Part::kSought},
      {"rules", Part::kSought},
      {"kind", Part::kSought},
      {"search", Part::kSearch},
      {"search/start", Part::kSearchStart},
      {"search/in_place_of", Part::kTakeover},
      {"search/handovers", Part::kTakeover},
      {"controllers", Part::kControllers},
      {"timeline", Part::kTimeline},
      {"duration_steps", Part::kDuration},
      {"plan", Part::kPlan},
      {"view", Part::kView},
      {"lineage", Part::kLineage},
      {"drawn", Part::kFigure},
      {"hash", Part::kHash},
  };
  return kParts;
}

// Null: the table above does not know the field.
const Part* Expected(std::string path) {
  while (true) {
    if (const auto at = ExpectedParts().find(path); at != ExpectedParts().end()) return &at->second;
    const auto slash = path.rfind('/');
    if (slash == std::string::npos) return nullptr;
    path.resize(slash);
  }
}

}  // namespace

TEST_CASE("parts: a change of one field is a change of the part that the field belongs to, and of no other",
          "[document][parts]") {
  // Fields need not fit each other here.
  Document full = Full();
  full.figure.nodes = FullOfSprings().figure.nodes;
  full.figure.springs = FullOfSprings().figure.springs;
  CHECK(EmptyLists(full) == std::set<std::string>{});
  CHECK(DifferingParts(full, full).Empty());
  std::set<Part> seen;
  int fields = 0;
  for (;; ++fields) {
    Document changed = full;
    const std::string path = Change(changed, fields);
    if (path.empty()) break;
    CAPTURE(path);
    const Part* part = Expected(path);
    REQUIRE(part != nullptr);
    seen.insert(*part);
    CHECK(DifferingParts(full, changed) == Parts(*part));
    CHECK_FALSE(SameParts(full, changed, *part));
    CHECK(SameParts(full, changed, AllParts().Without(*part)));

    // Copied with its part it arrives, and copied with all others it does not.
    Document with = full;
    CopyParts(changed, *part, with);
    CHECK(DifferingParts(with, changed).Empty());
    Document without = full;
    CopyParts(changed, AllParts().Without(*part), without);
    CHECK(DifferingParts(without, full).Empty());
  }
  CHECK(fields > 80);
  CHECK(seen.size() == kPartCount);
}

TEST_CASE("encodings: a change of any one field survives a link and a file", "[document]") {
  const Document full = GENERATE(Full(), FullOfSprings());
  CAPTURE(full.title, EmptyLists(full));
  REQUIRE(Validate(full));
  CHECK(EmptyLists(full) ==
        (full.figure.HasSprings()
             ? std::set<std::string>{"rods", "drawn", "pose", "keyframes", "stances", "unknowns"}
             : std::set<std::string>{"nodes", "springs"}));
  int tried = 0;
  for (int field = 0;; ++field) {
    Document changed = full;
    const std::string path = Change(changed, field);
    if (path.empty()) break;
    if (!Validate(changed)) continue;  // outside its range, or at odds with another field
    CAPTURE(path);
    ++tried;
    const auto of_link = DecodeBinary(EncodeBinary(changed));
    const auto of_file = DecodeJson(EncodeJson(changed));
    REQUIRE((of_link && of_file));
    CHECK(DifferingParts(*of_link, changed).Empty());
    CHECK(DifferingParts(*of_file, changed).Empty());
  }
  CHECK(tried > 70);
}

TEST_CASE("parts: every key of a document's JSON belongs to one", "[document][parts]") {
  const Document full = Full();
  REQUIRE(Validate(full));
  const auto json = ParseJson(EncodeJson(full));
  REQUIRE(json);
  std::set<std::string> unknown;
  for (const std::string& name : json->names) {
    if (!ExpectedParts().contains(name)) unknown.insert(name);
  }
  CHECK(unknown == std::set<std::string>{});
  CHECK(json->names.size() > 10);
}

TEST_CASE("parts: two documents differ in no part exactly when they are encoded alike", "[document][parts]") {
  const Document full = Full();
  Document other = full;
  other.start.drop_height_m = -0.0f;  // 0 is the standard, and is not written
  CHECK(EncodeBinary(other) == EncodeBinary(full));
  CHECK(DifferingParts(other, full).Empty());
  Document blank;
  CopyParts(full, AllParts(), blank);
  CHECK(EncodeBinary(blank) == EncodeBinary(full));
  CHECK(DifferingParts(blank, Document{}) == DifferingParts(full, Document{}));
  CopyParts(Document{}, AllParts().Without(Part::kTitle), blank);
  CHECK(blank.title == "Full");
  CHECK(DifferingParts(blank, Document{}) == Parts(Part::kTitle));
}

TEST_CASE("parts: controllers behave alike whatever they are called", "[document][parts]") {
  const Controller one = Full().controllers[0];
  Controller other = one;
  other.name = "Another";
  CHECK(SameBehaviour(one, other));
  ++other.genes.front();
  CHECK_FALSE(SameBehaviour(one, other));
}

}  // namespace gaitsmith
