// SPDX-License-Identifier: MIT
// Any figure, controller and start on any drawn ground: until a guard makes the motion void no rod and no
// node is deep in the ground, and all numbers are finite; the motion has the same bits for every lane count.
// Input bytes: one that selects how rough the world is and whether the figure is of springs, one with the
// number of corners, four for each corner, then genes of 16 bits. What breaks a law is also written as a
// document, into the file that GAITSMITH_FIND names.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/document/json.h"
#include "tests/adversary/genes_as_document.h"
#include "tests/ground_depth.h"
#include "tests/physics_laws.h"

namespace {

/// Limbs are lifted out of the ground as long as they are not deeper than a guard allows, and a step may
/// leave a little of that. Nodes stop at the ground.
constexpr double kDeepestRod = 0.02, kDeepestNode = 0.001;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  using namespace gaitsmith::test;
  if (size < 12) return 0;
  const Scope scope = data[0] % 4 == 0 ? Scope::kAny : data[0] % 4 == 1 ? Scope::kOrdinary : Scope::kGait;
  const std::size_t corners = 1 + data[1] % kMaxCorners;
  std::vector<Corner> ground;
  float x = -4.0f;
  std::size_t at = 2;
  for (; ground.size() < corners && at + 4 <= size; at += 4) {
    // A tenth of the faces are vertical.
    if (data[at] % 10 != 0 || ground.empty()) x += 0.01f + 0.01f * static_cast<float>(data[at + 1]);
    ground.push_back({x, 0.0001f * static_cast<float>((data[at + 2] << 8 | data[at + 3]) - 32768)});
  }
  std::vector<Gene> genes;
  for (; at + 2 <= size && genes.size() < kDocumentGenes; at += 2)
    genes.push_back(static_cast<Gene>(data[at] << 8 | data[at + 1]));
  if (genes.empty()) return 0;
  const bool still = data[0] / 4 % 4 == 0;
  const bool springs = data[0] / 16 % 2 == 1;
  Document document = DocumentOf(scope, springs ? 3 : 2, still, genes);
  document.environment.ground = ground;
  if (!Validate(document)) return 0;
  const Motion motion = Simulate(document);
  const Terrain terrain(document.environment.ground);
  // Every fourth frame, because looking takes longer than simulating. What fell through the ground stays
  // there.
  for (int frame = 0; frame < motion.Frames() && !motion.TermsAt(frame).broke_physics; frame += 4) {
    const Motion::Frame& f = motion.At(frame);
    const double sum = f.x_m + f.turn_rad + static_cast<double>(f.y_m + f.velocity_x_mps + f.velocity_y_mps);
    const double depth = std::isfinite(sum) ? DepthOf(terrain, motion, frame) : 1e9;
    if (depth <= (springs ? kDeepestNode : kDeepestRod)) continue;
    std::fprintf(stderr, "frame %d: depth %g m\n", frame, depth);
    if (const char* find = std::getenv("GAITSMITH_FIND")) std::ofstream(find) << EncodeJson(document);
    std::abort();
  }
  if (still ? Simulate(document).Hash() != motion.Hash() : DifferingBits(document, motion) > 0) std::abort();
  return 0;
}
