// SPDX-License-Identifier: MIT
// Rods carry their outlines with them. Springs are drawn anew in every frame.
#include "shell/export/moving_outlines.h"

#include "shell/export/moving_bones.h"

namespace gaitsmith::shell {

MovingOutlines::MovingOutlines(const Figure& figure, const Motion& motion)
    : motion_(motion), shapes_(BoneShapesOf(figure)) {
  if (figure.HasSprings()) look_ = LookOf(figure);
}

std::vector<MovingOutlines::Filled> MovingOutlines::At(int frame) const {
  std::vector<Filled> filled;
  if (shapes_.empty()) {
    std::vector<BodyPoint> nodes;
    nodes.reserve(look_.knobs.size());
    for (std::size_t node = 0; node < look_.knobs.size(); ++node) {
      const Motion::Point point = motion_.Endpoint(frame, static_cast<int>(node));
      nodes.push_back({point.x, point.y});
    }
    const Motion::Frame& at = motion_.At(frame);
    const std::vector<BodyPart> parts = BodyPartsOf(look_, nodes);
    filled.reserve(parts.size());
    for (const BodyPart& part : parts) {
      auto& outline = filled.emplace_back(&ColourOf(part), OutlineOf(part)).outline_m;
      for (auto& [x, y] : outline) {
        x += at.x_m;
        y += static_cast<double>(at.y_m);
      }
    }
    return filled;
  }
  const MovingBones bones(motion_);
  filled.reserve(shapes_.size());
  for (const BoneShape& shape : shapes_) {
    const MovingBones::Place place = bones.PlaceOf(frame, shape.bone);
    auto& outline = filled.emplace_back(shape.colour).outline_m;
    outline.reserve(shape.outline_m.size());
    for (const auto& point : shape.outline_m) outline.push_back(place.Of(point));
  }
  return filled;
}

}  // namespace gaitsmith::shell
