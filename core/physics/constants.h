// SPDX-License-Identifier: MIT
// Every constant of model version 1 that is neither in a document nor derived: its unit, why it has this
// value, and what breaks when it changes. Changing any of them changes the bits of every motion ever shared.
#pragma once

#include "core/signal/ports.h"
#include "core/signal/time.h"

namespace gaitsmith {

/// Maximum number of rods in a figure. 16 are enough for a horse or a spider. The size of the lanes' state
/// grows with it.
inline constexpr int kMaxRods = 16;
inline constexpr int kMaxJoints = kMaxRods - 1;
inline constexpr int kMaxEndpoints = kMaxRods + 1;
/// Maximum number of nodes and springs in a figure of springs, and of muscles among them.
inline constexpr int kMaxPoints = 24;
inline constexpr int kMaxSprings = 64;
inline constexpr int kMaxMuscles = 15;
static_assert(kMaxJoints <= kMaxActuators && kMaxEndpoints <= kMaxContacts);
/// A figure of springs must not vibrate faster than this, as bounded by FastestVibration() [1/s^2]: 64
/// substeps of a step of 0.01 s then resolve it.
inline constexpr float kStiffest = 4.0e7f;
/// Lengths without force, over the drawn ones.
inline constexpr float kLeastRest = 0.2f, kMostRest = 3.0f;
static_assert(kMaxMuscles <= kMaxActuators && kMaxPoints <= kMaxContacts);

/// An endpoint takes part in the contact solution if it is predicted to end the step lower than this above
/// the ground [m]. Must exceed the half g h^2 (0.5 mm) by which the flight prediction differs. A larger value
/// only costs time.
inline constexpr float kContactMargin = 0.005f;

/// Maximum number of sweeps over the contacts of one step when three or more endpoints meet the ground (one
/// and two are solved exactly). With 20 sweeps, 1,000 random figures dropped with stiff joints are lifted by
/// 3.2 mm at most.
inline constexpr int kContactSweeps = 20;

/// Contacts count as solved when no velocity is wrong by more than this [m/s]. That is a tenth of a
/// micrometre in ten steps, and above the rounding error of ordinary velocities.
inline constexpr float kContactTolerance = 1e-6f;

/// Two endpoints closer than this along the ground [m] are not solved as a pair, because their distance would
/// be mostly rounding error.
inline constexpr float kMinStance = 1e-3f;

/// Maximum number of times that one step's contacts are solved. They are solved again if the first solution
/// throws further endpoints against the ground, or turns the contact arms by more than kArmTurn [rad], as
/// landings do. With one round, dropped figures are lifted by up to 34 mm when the landing of one end slams
/// the other end down.
inline constexpr int kContactRounds = 2;
inline constexpr float kArmTurn = 1e-3f;

/// A joint slower than this is set to rest [rad/s], because its decay would end in denormal numbers, which
/// are slow.
inline constexpr float kRestRate = 1e-9f;

/// A motion is void when an endpoint is deeper than this [m] before it is lifted out of the ground. Otherwise
/// the search would learn to shoot figures out of the ground.
inline constexpr float kMaxPenetration = 0.02f;

/// A motion is void when the ground does more work on the figure in one step than this share of M g l (l the
/// longest rod, g standard gravity). The work is checked twice: as the contact solver computes it, and along
/// the endpoints' actual paths, where a loss by friction cannot hide a gain. Lifting the landings of a gait
/// (up to 1.2 mm) takes a tenth of this limit. In 32,400 random motions of the shipped figures, thrown at up
/// to 20 m/s, the actual gain reached a sixth of it.
inline constexpr float kMaxGroundWork = 1e-2f;

/// A motion is void when the root turns further than this in one step [rad], because the time step no longer
/// resolves the turn.
inline constexpr float kMaxTurnPerStep = 0.5f;

/// A motion is void when the turn predicted for its contacts exceeds this in one step [rad]. The contact arms
/// are computed at half of that turn, and Turn() is accurate up to 0.5. Without this limit, a blow to one end
/// of a lying figure would be answered with wrong arms. In 32,400 random motions of the shipped figures,
/// thrown at up to 20 m/s, the predicted turn reached 0.43.
inline constexpr float kMaxForeseenTurn = 2.0f * kMaxTurnPerStep;

}  // namespace gaitsmith
