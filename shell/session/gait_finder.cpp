// SPDX-License-Identifier: MIT
#include "shell/session/gait_finder.h"

#include "core/gait/document_loop.h"

namespace gaitsmith::shell {

namespace {

/// A search that improves, or a person who drags, changes the motion again sooner.
constexpr double kUnchangedS = 0.8;

}  // namespace

bool GaitFinder::Advance(double seconds) {
  const Playback& player = workspace_.Player();
  if (!player.Loaded()) return false;
  const std::uint64_t hash = player.Shown().Hash();
  if (hash != hash_) {
    hash_ = hash;
    rested_s_ = 0.0;
    looked_ = false;
    const bool gone = cycle_.has_value();
    cycle_.reset();
    return gone;
  }
  rested_s_ += seconds;
  if (looked_ || rested_s_ < kUnchangedS) return false;
  looked_ = true;
  if (hash == 0) return false;  // as planned, not as simulated
  const auto found = ShownLoopOf(workspace_.Doc(), player.Shown(), false);
  if (!found) return false;
  cycle_ = found->loop.cycle;
  distance_m_ = found->loop.distance_m;
  return true;
}

}  // namespace gaitsmith::shell
