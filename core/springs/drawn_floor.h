// SPDX-License-Identifier: MIT
// Drawn ground under the nodes of W figures of springs, in one substep. As on level ground each contact is
// solved alone, but a node may meet several faces, one after another.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/springs/lattice_state.h"
#include "core/springs/lattice_world.h"
#include "core/world/terrain.h"

namespace gaitsmith {

/// A node this deep behind a face is on the other side of it, or in the ground, and the face lets it be [m].
inline constexpr double kBehindFace = 1e-4;
/// Faces reach this far beyond their ends, so that no node slips between two [m].
inline constexpr double kFaceSlack = 1e-6;
/// What ends less deep behind a face just reaches it [m]: rounding may leave a node there that has landed.
inline constexpr double kJustReached = 1e-12;
/// How many faces a node can meet in a substep. One that meets more stops.
inline constexpr int kMostMeetings = 4;

/// A node on its way through one substep.
class NodePath {
 public:
  /// @param x, y place [m] @param vx, vy velocity [m/s] @param h the substep [s]
  NodePath(double x, double y, double vx, double vy, double h) : x_(x), y_(y), vx_(vx), vy_(vy), h_(h) {}

  /// Meets faces until none is in the way. @param friction coefficient @param mass_kg of the node
  void Meet(const Terrain& terrain, double friction, double mass_kg) {
    for (int met = 0;; ++met) {
      const Terrain::Face* face = NextFace(terrain);
      if (face == nullptr) return;
      if (met == kMostMeetings) {
        tangent_x -= mass_kg * vx_;
        tangent_y -= mass_kg * vy_;
        vx_ = vy_ = 0.0;
        return;
      }
      const double nx = -face->uy, ny = face->ux;
      const double gap = face->Above(x_, y_);
      if (gap < 0.0) {  // rounding: it belongs on the face
        x_ -= gap * nx;
        y_ -= gap * ny;
        lifted += -gap;
      }
      const double before_n = vx_ * nx + vy_ * ny, before_t = vx_ * face->ux + vy_ * face->uy;
      const double after_n = gap > 0.0 ? -gap / h_ : 0.0;  // just reaches the face
      const double normal = mass_kg * (after_n - before_n);
      const double slowed = std::max(std::abs(before_t) - friction * normal / mass_kg, 0.0);
      const double after_t = before_t < 0.0 ? -slowed : slowed;
      const double tangent = mass_kg * (after_t - before_t);
      vx_ = after_n * nx + after_t * face->ux;
      vy_ = after_n * ny + after_t * face->uy;
      normal_x += normal * nx;
      normal_y += normal * ny;
      tangent_x += tangent * face->ux;
      tangent_y += tangent * face->uy;
      normal_work += normal * after_n;
      friction_work += tangent * after_t;
      touches = true;
    }
  }

  [[nodiscard]] double X() const { return x_ + h_ * vx_; }
  [[nodiscard]] double Y() const { return y_ + h_ * vy_; }
  [[nodiscard]] double SpeedX() const { return vx_; }
  [[nodiscard]] double SpeedY() const { return vy_; }

  bool touches = false;
  double lifted = 0.0;                                                      // [m]
  double normal_x = 0.0, normal_y = 0.0, tangent_x = 0.0, tangent_y = 0.0;  // impulses [N s]
  double normal_work = 0.0, friction_work = 0.0;                            // [J]

 private:
  /// The face that it crosses first, if it goes on as it does now.
  [[nodiscard]] const Terrain::Face* NextFace(const Terrain& terrain) const {
    const double to = x_ + h_ * vx_;
    const Terrain::Face* next = nullptr;
    double soonest = 2.0;
    for (const Terrain::Face& face :
         terrain.FacesBetween(std::min(x_, to) - kBehindFace, std::max(x_, to) + kBehindFace)) {
      const double gap = face.Above(x_, y_);
      const double approach = h_ * (vy_ * face.ux - vx_ * face.uy);
      if (gap < -kBehindFace || !(approach < 0.0) || gap + approach >= -kJustReached) continue;
      const double when = gap > 0.0 ? gap / -approach : 0.0;
      const double along = face.Along(x_ + when * h_ * vx_, y_ + when * h_ * vy_);
      if (along < -kFaceSlack || along > face.length + kFaceSlack || when >= soonest) continue;
      soonest = when;
      next = &face;
    }
    return next;
  }

  double x_, y_, vx_, vy_, h_;
};

/// Moves the nodes by one substep, with the ground's impulses. @param slide as of MoveOnFloor
template <int W>
void MoveOnDrawnFloor(const Lattice& body, const LatticeWorld& world, const Terrain& terrain,
                      typename LatticeState<W>::Points& slide, LatticeState<W>& s) {
  const auto h = static_cast<double>(world.substep_s);
  for (std::size_t k = 0; k < body.nodes; ++k) {
    for (int lane = 0; lane < W; ++lane) {
      const double x = s.place_m[lane] + static_cast<double>(s.x[k][lane]);
      const double y = static_cast<double>(s.height_m[lane]) + static_cast<double>(s.y[k][lane]);
      NodePath path(x, y, static_cast<double>(s.velocity_x[k][lane] + world.fall_x),
                    static_cast<double>(s.velocity_y[k][lane] + world.fall_y), h);
      path.Meet(terrain, static_cast<double>(world.friction), static_cast<double>(body.mass_kg[k]));
      s.velocity_x[k][lane] = static_cast<float>(path.SpeedX());
      s.velocity_y[k][lane] = static_cast<float>(path.SpeedY());
      const double moved_x = path.X() - x, moved_y = path.Y() - y;
      s.x[k][lane] += static_cast<float>(moved_x);
      s.y[k][lane] += static_cast<float>(moved_y);
      if (!path.touches) continue;
      s.normal[k][lane] += static_cast<float>(path.normal_y + path.tangent_y);
      s.tangent[k][lane] += static_cast<float>(path.normal_x + path.tangent_x);
      slide[k][lane] += static_cast<float>(std::sqrt(moved_x * moved_x + moved_y * moved_y));
      s.normal_work_j[lane] += static_cast<float>(path.normal_work);
      s.friction_work_j[lane] += static_cast<float>(path.friction_work);
      s.friction_gain_j[lane] += static_cast<float>(std::max(path.friction_work, 0.0));
      s.lifting_work_j[lane] +=
          static_cast<float>(path.lifted) * body.mass_kg[k] / body.total_kg * world.weight_n;
    }
  }
}

}  // namespace gaitsmith
