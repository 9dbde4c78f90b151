// SPDX-License-Identifier: MIT
// Every number of model version 1 that is neither in a document nor derived: its unit, why it has this value,
// and what breaks when it changes. Changing any of them changes the bits of every motion ever shared.
#pragma once

#include "core/signal/ports.h"
#include "core/signal/time.h"

namespace gaitsmith {

/// Version of the physical model. Documents name it; a later model gets a new number and this one stays.
inline constexpr int kModelVersion = 1;

/// Most rods of a figure. Sixteen holds a horse or a spider; the lanes' state grows with it.
inline constexpr int kMaxRods = 16;
inline constexpr int kMaxJoints = kMaxRods - 1;
inline constexpr int kMaxEndpoints = kMaxRods + 1;
static_assert(kMaxJoints <= kMaxActuators && kMaxEndpoints <= kMaxContacts);

/// An endpoint predicted to end the step lower than this above ground [m] takes part in the contact solution.
/// Must exceed the half g h^2 (0.5 mm) by which the flight prediction differs; larger only costs time.
inline constexpr float kContactMargin = 0.005f;

/// Most sweeps over the contacts of one step where three or more endpoints meet the ground (one and two are
/// solved exactly). With 20, 1,000 random figures dropped stiff are lifted by 3.2 mm at most.
inline constexpr int kContactSweeps = 20;

/// Contacts are solved when no velocity is wrong by more than this [m/s]: a tenth of a micrometre in ten
/// steps, and above the rounding of ordinary velocities.
inline constexpr float kContactTolerance = 1e-6f;

/// Endpoints closer than this along the ground [m] are not solved as two: what tells them apart would be
/// rounding.
inline constexpr float kLeastStance = 1e-3f;

/// Times a step's contacts are solved at most: again where the first solution threw further endpoints against
/// the ground, or turned the arms it was computed with by more than kArmTurn [rad], as landings do. With one,
/// dropped figures are lifted by up to 34 mm where the landing of one end slams the other down.
inline constexpr int kContactRounds = 2;
inline constexpr float kArmTurn = 1e-3f;

/// A joint slower than this is at rest [rad/s]: its decay would end in numbers too small to be fast.
inline constexpr float kRestRate = 1e-9f;

/// A motion is void when an endpoint is found deeper than this [m] before it is lifted: the search would
/// otherwise learn to shoot itself out of the ground.
inline constexpr float kMaxPenetration = 0.02f;

/// A motion is void when the ground does more work on the figure in one step than this share of M g l (l the
/// longest rod, g standard gravity): as the contact solver sees it, and as the endpoints then really went,
/// where no loss of friction's can hide a gain. A gait's landings are lifted by up to 1.2 mm, a tenth of it;
/// 32,400 random motions of the shipped figures, thrown at up to 20 m/s, really gained up to a
/// sixth of it.
inline constexpr float kMaxGroundWork = 1e-2f;

/// A motion is void when the root turns further than this in one step [rad]: the step no longer resolves it.
inline constexpr float kMaxTurnPerStep = 0.5f;

/// The same for the turn with which the arms of its contacts were computed [rad]: they are those of half of
/// it, and Turn() holds up to 0.5. A blow to one end of a figure that lies would otherwise be answered on
/// arms that nobody has. 32,400 random motions of the shipped figures, thrown at up to 20 m/s, foresaw 0.43.
inline constexpr float kMaxForeseenTurn = 2.0f * kMaxTurnPerStep;

}  // namespace gaitsmith
