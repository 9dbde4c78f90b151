// SPDX-License-Identifier: MIT
#include "core/physics/symmetry.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/physics/pose.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {

namespace {

// Tolerance of lengths, masses and springs as a share, of limits in rad, of positions as a share of the
// longest rod.
constexpr float kTolerance = 1e-3f;

bool Near(float a, float b, float scale) {
  const float off = a > b ? a - b : b - a;
  return off <= kTolerance * scale;
}

struct LaidOut {
  explicit LaidOut(const Figure& figure) : skeleton(figure) {
    Pose<1> pose;
    PoseFigure<1>(skeleton, {}, pose);
    const SineCosine root = SinCos(skeleton.start_angle_rad);
    for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
      x[k] = root.cosine * pose.endpoint_x[k][0] - root.sine * pose.endpoint_y[k][0];
      y[k] = root.sine * pose.endpoint_x[k][0] + root.cosine * pose.endpoint_y[k][0];
    }
  }
  Skeleton skeleton;
  std::array<float, kMaxEndpoints> x{}, y{};  // from the centre of mass
};

std::unexpected<Error> Lopsided() {
  return Fail(ErrorCode::kStructure, "", "the figure is not its own mirror image as it is drawn");
}

// The endpoint at the mirror image of this one, or -1 if there is none.
int ImageOfEndpoint(const LaidOut& drawn, int endpoint) {
  const auto k = static_cast<std::size_t>(endpoint);
  for (int other = 0; other < drawn.skeleton.endpoints; ++other) {
    const auto o = static_cast<std::size_t>(other);
    const float scale = drawn.skeleton.longest_rod_m;
    if (Near(drawn.x[o], -drawn.x[k], scale) && Near(drawn.y[o], drawn.y[k], scale)) return other;
  }
  return -1;
}

// The rod of the same length and mass between the images of a rod's ends, or -1 if there is none.
int ImageOfRod(const Skeleton& skeleton, const Symmetry& symmetry, int rod) {
  const Skeleton::Limb& limb = skeleton.limbs[static_cast<std::size_t>(rod)];
  const int start = symmetry.endpoint[static_cast<std::size_t>(limb.start)];
  const int end = symmetry.endpoint[static_cast<std::size_t>(rod) + 1];
  for (int other = 0; other < skeleton.rods; ++other) {
    const Skeleton::Limb& image = skeleton.limbs[static_cast<std::size_t>(other)];
    const bool along = image.start == start && other + 1 == end;
    const bool against = image.start == end && other + 1 == start;
    if ((along || against) && Near(image.length_m, limb.length_m, limb.length_m) &&
        Near(image.mass_kg, limb.mass_kg, limb.mass_kg))
      return other;
  }
  return -1;
}

bool Alike(const Spring& a, const Spring& b) {
  return a.IsMuscle() == b.IsMuscle() && Near(a.stiffness_npm, b.stiffness_npm, a.stiffness_npm) &&
         Near(a.damping_nspm, b.damping_nspm, a.damping_nspm) && Near(a.rest, b.rest, 1.0f) &&
         Near(a.min_rest, b.min_rest, 1.0f) && Near(a.max_rest, b.max_rest, 1.0f);
}

/// The node at the mirror image of this one, of the same mass, or -1 if there is none.
int ImageOfNode(const Figure& figure, float middle_m, std::size_t node) {
  const Node& here = figure.nodes[node];
  const float size_m = SizeOf(figure);
  for (std::size_t other = 0; other < figure.nodes.size(); ++other) {
    const Node& there = figure.nodes[other];
    if (Near(there.x_m - middle_m, middle_m - here.x_m, size_m) && Near(there.y_m, here.y_m, size_m) &&
        Near(there.mass_kg, here.mass_kg, here.mass_kg))
      return static_cast<int>(other);
  }
  return -1;
}

Result<Symmetry> SymmetryOfSprings(const Figure& figure) {
  const auto [left, right] = std::ranges::minmax(figure.nodes, {}, &Node::x_m);
  const float middle_m = 0.5f * (left.x_m + right.x_m);
  Symmetry symmetry;
  std::array<bool, kMaxPoints> taken{};
  for (std::size_t node = 0; node < figure.nodes.size(); ++node) {
    const int image = ImageOfNode(figure, middle_m, node);
    if (image < 0 || taken[static_cast<std::size_t>(image)]) return Lopsided();
    taken[static_cast<std::size_t>(image)] = true;
    symmetry.endpoint[node] = image;
  }
  std::vector<int> muscle(figure.springs.size(), -1);  // its number, of each spring
  int muscles = 0;
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    if (figure.springs[i].IsMuscle()) muscle[i] = muscles++;
  }
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    const Spring& spring = figure.springs[i];
    const auto ends = std::minmax(symmetry.endpoint[static_cast<std::size_t>(spring.from)],
                                  symmetry.endpoint[static_cast<std::size_t>(spring.to)]);
    const auto image = std::ranges::find_if(figure.springs, [&](const Spring& other) {
      return std::minmax(other.from, other.to) == ends && Alike(spring, other);
    });
    if (image == figure.springs.end()) return Lopsided();
    if (muscle[i] >= 0) {
      symmetry.joint[static_cast<std::size_t>(muscle[i])] =
          muscle[static_cast<std::size_t>(image - figure.springs.begin())];
    }
  }
  return symmetry;
}

}  // namespace

Result<Symmetry> SymmetryOf(const Figure& figure) {
  if (figure.HasSprings()) return SymmetryOfSprings(figure);
  const LaidOut drawn(figure);
  const Skeleton& skeleton = drawn.skeleton;
  Symmetry symmetry;
  std::array<bool, kMaxEndpoints> taken{};
  for (int k = 0; k < skeleton.endpoints; ++k) {
    const int image = ImageOfEndpoint(drawn, k);
    if (image < 0 || taken[static_cast<std::size_t>(image)]) return Lopsided();
    taken[static_cast<std::size_t>(image)] = true;
    symmetry.endpoint[static_cast<std::size_t>(k)] = image;
  }
  std::array<int, kMaxRods> rod_image{};
  for (int rod = 0; rod < skeleton.rods; ++rod) {
    rod_image[static_cast<std::size_t>(rod)] = ImageOfRod(skeleton, symmetry, rod);
    if (rod_image[static_cast<std::size_t>(rod)] < 0) return Lopsided();
  }
  for (int joint = 0; joint < skeleton.joints; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const Skeleton::Limb& limb = skeleton.limbs[j + 1];
    const int child = rod_image[j + 1];
    const int parent = rod_image[static_cast<std::size_t>(limb.parent)];
    // Of two joined rods the images may have swapped the roles of parent and child. The angle between them is
    // then reversed twice and keeps its sign.
    const bool kept = skeleton.limbs[static_cast<std::size_t>(child)].parent == parent;
    const bool swapped = skeleton.limbs[static_cast<std::size_t>(parent)].parent == child;
    if (!kept && !swapped) {
      return Fail(
          ErrorCode::kStructure, "",
          "the figure's mirror image is connected differently: draw the figure from a rod in its middle");
    }
    const int image = kept ? child - 1 : parent - 1;
    const Skeleton::Limb& other = skeleton.limbs[static_cast<std::size_t>(image) + 1];
    const float least = kept ? -other.max_rad : other.min_rad;
    const float most = kept ? -other.min_rad : other.max_rad;
    if (!Near(limb.min_rad, least, 1.0f) || !Near(limb.max_rad, most, 1.0f)) {
      return Fail(ErrorCode::kStructure, "",
                  "joints " + std::to_string(joint + 1) + " and " + std::to_string(image + 1) +
                      " have limits that are not each other's mirror image");
    }
    symmetry.joint[j] = image;
    symmetry.reversed[j] = kept;
  }
  return symmetry;
}

}  // namespace gaitsmith
