// SPDX-License-Identifier: MIT
// The scene's JSON, with its buffer embedded as base64.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "core/document/json_value.h"
#include "core/numeric/scalar_math.h"
#include "core/world/terrain.h"
#include "shell/export/exporters.h"
#include "shell/export/moving_bones.h"

namespace gaitsmith::shell {

namespace {

constexpr int kStepsPerKey = 2;
// A capsule is a sphere with its halves moved apart along x.
constexpr int kRings = 8;  // circles of latitude, even, without the poles
constexpr int kSides = 12;
constexpr int kVertices = kRings * kSides + 2;

enum ComponentType { kUnsignedShort = 5123, kFloat = 5126 };

std::string Real(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(static_cast<float>(value)));
  return text;
}

/// A point of the unit sphere.
struct BallPoint {
  std::array<float, 3> at;
  bool far;  // on the half at the rod's far end
};

std::vector<BallPoint> Ball() {
  std::vector<BallPoint> points = {{{-1.0f, 0.0f, 0.0f}, false}};
  for (int ring = 0; ring < kRings; ++ring) {
    // The two middle rings are both the equator, with the cylinder between them.
    const bool far = 2 * ring >= kRings;
    const int latitude = far ? ring : ring + 1;
    const SineCosine up = SinCos(static_cast<float>(kPi * latitude / kRings));
    for (int side = 0; side < kSides; ++side) {
      const SineCosine round = SinCos(static_cast<float>(2.0 * kPi * side / kSides));
      points.push_back(
          {{2 * latitude == kRings ? 0.0f : -up.cosine, up.sine * round.cosine, up.sine * round.sine}, far});
    }
  }
  points.push_back({{1.0f, 0.0f, 0.0f}, true});
  return points;
}

std::vector<std::uint16_t> BallFaces() {
  std::vector<std::uint16_t> corners;
  const auto face = [&](int a, int b, int c) {
    for (const int corner : {a, b, c}) corners.push_back(static_cast<std::uint16_t>(corner));
  };
  for (int side = 0; side < kSides; ++side) {
    const int next = (side + 1) % kSides;
    face(0, 1 + next, 1 + side);
    for (int ring = 0; ring + 1 < kRings; ++ring) {
      const int a = 1 + ring * kSides + side, b = 1 + ring * kSides + next;
      face(a, b, b + kSides);
      face(a, b + kSides, a + kSides);
    }
    const int last = 1 + (kRings - 1) * kSides;
    face(last + side, last + next, kVertices - 1);
  }
  return corners;
}

std::string Base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kLetters[three >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

/// Collects lists of numbers. Each list becomes an accessor with a separate buffer view.
class GltfBuffer {
 public:
  /// @param type "SCALAR", "VEC3" or "VEC4" @param width numbers of each element
  /// @param target 34962 for a mesh's vertices, 0 for an animation's numbers
  /// @return its index
  int Floats(const std::vector<float>& numbers, const char* type, std::size_t width, int target,
             bool bounds) {
    const std::size_t offset = bytes_.size();
    for (const float number : numbers) {
      const auto bits = std::bit_cast<std::uint32_t>(number);
      for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
    std::string range;
    if (bounds) {
      for (const bool most : {false, true}) {
        range += most ? ",\"max\":[" : ",\"min\":[";
        for (std::size_t k = 0; k < width; ++k) {
          float extreme = numbers[k];
          for (std::size_t i = k; i < numbers.size(); i += width)
            extreme = most ? std::max(extreme, numbers[i]) : std::min(extreme, numbers[i]);
          range += (k > 0 ? "," : "") + Real(static_cast<double>(extreme));
        }
        range += "]";
      }
    }
    return Describe(offset, kFloat, numbers.size() / width, type, target, range);
  }
  int Indices(const std::vector<std::uint16_t>& numbers) {
    const std::size_t offset = bytes_.size();
    for (const std::uint16_t number : numbers) {
      bytes_.push_back(static_cast<std::uint8_t>(number));
      bytes_.push_back(static_cast<std::uint8_t>(number >> 8));
    }
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);  // floats must be aligned to 4 bytes
    return Describe(offset, kUnsignedShort, numbers.size(), "SCALAR", 34963, "", 2 * numbers.size());
  }
  [[nodiscard]] std::string Json() const {
    return "\"accessors\":[" + accessors_ + "],\n\"bufferViews\":[" + views_ +
           "],\n\"buffers\":[{\"byteLength\":" + std::to_string(bytes_.size()) +
           ",\"uri\":\"data:application/octet-stream;base64," + Base64(bytes_) + "\"}]";
  }

 private:
  int Describe(std::size_t offset, ComponentType component, std::size_t count, const char* type, int target,
               const std::string& range, std::size_t size = 0) {
    const std::string comma = accessor_count_ > 0 ? ",\n" : "";
    views_ += comma + "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
              ",\"byteLength\":" + std::to_string(size > 0 ? size : bytes_.size() - offset) +
              (target != 0 ? ",\"target\":" + std::to_string(target) : "") + "}";
    accessors_ += comma + "{\"bufferView\":" + std::to_string(accessor_count_) +
                  ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(count) +
                  ",\"type\":\"" + type + "\"" + range + "}";
    return accessor_count_++;
  }

  std::vector<std::uint8_t> bytes_;
  std::string accessors_, views_;
  int accessor_count_ = 0;
};

/// The quaternion of a rotation about z. Quaternions are periodic in two turns, so a continuous angle beyond
/// one turn yields continuous quaternions.
std::array<float, 4> AboutZ(double angle_rad) {
  constexpr double kTwoTurns = 4.0 * kPi;
  if (!std::isfinite(angle_rad)) return {0.0f, 0.0f, 0.0f, 1.0f};  // of a motion that fails
  const double whole = std::trunc(angle_rad / kTwoTurns);
  const SineCosine half = SinCos(static_cast<float>(0.5 * (angle_rad - kTwoTurns * whole)));
  return {0.0f, 0.0f, half.sine, half.cosine};
}

std::string RotationJson(double angle_rad) {
  const auto q = AboutZ(angle_rad);
  return "\"rotation\":[0,0," + Real(static_cast<double>(q[2])) + "," + Real(static_cast<double>(q[3])) + "]";
}

class SkeletonScene {
 public:
  SkeletonScene(const Document& document, const Motion& motion)
      : document_(document),
        motion_(motion),
        bones_(motion.Bones()),
        moving_(motion),
        radius_m_(static_cast<float>(0.5 * moving_.ThicknessM())) {}

  std::string Whole() {
    const std::string meshes = Meshes();
    const std::string animation = Animation();
    return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Gaitsmith\"},\n\"scene\":0,\n"
           "\"scenes\":[{\"name\":" +
           QuoteJson(document_.title) + ",\"nodes\":[0]}],\n\"nodes\":[" + Nodes() + "],\n\"meshes\":[" +
           meshes +
           "],\n\"materials\":[{\"name\":\"rods\",\"pbrMetallicRoughness\":{\"baseColorFactor\":"
           "[0.0126,0.0203,0.0331,1],\"metallicFactor\":0,\"roughnessFactor\":0.6}}" +
           (HasGround() ? ",{\"name\":\"ground\",\"doubleSided\":true,\"pbrMetallicRoughness\":"
                          "{\"baseColorFactor\":[0.863,0.83,0.768,1],\"metallicFactor\":0}}"
                        : "") +
           "],\n\"animations\":[" + animation + "],\n" + buffer_.Json() + "}\n";
  }

 private:
  [[nodiscard]] const Skeleton::Limb& Limb(int rod) const {
    return bones_.limbs[static_cast<std::size_t>(rod)];
  }

  [[nodiscard]] std::string Nodes() const {
    const double slope = static_cast<double>(document_.environment.slope_rad);
    std::string nodes = "{\"name\":" + QuoteJson(document_.figure.name) + ",\"children\":[1" +
                        (HasGround() ? "," + std::to_string(bones_.rods + 1) : "") + "]" +
                        (slope != 0.0 ? "," + RotationJson(slope) : "") + "}";
    for (int rod = 0; rod < bones_.rods; ++rod) {
      std::string children;
      for (int other = rod + 1; other < bones_.rods; ++other) {
        if (Limb(other).parent == rod) children += (children.empty() ? "" : ",") + std::to_string(other + 1);
      }
      const auto at = rod == 0 ? RootAt(0) : JointAt(rod);
      nodes += ",\n{\"name\":\"" + moving_.NameOf(rod) + "\",\"mesh\":" + std::to_string(rod) +
               ",\"translation\":[" + Real(static_cast<double>(at[0])) + "," +
               Real(static_cast<double>(at[1])) + ",0]," + RotationJson(AngleAt(0, rod)) +
               (children.empty() ? "" : ",\"children\":[" + children + "]") + "}";
    }
    if (HasGround()) nodes += ",\n{\"name\":\"ground\",\"mesh\":" + std::to_string(bones_.rods) + "}";
    return nodes;
  }

  /// A rod's joint on its parent, in coordinates of the parent, which lies along x from its start.
  [[nodiscard]] std::array<float, 3> JointAt(int rod) const {
    return {static_cast<float>(moving_.JointM(rod)), 0.0f, 0.0f};
  }
  [[nodiscard]] std::array<float, 3> RootAt(int frame) const {
    const auto start = moving_.Start(frame);
    return {static_cast<float>(start[0]), static_cast<float>(start[1]), 0.0f};
  }
  [[nodiscard]] double AngleAt(int frame, int rod) const { return moving_.AngleRad(frame, rod); }

  std::string Meshes() {
    constexpr int kArrayBuffer = 34962;
    const std::vector<BallPoint> ball = Ball();
    std::vector<float> normals;
    for (const BallPoint& point : ball) normals.insert(normals.end(), point.at.begin(), point.at.end());
    const int normal = buffer_.Floats(normals, "VEC3", 3, kArrayBuffer, false);
    const int indices = buffer_.Indices(BallFaces());
    std::string meshes;
    for (int rod = 0; rod < bones_.rods; ++rod) {
      std::vector<float> places;
      for (const BallPoint& point : ball) {
        places.push_back(radius_m_ * point.at[0] + (point.far ? Limb(rod).length_m : 0.0f));
        places.push_back(radius_m_ * point.at[1]);
        places.push_back(radius_m_ * point.at[2]);
      }
      const int position = buffer_.Floats(places, "VEC3", 3, kArrayBuffer, true);
      meshes += std::string(rod > 0 ? ",\n" : "") +
                "{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(position) +
                ",\"NORMAL\":" + std::to_string(normal) + "},\"indices\":" + std::to_string(indices) +
                ",\"material\":0}]}";
    }
    return meshes + GroundMesh();
  }

  [[nodiscard]] bool HasGround() const { return !document_.environment.ground.empty(); }

  /// A drawn ground as a strip, with a flat piece for each face. Empty for level ground.
  std::string GroundMesh() {
    if (!HasGround()) return "";
    constexpr double kBeyond = 10.0;  // that the strip goes on level at both ends [m]
    constexpr float kHalfWidth = 1.0f;
    const std::vector<Corner>& ground = document_.environment.ground;
    const double left = static_cast<double>(ground.front().x_m) - kBeyond;
    const double right = static_cast<double>(ground.back().x_m) + kBeyond;
    std::vector<float> places, normals;
    std::vector<std::uint16_t> indices;
    const Terrain terrain(ground);
    for (const Terrain::Face& face : terrain.Faces()) {
      const double from_x = std::max(face.x, left);
      const double to_x = std::min(face.x + face.length * face.ux, right);
      const auto first = static_cast<int>(places.size() / 3);
      for (const auto& [x, y] :
           {std::pair(from_x, face.y), std::pair(to_x, face.y + face.length * face.uy)}) {
        for (const float z : {-kHalfWidth, kHalfWidth}) {
          places.insert(places.end(), {static_cast<float>(x), static_cast<float>(y), z});
          normals.insert(normals.end(), {static_cast<float>(-face.uy), static_cast<float>(face.ux), 0.0f});
        }
      }
      for (const int corner : {0, 1, 2, 2, 1, 3})
        indices.push_back(static_cast<std::uint16_t>(first + corner));
    }
    constexpr int kArrayBuffer = 34962;
    const int position = buffer_.Floats(places, "VEC3", 3, kArrayBuffer, true);
    const int normal = buffer_.Floats(normals, "VEC3", 3, kArrayBuffer, false);
    return ",\n{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(position) +
           ",\"NORMAL\":" + std::to_string(normal) +
           "},\"indices\":" + std::to_string(buffer_.Indices(indices)) + ",\"material\":1}]}";
  }

  std::string Animation() {
    std::vector<int> keys;
    const int last = motion_.Frames() - 1;
    for (int frame = 0; frame < last; frame += kStepsPerKey) keys.push_back(frame);
    keys.push_back(last);
    std::vector<float> times, path;
    for (const int frame : keys) {
      times.push_back(static_cast<float>(frame * 0.01));
      const auto at = RootAt(frame);
      path.insert(path.end(), at.begin(), at.end());
    }
    const int time = buffer_.Floats(times, "SCALAR", 1, 0, true);
    std::string samplers, channels;
    const auto add = [&](int output, int node, const char* what) {
      const std::string comma = samplers.empty() ? "" : ",\n";
      channels += comma + "{\"sampler\":" + std::to_string(samplers_++) +
                  ",\"target\":{\"node\":" + std::to_string(node) + ",\"path\":\"" + what + "\"}}";
      samplers += comma + "{\"input\":" + std::to_string(time) + ",\"output\":" + std::to_string(output) +
                  ",\"interpolation\":\"LINEAR\"}";
    };
    add(buffer_.Floats(path, "VEC3", 3, 0, false), 1, "translation");
    for (int rod = 0; rod < bones_.rods; ++rod) {
      std::vector<float> turns;
      for (const int frame : keys) {
        const auto q = AboutZ(AngleAt(frame, rod));
        turns.insert(turns.end(), q.begin(), q.end());
      }
      add(buffer_.Floats(turns, "VEC4", 4, 0, false), rod + 1, "rotation");
    }
    return "{\"name\":" + QuoteJson(document_.title) + ",\"samplers\":[" + samplers + "],\n\"channels\":[" +
           channels + "]}";
  }

  const Document& document_;
  const Motion& motion_;
  const Skeleton& bones_;
  MovingBones moving_;
  float radius_m_;
  GltfBuffer buffer_;
  int samplers_ = 0;
};

}  // namespace

std::string SkeletonGltf(const Document& document, const Motion& motion) {
  return SkeletonScene(document, motion).Whole();
}

}  // namespace gaitsmith::shell
