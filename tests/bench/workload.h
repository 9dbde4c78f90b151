// SPDX-License-Identifier: MIT
// What the benchmarks simulate: a document and genomes for it, the same bits in every program and run.
#pragma once

#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith::bench {

struct Workload {
  Document document;
  std::vector<Genome> genomes;
};

/// A multiple of every lane count.
inline constexpr int kGenomes = 64;

/// Mr. Star-Man with an empty controller, 5 s, ten rules.
[[nodiscard]] Document StarMan(SenseKind);

/// Genomes as a search starts with.
[[nodiscard]] Workload RandomGenomes(const Document&);

/// Genomes as a search ends with: perturbations of what a short one found. An evolved gait meets the ground
/// otherwise than a random bank does.
[[nodiscard]] Workload Gaits(const Document&);

// The scenario on which other engines were measured: Mr. Star-Man's joints follow targets that change every
// half second, with a time constant of 0.1 s, on flat ground of friction 1, for 10 s. Every figure has
// targets of its own, so that no lane is a copy of another.
inline constexpr int kPeerSteps = 1000;
inline constexpr int kPeerTargets = 20;
inline constexpr float kPeerTauS = 0.1f;
inline constexpr float kPeerFriction = 1.0f;
[[nodiscard]] Workload Peers();

/// Angle that a joint of one of Peers() is driven to during an interval, against its rest angle [rad].
[[nodiscard]] float PeerTarget(const Workload& peers, int figure, int interval, int joint);

/// By name: "random", "gait", "timer" (random), "timer-gait", "peers". Made when first asked for, then kept:
/// gaits take a search.
[[nodiscard]] const Workload& WorkloadOf(std::string_view name);
inline constexpr std::string_view kWorkloads[] = {"random", "gait", "timer", "timer-gait", "peers"};

}  // namespace gaitsmith::bench
