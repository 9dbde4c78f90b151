// SPDX-License-Identifier: MIT
#include "shell/body/body_parts.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::shell {
namespace {

/// How far a round head reaches beyond its rod [m].
constexpr float kBeyond = 0.03f;
/// Thickness of a muscle at its ends, in its own, and the most that it swells, in times of it.
constexpr float kSinew = 0.55f, kMostSwollen = 3.0f;

/// std::hypot rounds in its own way on each platform, and exported files have this in them.
float Length(float x, float y) { return std::sqrt(x * x + y * y); }

/// Coordinates of a head: along its rod, and to the left of it, which is up where the rod points right (in
/// a mirrored figure to the right).
class HeadFrame {
 public:
  HeadFrame(BodyPoint neck, BodyPoint tip, float crown)
      : neck_(neck), crown_(crown), length_(Length(tip.x - neck.x, tip.y - neck.y)) {
    if (length_ > 0.0f) along_ = {(tip.x - neck.x) / length_, (tip.y - neck.y) / length_};
  }
  /// @param share of the rod from its start @param forwards, left [m] from there
  [[nodiscard]] BodyPoint At(float share, float forwards = 0.0f, float left = 0.0f) const {
    const float x = share * length_ + forwards, y = crown_ * left;
    return {neck_.x + along_.x * x - along_.y * y, neck_.y + along_.y * x + along_.x * y};
  }

 private:
  BodyPoint neck_;
  float crown_;
  float length_;
  BodyPoint along_{1.0f, 0.0f};
};

BodyPart Disc(BodyPoint at, float radius_m) {
  return {.from = at, .to = at, .from_m = radius_m, .to_m = radius_m};
}

BodyPoint At(std::span<const BodyPoint> endpoints, int endpoint) {
  return endpoints[static_cast<std::size_t>(endpoint)];
}

HeadFrame FrameOf(const FigureLook& look, std::span<const BodyPoint> endpoints) {
  const FigureLook::Limb& limb = look.limbs[static_cast<std::size_t>(look.head_rod)];
  return {At(endpoints, limb.from), At(endpoints, limb.to), look.crown};
}

/// Springs, over them muscles, and nodes. A muscle keeps its area: the shorter it is, the more it swells.
std::vector<BodyPart> SpringParts(const FigureLook& look, std::span<const BodyPoint> endpoints) {
  std::vector<BodyPart> parts;
  parts.reserve(look.limbs.size() + look.knobs.size());
  for (const bool muscles : {false, true}) {
    for (std::size_t i = 0; i < look.limbs.size(); ++i) {
      const FigureLook::Limb& limb = look.limbs[i];
      if ((limb.drawn_m > 0.0f) != muscles) continue;
      const BodyPoint from = At(endpoints, limb.from), to = At(endpoints, limb.to);
      BodyPart part{.from = from,
                    .to = to,
                    .from_m = limb.start_m,
                    .to_m = limb.end_m,
                    .far = !muscles,  // paler
                    .rod = static_cast<int>(i)};
      if (muscles) {
        const float length = Length(to.x - from.x, to.y - from.y);
        part.from_m = part.to_m = kSinew * limb.start_m;
        part.belly_m = limb.start_m * std::min(limb.drawn_m / std::max(length, 1e-6f), kMostSwollen);
      }
      parts.push_back(part);
    }
  }
  for (std::size_t node = 0; node < look.knobs.size(); ++node)
    parts.push_back(Disc(endpoints[node], look.knobs[node]));
  return parts;
}

void AddHead(std::vector<BodyPart>& parts, const FigureLook& look, const HeadFrame& frame) {
  const FigureLook::Limb& limb = look.limbs[static_cast<std::size_t>(look.head_rod)];
  const BodyPoint neck = frame.At(0.0f), tip = frame.At(1.0f);
  const auto piece = [&](BodyPoint from, float from_m, BodyPoint to, float to_m) {
    parts.push_back({.from = from, .to = to, .from_m = from_m, .to_m = to_m});
  };
  switch (look.head) {
    case Head::kBall: {
      const BodyPoint centre = frame.At(1.0f, kBeyond - look.head_m);
      piece(neck, limb.start_m, centre, 0.9f * limb.start_m);
      parts.push_back(Disc(centre, look.head_m));
      break;
    }
    case Head::kBeak:
      piece(neck, 0.068f, frame.At(0.38f), 0.05f);
      piece(frame.At(0.3f), 0.042f, tip, 0.014f);
      break;
    case Head::kFrog:
      piece(neck, 0.1f, frame.At(1.0f, -0.05f), 0.075f);
      parts.push_back(Disc(frame.At(0.3f, 0.0f, 0.085f), 0.062f));
      break;
    case Head::kMuzzle:
      piece(neck, 0.13f, tip, 0.085f);
      piece(tip, 0.095f, frame.At(1.0f, -0.013f, -0.27f), 0.055f);                        // muzzle
      piece(frame.At(1.0f, 0.03f, 0.04f), 0.032f, frame.At(1.0f, 0.15f, 0.04f), 0.012f);  // ear
      break;
    case Head::kSnout:
      piece(neck, 0.075f, tip, 0.035f);
      break;
    default:
      piece(neck, limb.start_m, tip, limb.end_m);
      break;
  }
}

}  // namespace

std::vector<BodyPart> BodyPartsOf(const FigureLook& look, std::span<const BodyPoint> endpoints) {
  using Side = FigureLook::Side;
  if (!look.knobs.empty()) return SpringParts(look, endpoints);
  std::vector<BodyPart> parts;
  const auto add_limbs = [&](Side side) {
    for (std::size_t rod = 1; rod < look.limbs.size(); ++rod) {
      const FigureLook::Limb& limb = look.limbs[rod];
      if (limb.side != side || static_cast<int>(rod) == look.head_rod) continue;
      parts.push_back({.from = At(endpoints, limb.from),
                       .to = At(endpoints, limb.to),
                       .from_m = limb.start_m,
                       .to_m = limb.end_m,
                       .far = side == Side::kFar,
                       .rod = static_cast<int>(rod)});
    }
  };
  add_limbs(Side::kFar);
  add_limbs(Side::kMiddle);
  const FigureLook::Limb& root = look.limbs[0];
  if (look.head_rod != 0) {
    parts.push_back({.from = endpoints[0],
                     .to = endpoints[1],
                     .from_m = root.start_m,
                     .to_m = root.end_m,
                     .belly_m = look.belly_m});
  }
  if (look.hub_m > 0.0f) parts.push_back(Disc(endpoints[0], look.hub_m));
  add_limbs(Side::kNear);
  const std::size_t headless = parts.size();
  if (look.head_rod >= 0) AddHead(parts, look, FrameOf(look, endpoints));
  for (std::size_t part = headless; part < parts.size(); ++part) parts[part].rod = look.head_rod;
  return parts;
}

std::optional<BodyEye> EyeOf(const FigureLook& look, std::span<const BodyPoint> endpoints) {
  if (look.head_rod < 0) return std::nullopt;
  const HeadFrame frame = FrameOf(look, endpoints);
  switch (look.head) {
    case Head::kBall:
      return BodyEye{frame.At(1.0f, kBeyond - 0.88f * look.head_m, -0.42f * look.head_m),
                     0.19f * look.head_m};
    case Head::kBeak:
      return BodyEye{frame.At(0.0f, 0.022f, 0.014f), 0.021f};
    case Head::kFrog:
      return BodyEye{frame.At(0.3f, 0.0f, 0.085f), 0.03f};
    case Head::kMuzzle:
      return BodyEye{frame.At(1.0f, 0.012f, -0.06f), 0.024f};
    case Head::kSnout:
      return BodyEye{frame.At(0.35f, 0.0f, 0.02f), 0.022f};
    default:
      return BodyEye{frame.At(1.0f, -0.055f, 0.03f), 0.027f};
  }
}

}  // namespace gaitsmith::shell
