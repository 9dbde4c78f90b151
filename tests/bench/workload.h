// SPDX-License-Identifier: MIT
// The workloads of the benchmarks: a document and genomes for it, the same bits in every program and run.
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

/// Random genomes, as at the start of a search.
[[nodiscard]] Workload RandomGenomes(const Document&);

/// Perturbations of the result of a short search, as at the end of a search. Contacts differ from those of
/// random genomes.
[[nodiscard]] Workload Gaits(const Document&);

// The scenario for comparison with other engines: Mr. Star-Man's joints follow targets that change every half
// second, with a time constant of 0.1 s, on flat ground of friction 1, for 10 s. Every figure has different
// targets, so that no lane is a copy of another.
inline constexpr int kPeerSteps = 1000;
inline constexpr int kPeerTargets = 20;
inline constexpr float kPeerTauS = 0.1f;
inline constexpr float kPeerFriction = 1.0f;
[[nodiscard]] Workload Peers();
/// The same in model 2, all joints with the standard strength.
[[nodiscard]] Workload LimitedPeers();

/// Target angle of a joint of one of Peers() during an interval, relative to its rest angle [rad].
[[nodiscard]] float PeerTarget(const Workload& peers, int figure, int interval, int joint);

/// A workload by name: "random", "gait", "timer" (random), "timer-gait", "peers", "peers-limited". Cached
/// after the first call, because gaits require a search.
[[nodiscard]] const Workload& WorkloadOf(std::string_view name);
inline constexpr std::string_view kWorkloads[] = {"random",     "gait",  "timer",
                                                  "timer-gait", "peers", "peers-limited"};

}  // namespace gaitsmith::bench
