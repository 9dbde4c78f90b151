// SPDX-License-Identifier: MIT
// A motion behind the engine's border: its frames, its ground, its figure's outline and its measures.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/archive.h"
#include "core/document/json_value.h"
#include "shell/body/body_parts.h"
#include "web/search/engine_border.h"
#include "web/search/motion_role.h"

using namespace gaitsmith;  // NOLINT: everything below is the border

MotionRole* gaitsmith::OpenMotion(Document document, Motion motion) {
  auto* role = new MotionRole{.document = std::move(document), .motion = std::move(motion)};
  for (const shell::Bar& bar : shell::BarsOf(role->motion.Bones())) role->starts.push_back(bar.from);
  role->look = shell::LookOf(role->document.figure);
  const int endpoints = role->motion.Connections().contacts;
  for (const Corner& corner : role->document.environment.ground)
    role->ground.insert(role->ground.end(), {corner.x_m, corner.y_m});
  for (int i = 0; i < role->motion.Frames(); ++i) {
    const Motion::Frame& frame = role->motion.At(i);
    const auto& timeline = role->document.timeline;
    const int clip = frame.clip;
    role->numbers.push_back(
        static_cast<float>(clip < 0 ? -1 : timeline[static_cast<std::size_t>(clip)].controller));
    role->numbers.insert(role->numbers.end(), {static_cast<float>(frame.x_m), frame.y_m});
    for (int k = 0; k < endpoints; ++k) {
      const Motion::Point point = role->motion.Endpoint(i, k);
      role->numbers.push_back(static_cast<float>(frame.x_m + static_cast<double>(point.x)));
      role->numbers.push_back(frame.y_m + point.y);
    }
  }
  return role;
}

GS_EXPORT MotionRole* gs_motion_open(std::size_t size) {
  auto document = TakeDocument(size);
  if (!document) return nullptr;
  Motion motion = Simulate(*document);
  return OpenMotion(std::move(*document), std::move(motion));
}
GS_EXPORT void gs_motion_close(MotionRole* role) { delete role; }
GS_EXPORT int gs_motion_frames(const MotionRole* role) { return role->motion.Frames(); }
/// A figure of springs has none.
GS_EXPORT int gs_motion_rods(const MotionRole* role) { return role->motion.Bones().rods; }
/// Ends of rods, or nodes.
GS_EXPORT int gs_motion_endpoints(const MotionRole* role) { return role->motion.Connections().contacts; }
/// For each rod the endpoint at its start; rod i ends at endpoint i + 1.
GS_EXPORT const int* gs_motion_starts(const MotionRole* role) { return role->starts.data(); }
/// For each frame: the active controller (-1: none), the centre of mass, every endpoint [m].
GS_EXPORT const float* gs_motion_numbers(const MotionRole* role) { return role->numbers.data(); }
/// The corners of a drawn ground from left to right, x and y of each [m]; level ground has none.
GS_EXPORT const float* gs_motion_ground(const MotionRole* role) { return role->ground.data(); }
GS_EXPORT int gs_motion_corners(const MotionRole* role) { return static_cast<int>(role->ground.size() / 2); }
/// The figure's outline in a frame: gs_motion_body_size() numbers, 8 for each part of BodyPartsOf and for its
/// eye: x, y, radius at both ends [m], how far the radius swells halfway [m], and 0 for a near part, 1 for a
/// far one, 2 for the eye.
/// @param frame clamped to the motion
GS_EXPORT const float* gs_motion_body(MotionRole* role, int frame) {
  const int shown = std::clamp(frame, 0, role->motion.Frames() - 1);
  const Motion::Frame& at = role->motion.At(shown);
  std::vector<shell::BodyPoint> endpoints;
  for (int k = 0; k < role->motion.Connections().contacts; ++k) {
    const Motion::Point point = role->motion.Endpoint(shown, k);
    endpoints.push_back({static_cast<float>(at.x_m + static_cast<double>(point.x)), at.y_m + point.y});
  }
  role->body.clear();
  const auto add = [&](shell::BodyPoint from, float from_m, shell::BodyPoint to, float to_m, float belly_m,
                       float tone) {
    role->body.insert(role->body.end(), {from.x, from.y, from_m, to.x, to.y, to_m, belly_m, tone});
  };
  for (const shell::BodyPart& part : shell::BodyPartsOf(role->look, endpoints))
    add(part.from, part.from_m, part.to, part.to_m, part.belly_m, part.far ? 1.0f : 0.0f);
  if (const auto eye = shell::EyeOf(role->look, endpoints))
    add(eye->at, eye->radius_m, eye->at, eye->radius_m, 0.0f, 2.0f);
  return role->body.data();
}
/// How far the outline reaches below the endpoints on which the figure stands [m].
GS_EXPORT float gs_motion_sole(const MotionRole* role) { return role->look.sole_m; }
/// Of the last gs_motion_body().
GS_EXPORT std::size_t gs_motion_body_size(const MotionRole* role) { return role->body.size(); }

// Texts have gs_motion_text_size() bytes.
/// The terms of the whole motion by name, whether its simulation failed, and its hash, as JSON.
GS_EXPORT const char* gs_motion_measures(MotionRole* role) {
  const Terms& terms = role->motion.TermsAt(role->motion.Frames() - 1);
  std::string json = "{\"terms\":[";
  const auto add = [&json](std::string_view name, float value) {
    if (!json.ends_with('[')) json += ',';
    json += "{\"name\":" + QuoteJson(name) +
            ",\"value\":" + (std::isfinite(value) ? RealText(value) : std::string("null")) + "}";
  };
  add("distance", std::abs(terms.travel_m));
  add("travel", terms.travel_m);
  for (std::size_t i = 0; i < kStyleTerms; ++i)
    add(kStyleTermNames[i], terms.Style(static_cast<StyleTerm>(i)));
  json += "],\"broke\":" + std::string(terms.broke_physics ? "true" : "false");
  return Keep(role, json + ",\"hash\":" + QuoteJson(HashText(role->motion.Hash())) + "}");
}
GS_EXPORT std::size_t gs_motion_text_size(const MotionRole* role) { return role->text.size(); }
