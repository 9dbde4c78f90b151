// SPDX-License-Identifier: MIT
// Turns the readings of W plants into their controllers' senses, as defined in the table of senses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/control/sense_table.h"
#include "core/signal/readings.h"

namespace gaitsmith {

/// Normalised senses of W plants. The first SenseCount() entries are in use.
template <int W>
using SenseVector = std::array<typename Lane<W>::F, kMaxSenses>;

template <int W>
class SenseReader {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  /// @param spec with physical senses, or with sight
  SenseReader(const SenseSpec& spec, const Ports& ports, float step_s)
      : ports_(ports.Count()), sees_(spec.kind == SenseKind::kSight) {
    sight_m_ = static_cast<double>(SightOf(spec, ports));
    side_ = spec.facing == Facing::kRight ? 1 : -1;
    std::size_t at = 0;
    for (const SenseGroup& group : kSightSenses) {
      for (int i = 0; i < CountOf(group.per, ports_); ++i, ++at) {
        const SenseRange range = group.range(spec, ports, static_cast<std::size_t>(i));
        float width = range.at_one - range.at_zero;
        // The plant reports forces as impulses over one step.
        if (group.quantity == SenseQuantity::kForce) width *= step_s;
        at_zero_[at] = L::Splat(range.at_zero);
        // The sense of a locked joint is always 0.
        per_unit_[at] = L::Splat(width > 0.0f ? 1.0f / width : 0.0f);
      }
    }
  }

  void Read(const Readings<W>& readings, SenseVector<W>& senses) const {
    std::size_t at = 0;
    // One loop for each row of the table, unrolled at compile time.
    [&]<std::size_t... Row>(std::index_sequence<Row...>) {
      (ReadGroup<Row>(readings, at, senses), ...);
    }(std::make_index_sequence<kPhysicalSenses.size()>());
    if (sees_) Look(readings, at, senses);
  }

 private:
  template <std::size_t Row>
  void ReadGroup(const Readings<W>& readings, std::size_t& at, SenseVector<W>& senses) const {
    constexpr SenseGroup kGroup = kPhysicalSenses[Row];
    const F* reading = ReadingOf<kGroup.quantity>(readings);
    const auto count = static_cast<std::size_t>(CountOf(kGroup.per, ports_));
    for (std::size_t i = 0; i < count; ++i, ++at) senses[at] = Normal<kGroup.clip>(reading[i], at);
  }

  template <SenseClip Clip>
  F Normal(const F& reading, std::size_t at) const {
    F sense = (reading - at_zero_[at]) * per_unit_[at];
    if constexpr (Clip != SenseClip::kNone) sense = L::Min(sense, L::Splat(1.0f));
    if constexpr (Clip == SenseClip::kBoth) sense = L::Max(sense, F{});
    return sense;
  }

  /// The senses of the ground ahead. Lane by lane, because each is at another place.
  [[gnu::noinline]] void Look(const Readings<W>& readings, std::size_t at, SenseVector<W>& senses) const {
    F ahead{}, corner = L::Splat(static_cast<float>(sight_m_));
    for (int lane = 0; readings.terrain != nullptr && lane < W; ++lane) {
      const Terrain& terrain = *readings.terrain;
      const double here = (*readings.place)[lane];
      if (!std::isfinite(here)) continue;
      const double rise = terrain.HeightAt(here + side_ * sight_m_) - terrain.HeightAt(here);
      L::Put(ahead, lane, static_cast<float>(rise));
      L::Put(corner, lane, static_cast<float>(std::min(terrain.NextCorner(here, side_), sight_m_)));
    }
    senses[at] = Normal<kGroundSenses[0].clip>(ahead, at);
    senses[at + 1] = Normal<kGroundSenses[1].clip>(corner, at + 1);
  }

  template <SenseQuantity Quantity>
  static const F* ReadingOf(const Readings<W>& readings) {
    if constexpr (Quantity == SenseQuantity::kAngle) return readings.position;
    if constexpr (Quantity == SenseQuantity::kForce) return readings.impulse;
    if constexpr (Quantity == SenseQuantity::kHeight) return readings.height;
    if constexpr (Quantity == SenseQuantity::kVelocity) return readings.rise;
  }

  PortCount ports_;
  bool sees_;
  double sight_m_;
  int side_;
  std::array<F, kMaxSenses> at_zero_{}, per_unit_{};
};

}  // namespace gaitsmith
