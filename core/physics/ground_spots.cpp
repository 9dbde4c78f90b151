// SPDX-License-Identifier: MIT
#include "core/physics/ground_spots.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith {

namespace {

constexpr double kNear = static_cast<double>(kContactMargin);  // [m]
/// An endpoint or rod that begins the step this deep in the ground still counts as in front of it [m].
constexpr double kInside = 2e-3;
/// Faces end this much later than drawn, so that nothing slips through where two of them meet [m].
constexpr double kJoin = 1e-4;
/// A rod closer to an edge than this is on the side away from the ground [m].
constexpr double kOnEdge = 0.01;

/// The part of a way at which a distance vanishes; 0 if it begins at or below it, 1 if it does not get there.
double WhenZero(double from, double to) {
  if (from <= 0.0) return 0.0;
  return to >= 0.0 ? 1.0 : from / (from - to);
}

/// Which part of a rod is beside an edge, at a part of its way: 0 its inner end, 1 its outer end.
double AlongRod(const LimbPlaces& from, const LimbPlaces& to, std::size_t a, std::size_t b, double part,
                const Terrain::Edge& edge) {
  const double ax = from.x[a] + part * (to.x[a] - from.x[a]), ay = from.y[a] + part * (to.y[a] - from.y[a]);
  const double bx = from.x[b] + part * (to.x[b] - from.x[b]), by = from.y[b] + part * (to.y[b] - from.y[b]);
  const double x = bx - ax, y = by - ay;
  return ((edge.x - ax) * x + (edge.y - ay) * y) / (x * x + y * y);
}

}  // namespace

GroundSpot* GroundSpots::Of(int feature) {
  for (std::size_t i = 0; i < count; ++i) {
    if (spots[i].feature == feature) return &spots[i];
  }
  if (count == kMaxTouches) return nullptr;
  spots[count] = {};
  spots[count].feature = feature;
  return &spots[count++];
}

bool SpotFinder::Look(const LimbPlaces& from, const LimbPlaces& to, double sink_m, GroundSpots& spots) const {
  bool sinks = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(body_.endpoints); ++k)
    sinks |= LookAtFaces(k, from, to, sink_m, spots);
  for (std::size_t limb = 0; limb < static_cast<std::size_t>(body_.rods); ++limb)
    sinks |= LookAtEdges(limb, from, to, sink_m, spots);
  return sinks;
}

bool SpotFinder::LookAtFaces(std::size_t k, const LimbPlaces& from, const LimbPlaces& to, double sink_m,
                             GroundSpots& spots) const {
  const double x = from.x[k], y = from.y[k], dx = to.x[k] - x, dy = to.y[k] - y;
  bool sinks = false;
  for (const Terrain::Face& face :
       terrain_.FacesBetween(std::min(x, to.x[k]) - kNear, std::max(x, to.x[k]) + kNear)) {
    const double before = face.Above(x, y), after = face.Above(to.x[k], to.y[k]);
    if (before < -kInside || after > kNear) continue;
    const double part = WhenZero(before, after);
    const double at = face.Along(x + part * dx, y + part * dy);
    if (at < -kJoin || at > face.length + kJoin) continue;
    const auto number = static_cast<int>(&face - terrain_.Faces().data());
    GroundSpot* spot = spots.Of(number * kMaxEndpoints + static_cast<int>(k));
    if (spot == nullptr) continue;
    spot->limb = k == 0 ? 0 : static_cast<int>(k) - 1;
    spot->along = k == 0 ? 0.0f : 1.0f;
    spot->normal_x = static_cast<float>(-face.uy);
    spot->normal_y = static_cast<float>(face.ux);
    spot->gap_m = static_cast<float>(before);
    sinks |= after < -sink_m;
  }
  return sinks;
}

bool SpotFinder::LookAtEdges(std::size_t limb, const LimbPlaces& from, const LimbPlaces& to, double sink_m,
                             GroundSpots& spots) const {
  const auto a = static_cast<std::size_t>(body_.limbs[limb].start);
  const std::size_t b = limb + 1;
  const double left = std::min({from.x[a], from.x[b], to.x[a], to.x[b]}) - kNear;
  const double right = std::max({from.x[a], from.x[b], to.x[a], to.x[b]}) + kNear;
  const auto length = static_cast<double>(body_.limbs[limb].length_m);
  bool sinks = false;
  for (const Terrain::Edge& edge : terrain_.EdgesBetween(left, right)) {
    // Left of the rod's direction counts as positive, until the rod's own side is known.
    const double ux = (from.x[b] - from.x[a]) / length, uy = (from.y[b] - from.y[a]) / length;
    const double vx = (to.x[b] - to.x[a]) / length, vy = (to.y[b] - to.y[a]) / length;
    const double before = ux * (from.y[a] - edge.y) - uy * (from.x[a] - edge.x);
    const double after = vx * (to.y[a] - edge.y) - vy * (to.x[a] - edge.x);
    // Close to the edge a rod is on the side away from the ground, even if it is a little inside.
    const int ground = std::abs(before) < kOnEdge ? edge.SideOfGround(ux, uy) : 0;
    const double side = ground != 0 ? -ground : (before >= 0.0 ? 1.0 : -1.0);
    if (side * after > kNear) continue;
    // Where the rod meets the edge, and how it lies in the end.
    const double part = WhenZero(side * before, side * after);
    const double meets = AlongRod(from, to, a, b, part, edge), ends = AlongRod(from, to, a, b, 1.0, edge);
    // At its ends a rod touches faces.
    if (meets <= 0.0 || meets >= 1.0) continue;
    const auto number = static_cast<int>(&edge - terrain_.Edges().data());
    GroundSpot* spot = spots.Of(-1 - number * kMaxRods - static_cast<int>(limb));
    if (spot == nullptr) continue;
    const double along = std::clamp(ends, 1e-3, 1.0 - 1e-3);
    const double nx = -side * vy, ny = side * vx;
    const double x = (1.0 - along) * (to.x[a] - from.x[a]) + along * (to.x[b] - from.x[b]);
    const double y = (1.0 - along) * (to.y[a] - from.y[a]) + along * (to.y[b] - from.y[b]);
    spot->limb = static_cast<int>(limb);
    spot->along = static_cast<float>(along);
    spot->normal_x = static_cast<float>(nx);
    spot->normal_y = static_cast<float>(ny);
    spot->gap_m = static_cast<float>(side * after - (nx * x + ny * y));
    sinks |= side * after < -sink_m;
  }
  return sinks;
}

double SpotFinder::Above(const GroundSpot& spot, const LimbPlaces& at) const {
  const auto limb = static_cast<std::size_t>(spot.limb);
  const auto a = static_cast<std::size_t>(body_.limbs[limb].start);
  const std::size_t b = limb + 1;
  const auto along = static_cast<double>(spot.along);
  const double x = at.x[a] + along * (at.x[b] - at.x[a]), y = at.y[a] + along * (at.y[b] - at.y[a]);
  if (spot.feature >= 0)
    return terrain_.Faces()[static_cast<std::size_t>(spot.feature / kMaxEndpoints)].Above(x, y);
  const Terrain::Edge& edge = terrain_.Edges()[static_cast<std::size_t>(-1 - spot.feature) / kMaxRods];
  return static_cast<double>(spot.normal_x) * (x - edge.x) +
         static_cast<double>(spot.normal_y) * (y - edge.y);
}

bool SpotFinder::IsBuried(const LimbPlaces& at, double most_m) const {
  for (std::size_t k = 0; k < static_cast<std::size_t>(body_.endpoints); ++k) {
    const double x = at.x[k], y = at.y[k];
    if (terrain_.HeightAt(x) - y <= most_m) continue;
    // Below the ground's height, but perhaps only just behind a steep face.
    const auto near = terrain_.FacesBetween(x - most_m, x + most_m);
    const bool shallow = std::ranges::any_of(near, [&](const Terrain::Face& face) {
      const double along = face.Along(x, y);
      return along >= -kJoin && along <= face.length + kJoin && face.Above(x, y) >= -most_m;
    });
    if (!shallow) return true;
  }
  return false;
}

double SpotFinder::LiftOf(const LimbPlaces& at) const {
  double lift = terrain_.HeightAt(at.x[0]) - at.y[0];
  for (std::size_t limb = 0; limb < static_cast<std::size_t>(body_.rods); ++limb) {
    const auto a = static_cast<std::size_t>(body_.limbs[limb].start);
    const std::size_t b = limb + 1;
    lift = std::max(lift, terrain_.HeightAt(at.x[b]) - at.y[b]);
    for (const Terrain::Edge& edge :
         terrain_.EdgesBetween(std::min(at.x[a], at.x[b]), std::max(at.x[a], at.x[b]))) {
      if (at.x[a] == at.x[b]) continue;  // upright: its ends tell
      const double part = (edge.x - at.x[a]) / (at.x[b] - at.x[a]);
      lift = std::max(lift, edge.y - (at.y[a] + part * (at.y[b] - at.y[a])));
    }
  }
  return lift;
}

}  // namespace gaitsmith
