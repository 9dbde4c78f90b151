// SPDX-License-Identifier: MIT
// The ground's part of a step. Figures that meet the ground are gathered from all states and solved W at a
// time, those with one contact apart from those with two or more: flight does not pay for contact, nor one
// foot for four. Grouping changes no bit: a figure's lane sees nothing of its neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/physics/contact_sweeps.h"
#include "core/physics/flight.h"

namespace gaitsmith {

template <int W>
class Ground {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using State = MotionState<W>;

 public:
  /// @param skeleton, world must outlive the ground
  Ground(const Skeleton& skeleton, const World& world) : skeleton_(skeleton), world_(world) {}

  /// Lets all figures that would end the step near the ground meet it.
  void Meet(std::span<State> states) {
    for (State& s : states) List(s, s.near_ground);
    for (int round = 1; !single_.empty() || !pair_.empty() || !many_.empty(); ++round) {
      SolveListed();
      for (State& s : states) {
        if (!L::Any(s.near_ground != 0)) continue;
        const F guess = s.spin;
        PlaceAtEnd<W>(skeleton_, world_, s);
        if (round == kContactRounds) continue;
        // A landing may throw further endpoints against the ground, and turn the arms it was computed with.
        const I touched = s.ground.up > 0.0f;
        const I near = s.near_ground | (touched & EndpointsNearGround<W>(skeleton_, s));
        const I turned = touched & (L::Abs(s.spin - guess) * world_.step_s > kArmTurn);
        List(s, ((near != s.near_ground) | turned) & near);
        s.near_ground = near;
      }
    }
  }

 private:
  /// One figure and the endpoints with which it meets the ground.
  struct Meeting {
    State* state;
    int lane;
    std::uint32_t endpoints;  // bits
  };

  /// W figures with a like number of contacts.
  struct Group {
    std::array<State*, W> state;
    std::array<int, W> lane;
    int figures = 0;           // the others repeat the last and are not told
    std::size_t contacts = 0;  // the most of any figure
    Body<W> body;
    std::array<Contact<W>, kMaxEndpoints> contact;
    std::array<std::array<std::size_t, W>, kMaxEndpoints> endpoint;  // of each contact; 0 where there is none
    std::array<I, kMaxEndpoints> present;                            // figures that have this many contacts
    std::array<F, kMaxEndpoints> last_normal, last_tangent;          // impulses of the step before
  };

  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }

  void List(State& state, const I& near) {
    if (!L::Any(near)) return;
    for (int lane = 0; lane < W; ++lane) {
      const auto endpoints = static_cast<std::uint32_t>(L::At(near, lane));
      if (endpoints == 0) continue;
      const std::uint32_t after_one = endpoints & (endpoints - 1), after_two = after_one & (after_one - 1);
      (after_one == 0 ? single_ : after_two == 0 ? pair_ : many_).push_back({&state, lane, endpoints});
    }
  }

  void SolveListed() {
    Group group;
    for (std::size_t at = 0; at < single_.size(); at += W) {
      Gather(std::span(single_).subspan(at), 1, group);
      SolveSingle<W>(world_, group.body, group.contact[0]);
      Tell(group);
    }
    for (std::size_t at = 0; at < pair_.size(); at += W) {
      Gather(std::span(pair_).subspan(at), 2, group);
      SolvePair<W>(world_, group.body, group.contact[0], group.contact[1]);
      Tell(group);
    }
    for (std::size_t at = 0; at < many_.size(); at += W) {
      const auto meetings = std::span(many_).subspan(at, std::min<std::size_t>(W, many_.size() - at));
      int most = 0;
      for (const Meeting& m : meetings) most = std::max(most, std::popcount(m.endpoints));
      Gather(meetings, Index(most), group);
      // Where two feet are driven apart, friction climbs to the edge of its cone a step's worth a sweep: it
      // starts where it was.
      for (std::size_t c = 0; c < group.contacts; ++c) {
        group.contact[c].force = {L::Select(group.present[c], group.last_normal[c], F{}),
                                  L::Select(group.present[c], group.last_tangent[c], F{})};
      }
      SolveMany<W>(world_, group.body, std::span(group.contact).first(group.contacts), group.present);
      Tell(group);
    }
    single_.clear();
    pair_.clear();
    many_.clear();
  }

  /// Brings the next W figures together, as bodies with contacts.
  void Gather(std::span<const Meeting> meetings, std::size_t contacts, Group& group) const {
    group.figures = std::min(W, static_cast<int>(meetings.size()));
    group.contacts = contacts;
    std::array<const State*, W> state;
    std::array<int, W> lane;
    for (int i = 0; i < W; ++i) {
      const Meeting& m = meetings[Index(std::min(i, group.figures - 1))];
      state[Index(i)] = group.state[Index(i)] = m.state;
      lane[Index(i)] = group.lane[Index(i)] = m.lane;
      std::uint32_t left = m.endpoints;
      for (std::size_t c = 0; c < contacts; ++c, left &= left - 1) {
        group.present[c][i] = left != 0 ? -1 : 0;
        group.endpoint[c][Index(i)] = left != 0 ? Index(std::countr_zero(left)) : 0;
      }
    }
    // One number of every figure, wherever it lies.
    const auto each = [&](auto get) {
      F all;
      for (int i = 0; i < W; ++i) all[i] = L::At(get(*state[Index(i)], Index(i)), lane[Index(i)]);
      return all;
    };

    const F start_sine = each([](const State& s, auto) -> const F& { return s.sine; });
    const F start_cosine = each([](const State& s, auto) -> const F& { return s.cosine; });
    const F start_height = each([](const State& s, auto) -> const F& { return s.height_m; });
    const F path_y = each([](const State& s, auto) -> const F& { return s.path_y; });
    const F spin = each([](const State& s, auto) -> const F& { return s.spin; });
    Body<W> body;
    body.velocity_x = each([](const State& s, auto) -> const F& { return s.velocity_x; });
    body.velocity_y = each([](const State& s, auto) -> const F& { return s.velocity_y; });
    body.spin = each([](const State& s, auto) -> const F& { return s.flight_spin; });
    body.inertia = each([](const State& s, auto) -> const F& { return s.shape.inertia; });
    body.inverse_inertia = each([](const State& s, auto) -> const F& { return s.inverse_inertia; });
    // Forces act in the middle of the step, as far as it is known by now.
    body.height = start_height + 0.5f * path_y;
    group.body = body;
    F sine = start_sine, cosine = start_cosine;
    Turn<W>(0.5f * world_.step_s * spin, sine, cosine);

    for (std::size_t c = 0; c < contacts; ++c) {
      const auto& k = group.endpoint[c];
      const F x0 = each([&](const State& s, auto i) -> const F& { return s.PoseNow().endpoint_x[k[i]]; });
      const F y0 = each([&](const State& s, auto i) -> const F& { return s.PoseNow().endpoint_y[k[i]]; });
      const F x1 = each([&](const State& s, auto i) -> const F& { return s.NextPose().endpoint_x[k[i]]; });
      const F y1 = each([&](const State& s, auto i) -> const F& { return s.NextPose().endpoint_y[k[i]]; });
      group.last_normal[c] = each([&](const State& s, auto i) -> const F& { return s.last_normal[k[i]]; });
      if (contacts > 2) {
        group.last_tangent[c] =
            each([&](const State& s, auto i) -> const F& { return s.last_tangent[k[i]]; });
      }
      const F r_x = 0.5f * (x0 + x1), r_y = 0.5f * (y0 + y1);
      const F u_x = (x1 - x0) * world_.inverse_step, u_y = (y1 - y0) * world_.inverse_step;
      Contact<W>& contact = group.contact[c];
      contact.arm = cosine * r_x - sine * r_y;
      // An endpoint that only lands in this step is not quite at height 0 at mid-step.
      const F above = body.height + (sine * r_x + cosine * r_y);
      contact.drift_t = (cosine * u_x - sine * u_y) - spin * above;
      const F gap = start_height + (start_sine * x0 + start_cosine * y0);
      contact.drift_n = (sine * u_x + cosine * u_y) + L::Max(gap, F{}) * world_.inverse_step;
    }
  }

  /// Hands the impulses to the figures they act on.
  void Tell(const Group& group) const {
    Body<W> body = group.body;
    GroundEffect<W> effect;
    for (std::size_t c = 0; c < group.contacts; ++c) {
      const Contact<W>& contact = group.contact[c];
      effect.up += contact.force.normal;
      effect.along += contact.force.tangent;
      effect.moment += contact.force.normal * contact.arm + contact.force.tangent * body.height;
      body.Push(world_, contact.arm, contact.force);
    }
    for (std::size_t c = 0; c < group.contacts; ++c) {
      const Contact<W>& contact = group.contact[c];
      const F slide = contact.Slide(body);
      const I bears = (contact.force.normal > 0.0f) & (group.last_normal[c] > 0.0f);
      effect.slip_m += L::Select(bears, L::Abs(slide) * world_.step_s, F{});
      effect.normal_work_j += contact.force.normal * contact.Approach(body);
      const F work = contact.force.tangent * slide;
      effect.friction_work_j += work;
      effect.friction_gain_j += L::Max(work, F{});
    }
    for (int i = 0; i < group.figures; ++i) {
      State& s = *group.state[Index(i)];
      const int lane = group.lane[Index(i)];
      L::Put(s.ground.up, lane, effect.up[i]);
      L::Put(s.ground.along, lane, effect.along[i]);
      L::Put(s.ground.moment, lane, effect.moment[i]);
      L::Put(s.ground.slip_m, lane, effect.slip_m[i]);
      L::Put(s.ground.normal_work_j, lane, effect.normal_work_j[i]);
      L::Put(s.ground.friction_work_j, lane, effect.friction_work_j[i]);
      L::Put(s.ground.friction_gain_j, lane, effect.friction_gain_j[i]);
      for (std::size_t c = 0; c < group.contacts && group.present[c][i] != 0; ++c) {
        const std::size_t k = group.endpoint[c][Index(i)];
        L::Put(s.normal[k], lane, group.contact[c].force.normal[i]);
        L::Put(s.tangent[k], lane, group.contact[c].force.tangent[i]);
      }
    }
  }

  const Skeleton& skeleton_;
  const World& world_;
  std::vector<Meeting> single_, pair_, many_;  // by number of contacts
};

}  // namespace gaitsmith
