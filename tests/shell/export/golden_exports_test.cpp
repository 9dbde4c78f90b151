// SPDX-License-Identifier: MIT
// Pins: the bytes of exported files, so that every compiler and browser writes the same ones. Formats may
// change: then they are blessed again. To bless again: tests/golden/bless. Has caught: parts of a file in an
// order that compilers choose, and std::hypot, which rounds in its own way on each platform.
#include <array>
#include <catch_amalgamated.hpp>
#include <cstdint>
#include <cstdio>
#include <sstream>

#include "core/document/json.h"
#include "core/gait/document_loop.h"
#include "core/physics/trajectory_hash.h"
#include "shell/export/exporters.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

// A figure without a head, one with a head and far limbs, and one of springs.
constexpr std::array kPinnedExports = {"star-man-shuffle", "gallery/horse-gallop", "gallery/table-trip"};

std::uint64_t Fnv(const std::string& text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

/// "star-man-shuffle gltf <hash of the file> <hash of its loop's file>", a line for each format.
std::string ExportedLines() {
  std::string lines;
  for (const char* name : kPinnedExports) {
    const Document document =
        DecodeJson(gaitsmith::test::ReadFile("examples/" + std::string(name) + ".json")).value();
    const Motion motion = Simulate(document);
    const Motion loop = RecordLoop(document, LoopOf(document, motion, false).value().loop, false);
    for (const ExporterRow& row : kExporters) {
      if (document.figure.HasSprings() && !row.springs) continue;
      lines.append(name).append(" ").append(row.id);
      lines += " " + HashText(Fnv(MakeFile(row, document, motion, {}).value()));
      const ExportOptions looped{.loops = true, .from_start = false};
      lines += " " + HashText(Fnv(MakeFile(row, document, loop, looped).value())) + "\n";
    }
  }
  return lines;
}

}  // namespace

TEST_CASE("golden: exported files have the same bytes everywhere", "[golden][determinism]") {
  std::istringstream pinned(gaitsmith::test::ReadFile("tests/golden/exports.txt")), own(ExportedLines());
  std::string line, expected;
  while (std::getline(own, line)) {
    REQUIRE(std::getline(pinned, expected));
    CHECK(line == expected);
  }
  CHECK_FALSE(std::getline(pinned, expected));
}

TEST_CASE("bless the exported files", "[.bless]") { std::printf("%s", ExportedLines().c_str()); }

}  // namespace gaitsmith::shell::test
