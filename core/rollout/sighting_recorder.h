// SPDX-License-Identifier: MIT
// Records what banks of rules sense during their motions, in every lane. It only reads their state.
#pragma once

#include <span>
#include <vector>

#include "core/control/controllers.h"
#include "core/control/sighting.h"

namespace gaitsmith {

/// Sightings to record beside scores: `count` of them for each genome, evenly spaced, the last one at the
/// end. 0: none.
struct Watch {
  int count = 0;
  std::span<std::vector<Sighting>> of_genomes = {};
};

template <int W>
class SightingRecorder {
 public:
  /// @param shape of rules
  /// @param start, duration [steps] of the motion
  /// @param watch of at most W genomes; its lists are filled
  SightingRecorder(const BankShape& shape, SenseKind senses, int start, int duration, const Watch& watch)
      : senses_(static_cast<std::size_t>(shape.senses)),
        edges_(EdgesOf(senses)),
        start_(start),
        duration_(duration),
        watch_(watch) {
    for (std::vector<Sighting>& all : watch_.of_genomes) all.clear();
  }

  /// Call before the first step and after every step. @param step since the start of the plant
  void Add(const ControllerState<W>& control, int step) {
    for (; recorded_ < watch_.count && step >= start_ + duration_ * (recorded_ + 1) / watch_.count;
         ++recorded_) {
      for (std::size_t lane = 0; lane < watch_.of_genomes.size(); ++lane) {
        Sighting& sighting = watch_.of_genomes[lane].emplace_back();
        sighting.rule = control.rule[static_cast<int>(lane)];
        for (std::size_t sense = 0; sense < senses_; ++sense) {
          sighting.senses.push_back(
              Encode(control.senses[sense][static_cast<int>(lane)], edges_.low, edges_.high));
        }
      }
    }
  }

 private:
  std::size_t senses_;
  Edges edges_;
  int start_, duration_;
  Watch watch_;
  int recorded_ = 0;
};

}  // namespace gaitsmith
