// SPDX-License-Identifier: MIT
// Drawn ground under W figures with moving limbs, during one step (model 2). Each figure has spots of its own
// (ground_spots.h); the contacts of all are solved side by side.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/physics/ground_spots.h"
#include "core/physics/limb_arms.h"
#include "core/physics/limb_contacts.h"
#include "core/physics/limb_end.h"

namespace gaitsmith {

/// Where the endpoints of one figure are.
template <int W>
LimbPlaces PlacesOf(const LimbState<W>& s, std::size_t endpoints, int lane) {
  LimbPlaces places;
  const double x = s.place_m[lane];
  const auto height = static_cast<double>(s.height_m[lane]);
  for (std::size_t k = 0; k < endpoints; ++k) {
    places.x[k] = x + static_cast<double>(s.endpoint_x[k][lane]);
    places.y[k] = height + static_cast<double>(s.endpoint_y[k][lane]);
  }
  return places;
}

template <int W>
class DrawnGround {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  DrawnGround(const Mechanism& body, const World& world, const Terrain& terrain, LimbState<W>& state)
      : body_(body),
        world_(world),
        finder_(body, terrain),
        s_(state),
        rods_(static_cast<std::size_t>(body.rods)) {
    for (int lane = 0; lane < W; ++lane)
      from_[static_cast<std::size_t>(lane)] = PlacesOf(s_, rods_ + 1, lane);
  }

  /// Finds the places that may touch, given where the step would end.
  void Look(const LimbEnd<W>& end, const LimbArms<W>& arms, int round) {
    if (round == 0) FindSpots(~I{}, end);
    found_ = force_;
    for (std::size_t i = 0; i < list_.count; ++i) {
      LimbTouch<W>& touch = list_.touches[i];
      const F px = OnRod(i, arms.x), py = OnRod(i, arms.y);
      LimbNumbers<W> up, right;
      arms.RowsOf(body_, tip_[i], px, py, up, right);
      for (std::size_t j = 0; j < rods_; ++j) {
        touch.row_n[j] = touch.normal_x * right[j] + touch.normal_y * up[j];
        touch.row_t[j] = touch.normal_y * right[j] - touch.normal_x * up[j];
      }
      touch.before = touch.force = force_[i];
    }
  }

  [[nodiscard]] bool Touches() const { return list_.count > 0; }
  void AddMomenta(LimbNumbers<W>& momenta) const { list_.AddMomenta(rods_, momenta); }

  /// As of LevelGround.
  void Solve(const LimbFactor<W>& factor, const LimbEnd<W>& end, const LimbNumbers<W>& since, bool smooth,
             LimbNumbers<W>& inward, LimbNumbers<W>& momenta) {
    // Where something touches, the whole of gravity acts over the step.
    const GroundSum<W> sum = SumOf(force_);
    const F path_x = world_.step_s * (s_.velocity_x + sum.along * world_.inverse_mass);
    const F path_y = world_.step_s * (s_.velocity_y + sum.up * world_.inverse_mass);
    for (std::size_t i = 0; i < list_.count; ++i) {
      LimbTouch<W>& touch = list_.touches[i];
      const F x = path_x + OnRod(i, end.move_x), y = path_y + OnRod(i, end.move_y);
      touch.velocity_n = (gap_[i] + (touch.normal_x * x + touch.normal_y * y)) * world_.inverse_step;
      touch.velocity_t = (touch.normal_y * x - touch.normal_x * y) * world_.inverse_step;
    }
    LimbContacts<W, false> contacts(rods_, world_, factor, list_);
    if (smooth) {
      contacts.SolveSmooth(since);
    } else {
      contacts.Solve(since);
    }
    contacts.Apply(inward, momenta);
    for (std::size_t i = 0; i < list_.count; ++i) found_[i] = list_.touches[i].force;
  }

  [[nodiscard]] GroundSum<W> Sum() const { return SumOf(found_); }

  /// As of LevelGround. Spots that come into reach join in.
  I Accept(const I& open, const LimbEnd<W>& end) {
    for (std::size_t i = 0; i < list_.count; ++i) {
      force_[i] = {L::Select(open, found_[i].normal, force_[i].normal),
                   L::Select(open, found_[i].tangent, force_[i].tangent)};
    }
    return FindSpots(open, end);
  }

  /// Lanes in which the ground neither pulls nor rubs more than Coulomb says, and nothing is buried.
  [[nodiscard]] I Lawful() const {
    const float most = (1.0f + kMaxConeError) * world_.friction;
    I lawful = ~buried_;
    for (std::size_t i = 0; i < list_.count; ++i)
      lawful &= (force_[i].normal >= 0.0f) & (L::Abs(force_[i].tangent) <= most * force_[i].normal);
    return lawful;
  }

  /// As of LevelGround. What pushes a rod between its ends is felt by none of its endpoints.
  void Conclude(const LimbEnd<W>& end) {
    s_.normal_work_j = s_.friction_work_j = s_.friction_gain_j = F{};
    EndpointImpulses<W> felt;
    for (std::size_t i = 0; i < list_.count; ++i) {
      const LimbTouch<W>& touch = list_.touches[i];
      const Impulse<W>& force = force_[i];
      const F x = end.path_x + OnRod(i, end.move_x), y = end.path_y + OnRod(i, end.move_y);
      const F rise = touch.normal_x * x + touch.normal_y * y, slide = touch.normal_y * x - touch.normal_x * y;
      s_.normal_work_j += force.normal * rise * world_.inverse_step;
      const F work = force.tangent * slide * world_.inverse_step;
      s_.friction_work_j += work;
      s_.friction_gain_j += L::Max(work, F{});
      const F along = force.normal * touch.normal_x + force.tangent * touch.normal_y;
      const F up = force.normal * touch.normal_y - force.tangent * touch.normal_x;
      for (int lane = 0; lane < W; ++lane) {
        const int k = endpoint_[i][lane];
        if (k < 0 || force.normal[lane] <= 0.0f) continue;
        const auto at = static_cast<std::size_t>(k);
        if (s_.last_force.normal[at][lane] > 0.0f) s_.slip_m[lane] += std::abs(slide[lane]);
        felt.tangent[at][lane] += along[lane];
        felt.normal[at][lane] += up[lane];
      }
    }
    s_.place_m += L::ToDouble(end.path_x);
    const GroundSum<W> sum = SumOf(force_);
    s_.velocity_x += sum.along * world_.inverse_mass;
    s_.velocity_y += sum.up * world_.inverse_mass;
    for (std::size_t k = 0; k <= rods_; ++k) felt.normal[k] = L::Max(felt.normal[k], F{});
    s_.last_force = felt;
  }

  /// Moves figures out of the ground, at right angles to it. @return by how much [m]
  F Lift() {
    F lift{}, up{};
    for (int lane = 0; lane < W; ++lane) {
      const auto at = static_cast<std::size_t>(lane);
      const GroundSpots& here = spots_[at];
      LimbPlaces places = PlacesOf(s_, rods_ + 1, lane);
      for (std::size_t i = 0; i < here.count; ++i) {
        const GroundSpot& spot = here.spots[i];
        const double depth = -finder_.Above(spot, places);
        if (!(depth > 0.0)) continue;
        const double x = depth * static_cast<double>(spot.normal_x);
        const auto y = static_cast<float>(depth * static_cast<double>(spot.normal_y));
        s_.distance_m[lane] += x;
        s_.place_m[lane] += x;
        L::Put(s_.height_m, lane, s_.height_m[lane] + y);
        lift[lane] += static_cast<float>(depth);
        up[lane] += std::max(y, 0.0f);
        places = PlacesOf(s_, rods_ + 1, lane);
      }
      buried_[lane] = finder_.IsBuried(places, static_cast<double>(kMaxPenetration)) ? -1 : 0;
    }
    s_.lifting_work_j = up * world_.weight_n;
    return lift;
  }

 private:
  /// Finds the spots of the open lanes, and lists those of all. @return lanes in which something sinks
  I FindSpots(const I& open, const LimbEnd<W>& end) {
    I sinks{};
    for (int lane = 0; lane < W; ++lane) {
      if (open[lane] == 0) continue;
      const auto at = static_cast<std::size_t>(lane);
      LimbPlaces to = from_[at];
      for (std::size_t k = 0; k <= rods_; ++k) {
        to.x[k] += static_cast<double>(end.path_x[lane]) + static_cast<double>(end.move_x[k][lane]);
        to.y[k] += static_cast<double>(end.path_y[lane]) + static_cast<double>(end.move_y[k][lane]);
      }
      GroundSpots& here = spots_[at];
      if (finder_.Look(from_[at], to, static_cast<double>(kLimbSink), here)) sinks[lane] = -1;
      list_.count = std::max(list_.count, here.count);
      for (std::size_t i = 0; i < here.count; ++i) List(here.spots[i], i, lane);
    }
    return sinks;
  }

  void List(const GroundSpot& spot, std::size_t i, int lane) {
    LimbTouch<W>& touch = list_.touches[i];
    touch.present[lane] = -1;
    touch.normal_x[lane] = spot.normal_x;
    touch.normal_y[lane] = spot.normal_y;
    gap_[i][lane] = spot.gap_m;
    along_[i][lane] = spot.along;
    limb_[i][lane] = spot.limb;
    const bool root_start = spot.along == 0.0f;
    tip_[i][lane] = root_start ? 0 : 1 << (spot.limb + 1);
    endpoint_[i][lane] = spot.AtEnd() ? (root_start ? 0 : spot.limb + 1) : -1;
  }

  /// A number of the endpoints, at the place of a touch.
  F OnRod(std::size_t i, const std::array<F, kMaxEndpoints>& numbers) const {
    F at{};
    for (int lane = 0; lane < W; ++lane) {
      if (list_.touches[i].present[lane] == 0) continue;
      const auto limb = static_cast<std::size_t>(limb_[i][lane]);
      const float inner = numbers[static_cast<std::size_t>(body_.limbs[limb].start)][lane];
      const float outer = numbers[limb + 1][lane];
      const float along = along_[i][lane];
      at[lane] = along == 1.0f ? outer : inner + along * (outer - inner);
    }
    return at;
  }

  [[nodiscard]] GroundSum<W> SumOf(const std::array<Impulse<W>, kMaxTouches>& force) const {
    GroundSum<W> sum;
    F pressing{};
    for (std::size_t i = 0; i < list_.count; ++i) {
      const LimbTouch<W>& touch = list_.touches[i];
      sum.along += force[i].normal * touch.normal_x + force[i].tangent * touch.normal_y;
      sum.up += force[i].normal * touch.normal_y - force[i].tangent * touch.normal_x;
      pressing += force[i].normal;
    }
    sum.bears = pressing > 0.0f;
    return sum;
  }

  const Mechanism& body_;
  const World& world_;
  SpotFinder finder_;
  LimbState<W>& s_;
  std::size_t rods_;
  // Of each lane: where the step begins, and what may touch.
  std::array<LimbPlaces, W> from_;
  std::array<GroundSpots, W> spots_;
  I buried_{};
  // Of each touch.
  TouchList<W> list_;
  std::array<Impulse<W>, kMaxTouches> force_{}, found_{};
  std::array<F, kMaxTouches> gap_{}, along_{};
  std::array<I, kMaxTouches> limb_{}, tip_{}, endpoint_{};
};

}  // namespace gaitsmith
