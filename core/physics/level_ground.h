// SPDX-License-Identifier: MIT
// Level ground under W figures with moving limbs, during one step (model 2). Only endpoints can touch it.
#pragma once

#include "core/physics/limb_arms.h"
#include "core/physics/limb_contacts.h"
#include "core/physics/limb_end.h"

namespace gaitsmith {

template <int W>
class LevelGround {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  LevelGround(const Mechanism& body, const World& world, LimbState<W>& state)
      : body_(body), world_(world), s_(state), endpoints_(static_cast<std::size_t>(body.endpoints)) {}

  /// Finds the endpoints that may touch, given where the step would end.
  void Look(const LimbEnd<W>& end, const LimbArms<W>& arms, int round) {
    found_ = force_;
    touching_ = known_;
    for (std::size_t k = 0; k < endpoints_; ++k)
      touching_ |= (HeightOf(k, s_.height_m + end.path_y, end) < kContactMargin) & (1 << k);
    list_.count = 0;
    const EndpointImpulses<W>& before = round == 0 ? s_.last_force : force_;
    for (std::size_t k = 0; k < endpoints_; ++k) {
      const I present = (touching_ & (1 << k)) != 0;
      if (!L::Any(present)) continue;
      LimbTouch<W>& touch = list_.touches[list_.count];
      endpoint_[list_.count++] = k;
      touch.present = present;
      arms.RowsOf(body_, k, touch.row_n, touch.row_t);
      touch.before = {before.normal[k], before.tangent[k]};
      touch.force = {force_.normal[k], force_.tangent[k]};
    }
  }

  [[nodiscard]] bool Touches() const { return list_.count > 0; }
  void AddMomenta(LimbNumbers<W>& momenta) const { list_.AddMomenta(Rods(), momenta); }

  /// Solves for the impulses, and adds what they do.
  /// @param end     where the last round ended
  /// @param since   change of the speeds since then [rad/s]
  /// @param smooth  without friction
  void Solve(const LimbFactor<W>& factor, const LimbEnd<W>& end, const LimbNumbers<W>& since, bool smooth,
             LimbNumbers<W>& inward, LimbNumbers<W>& momenta) {
    // Where something touches, the whole of gravity acts over the step.
    const GroundSum<W> sum = SumOf(force_);
    const F height = s_.height_m + world_.step_s * (s_.velocity_y + sum.up * world_.inverse_mass);
    const F path_x = world_.step_s * (s_.velocity_x + sum.along * world_.inverse_mass);
    for (std::size_t a = 0; a < list_.count; ++a) {
      const std::size_t k = endpoint_[a];
      list_.touches[a].velocity_n = HeightOf(k, height, end) * world_.inverse_step;
      list_.touches[a].velocity_t = (path_x + end.move_x[k]) * world_.inverse_step;
    }
    LimbContacts<W, true> contacts(Rods(), world_, factor, list_);
    if (smooth)
      contacts.SolveSmooth(since);
    else
      contacts.Solve(since);
    contacts.Apply(inward, momenta);
    for (std::size_t a = 0; a < list_.count; ++a) {
      found_.normal[endpoint_[a]] = list_.touches[a].force.normal;
      found_.tangent[endpoint_[a]] = list_.touches[a].force.tangent;
    }
  }

  /// The impulses as this round found them.
  [[nodiscard]] GroundSum<W> Sum() const { return SumOf(found_); }

  /// Takes over what this round found in the open lanes. @return lanes in which something sinks too deep
  I Accept(const I& open, const LimbEnd<W>& end) {
    I sinks{};
    for (std::size_t k = 0; k < endpoints_; ++k) {
      sinks |= HeightOf(k, s_.height_m + end.path_y, end) < -kLimbSink;
      force_.normal[k] = L::Select(open, found_.normal[k], force_.normal[k]);
      force_.tangent[k] = L::Select(open, found_.tangent[k], force_.tangent[k]);
    }
    known_ = L::Select(open, touching_, known_);
    return sinks;
  }

  /// Lanes in which the ground neither pulls nor rubs more than Coulomb says.
  [[nodiscard]] I Lawful() const {
    const float most = (1.0f + kMaxConeError) * world_.friction;
    I lawful = ~I{};
    for (std::size_t k = 0; k < endpoints_; ++k)
      lawful &= (force_.normal[k] >= 0.0f) & (L::Abs(force_.tangent[k]) <= most * force_.normal[k]);
    return lawful;
  }

  /// Gives the state its velocity, and what the ground did. @param end of the step
  void Conclude(const LimbEnd<W>& end) {
    s_.normal_work_j = s_.friction_work_j = s_.friction_gain_j = F{};
    const GroundSum<W> sum = SumOf(force_);
    for (std::size_t k = 0; k < endpoints_; ++k) {
      const F slide = end.path_x + end.move_x[k];
      const F rise = end.path_y + (HeightOf(k, F{}, end) - s_.endpoint_y[k]);
      const I bears = (force_.normal[k] > 0.0f) & (s_.last_force.normal[k] > 0.0f);
      s_.slip_m += L::Select(bears, L::Abs(slide), F{});
      s_.normal_work_j += force_.normal[k] * rise * world_.inverse_step;
      const F work = force_.tangent[k] * slide * world_.inverse_step;
      s_.friction_work_j += work;
      s_.friction_gain_j += L::Max(work, F{});
    }
    s_.velocity_x += sum.along * world_.inverse_mass;
    s_.velocity_y += sum.up * world_.inverse_mass;
    s_.last_force = force_;
  }

  /// Lifts figures out of the ground. @return by how much [m]
  F Lift() {
    F lowest = s_.endpoint_y[0];
    for (std::size_t k = 1; k < endpoints_; ++k) lowest = L::Min(s_.endpoint_y[k], lowest);
    const F lift = L::Max(-(s_.height_m + lowest), F{});
    s_.height_m += lift;
    s_.lifting_work_j = lift * world_.weight_n;
    return lift;
  }

 private:
  [[nodiscard]] std::size_t Rods() const { return endpoints_ - 1; }
  /// @param height of the centre of mass [m]
  [[nodiscard]] F HeightOf(std::size_t k, const F& height, const LimbEnd<W>& end) const {
    return height + (s_.endpoint_y[k] + end.move_y[k]);
  }
  [[nodiscard]] GroundSum<W> SumOf(const EndpointImpulses<W>& force) const {
    GroundSum<W> sum;
    for (std::size_t k = 0; k < endpoints_; ++k) {
      sum.along += force.tangent[k];
      sum.up += force.normal[k];
    }
    sum.bears = sum.up > 0.0f;
    return sum;
  }

  const Mechanism& body_;
  const World& world_;
  LimbState<W>& s_;
  std::size_t endpoints_;
  I known_{}, touching_{};  // bits of endpoints
  EndpointImpulses<W> force_, found_;
  std::array<std::size_t, kMaxTouches> endpoint_;  // of each touch
  TouchList<W> list_;
};

}  // namespace gaitsmith
