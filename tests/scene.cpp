// SPDX-License-Identifier: MIT
#include "tests/scene.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/document/json.h"
#include "core/rollout/models.h"

namespace gaitsmith::test {

namespace {
const std::filesystem::path kRoot = GAITSMITH_SOURCE_DIR;

/// The paths of a folder's documents in the repository, sorted.
std::vector<std::string> DocumentsIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / folder)) {
    if (entry.path().extension() == ".json") names.push_back(folder + "/" + entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}
}  // namespace

std::string ReadFile(const std::string& path) {
  std::ifstream file(kRoot / path, std::ios::binary);
  INFO("reading " << path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

Figure ShippedFigure(const std::string& name) {
  auto figure = DecodeFigureJson(ReadFile("examples/figures/" + name + ".json"));
  REQUIRE(figure);
  return *figure;
}

namespace {

std::vector<std::string> FigureFiles(bool springs) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot / "examples/figures")) {
    const std::string name = entry.path().stem().string();
    if (ShippedFigure(name).HasSprings() == springs) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::vector<std::string> ShippedFigureFiles() { return FigureFiles(false); }
std::vector<std::string> ShippedSpringFiles() { return FigureFiles(true); }
std::vector<std::string> AllShippedFigureFiles() {
  std::vector<std::string> names = FigureFiles(false);
  for (const std::string& name : FigureFiles(true)) names.push_back(name);
  return names;
}

Terms AtEnd(const Motion& motion) { return motion.TermsAt(motion.Frames() - 1); }

Figure LyingRod() {
  Rod rod;
  rod.length_m = 1.3f;
  rod.mass_kg = 0.7f;
  return {"rod", {rod}};
}

Figure RandomFigure(std::uint64_t seed) {
  RandomStream random(seed, 77, 0);
  const auto between = [&](double low, double high) {
    return static_cast<float>(low + (high - low) * random.Uniform());
  };
  Figure figure;
  figure.name = "random " + std::to_string(seed);
  const auto rods = 2 + random.Below(7);
  for (std::uint32_t i = 0; i < rods; ++i) {
    Rod rod;
    rod.length_m = between(0.3, 1.2);
    rod.mass_kg = between(0.2, 2.0);
    rod.rest_rad = between(-3.0, 3.0);
    if (i > 0) {
      rod.parent = static_cast<int>(random.Below(i));
      rod.parent_end = random.Chance(0.5) ? RodEnd::kStart : RodEnd::kEnd;
    }
    figure.rods.push_back(rod);
  }
  REQUIRE(Validate(figure));
  return figure;
}

Controller HoldPose(const Figure& figure, const std::vector<float>& target_rad, float tau_s) {
  Controller hold;
  hold.rules = 1;
  hold.senses.tau_min_s = tau_s;
  hold.senses.tau_max_s = tau_s;
  const BankShape shape(1, SenseKind::kPhysical, figure.Rods());
  hold.genes.assign(shape.Genes(), 0);
  for (int sense = 0; sense < shape.senses; ++sense) hold.genes[shape.High(0, sense)] = kGeneMax;
  const Skeleton bones(figure);
  for (int joint = 0; joint < shape.joints; ++joint) {
    const auto& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    const float share =
        (target_rad[static_cast<std::size_t>(joint)] - limb.min_rad) / (limb.max_rad - limb.min_rad);
    hold.genes[shape.Target(0, joint)] = static_cast<Gene>(std::lround(share * 65535.0f));
  }
  return hold;
}

Controller RandomController(const Figure& figure, const SenseSpec& senses, std::uint64_t seed) {
  RandomStream random(seed, 5, 0);
  const BankShape shape(10, senses.kind, CountPorts(figure.HasSprings() ? kSpringModel : 1, figure));
  return {"random", ControllerKind::kRules, senses, 10, RandomGenome(shape, senses, Variation{}, random)};
}

Motion MotionOf(const Figure& figure, const Environment& environment, const StartState& start,
                std::span<const Push> pushes, std::span<const Controller> controllers,
                std::span<const Clip> clips, int steps, float step_s) {
  return Motion(Script{figure, environment, start, pushes, controllers, clips, steps, step_s});
}

std::vector<std::string> GoldenMotions() { return DocumentsIn("tests/golden/motions"); }

std::vector<std::string> GoldenLimitedMotions() { return DocumentsIn("tests/golden/limited"); }

std::vector<std::string> GoldenSpringMotions() { return DocumentsIn("tests/golden/springs"); }

std::vector<std::string> ShippedDocuments() {
  std::vector<std::string> names = DocumentsIn("examples");
  for (std::string& name : GalleryDocuments()) names.push_back(std::move(name));
  for (std::string& name : LessonDocuments()) names.push_back(std::move(name));
  return names;
}

std::vector<std::string> GalleryDocuments() { return DocumentsIn("examples/gallery"); }

std::vector<std::string> LessonDocuments() { return DocumentsIn("examples/lessons"); }

Document StarManTravel(SenseKind senses) {
  Document document;
  document.figure = ShippedFigure("mr-star-man");
  document.senses.kind = senses;
  document.search.evaluations = 4000;
  return document;
}

Document TwoClips() {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 5), RandomController(d.figure, d.senses, 6)};
  d.timeline = {{.controller = 0, .start_step = 0}, {.controller = 1, .start_step = 230}};
  d.duration_steps = 530;
  return d;
}

}  // namespace gaitsmith::test
