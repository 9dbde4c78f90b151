// SPDX-License-Identifier: MIT
#include "shell/stage/head_drawing.h"

#include <algorithm>
#include <cmath>

#include "shell/stage/figure_drawing.h"

namespace gaitsmith::shell {
namespace {

/// How far a round head reaches beyond its rod [m].
constexpr float kBeyond = 0.03f;
/// The least radius of an eye [points].
constexpr float kLeastEye = 1.1f;

/// Coordinates of a head: along the rod, and to its left, which is up where the rod points right (in a
/// mirrored figure to its right).
class HeadFrame {
 public:
  HeadFrame(const HeadPlace& place, float crown)
      : place_(place),
        crown_(crown),
        length_(std::hypot(place.tip.x - place.neck.x, place.tip.y - place.neck.y)) {
    if (length_ > 0.0f)
      along_ = {(place.tip.x - place.neck.x) / length_, (place.tip.y - place.neck.y) / length_};
  }
  /// @param share of the rod from its start @param forwards, left [m] from there
  [[nodiscard]] ImVec2 At(float share, float forwards = 0.0f, float left = 0.0f) const {
    const float x = share * length_ + forwards * place_.scale, y = crown_ * left * place_.scale;
    return {place_.neck.x + along_.x * x + along_.y * y, place_.neck.y + along_.y * x - along_.x * y};
  }
  [[nodiscard]] float Points(float metres) const { return metres * place_.scale + place_.grow; }

 private:
  const HeadPlace& place_;
  float crown_;
  float length_;
  ImVec2 along_{1.0f, 0.0f};
};

}  // namespace

void DrawHead(ImDrawList* list, const FigureLook& look, const HeadPlace& place, ImU32 colour) {
  const HeadFrame frame(place, look.crown);
  const FigureLook::Limb& limb = look.limbs[static_cast<std::size_t>(look.head_rod)];
  const auto piece = [&](ImVec2 from, float from_m, ImVec2 to, float to_m) {
    DrawLimb(list, from, frame.Points(from_m), to, frame.Points(to_m), colour);
  };
  switch (look.head) {
    case Head::kBall: {
      const ImVec2 centre = frame.At(1.0f, kBeyond - look.head_m);
      piece(place.neck, limb.start_m, centre, 0.9f * limb.start_m);
      list->AddCircleFilled(centre, frame.Points(look.head_m), colour);
      break;
    }
    case Head::kBeak:
      piece(place.neck, 0.068f, frame.At(0.38f), 0.05f);
      piece(frame.At(0.3f), 0.042f, place.tip, 0.014f);
      break;
    case Head::kFrog:
      piece(place.neck, 0.1f, frame.At(1.0f, -0.05f), 0.075f);
      list->AddCircleFilled(frame.At(0.3f, 0.0f, 0.085f), frame.Points(0.062f), colour);
      break;
    case Head::kMuzzle:
      piece(place.neck, 0.13f, place.tip, 0.085f);
      piece(place.tip, 0.095f, frame.At(1.0f, -0.013f, -0.27f), 0.055f);                  // muzzle
      piece(frame.At(1.0f, 0.03f, 0.04f), 0.032f, frame.At(1.0f, 0.15f, 0.04f), 0.012f);  // ear
      break;
    case Head::kSnout:
      piece(place.neck, 0.075f, place.tip, 0.035f);
      break;
    default:
      piece(place.neck, limb.start_m, place.tip, limb.end_m);
      break;
  }
}

void DrawEye(ImDrawList* list, const FigureLook& look, const HeadPlace& place, ImU32 colour) {
  const HeadFrame frame(place, look.crown);
  const auto eye = [&](ImVec2 at, float radius_m) {
    list->AddCircleFilled(at, std::max(kLeastEye, radius_m * place.scale), colour);
  };
  switch (look.head) {
    case Head::kBall:
      eye(frame.At(1.0f, kBeyond - 0.88f * look.head_m, -0.42f * look.head_m), 0.19f * look.head_m);
      break;
    case Head::kBeak:
      eye(frame.At(0.0f, 0.022f, 0.014f), 0.021f);
      break;
    case Head::kFrog:
      eye(frame.At(0.3f, 0.0f, 0.085f), 0.03f);
      break;
    case Head::kMuzzle:
      eye(frame.At(1.0f, 0.012f, -0.06f), 0.024f);
      break;
    case Head::kSnout:
      eye(frame.At(0.35f, 0.0f, 0.02f), 0.022f);
      break;
    default:
      eye(frame.At(1.0f, -0.055f, 0.03f), 0.027f);
      break;
  }
}

}  // namespace gaitsmith::shell
