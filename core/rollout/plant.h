// SPDX-License-Identifier: MIT
// What a physical model has to offer, so that controllers can drive it and it can be scored, recorded, handed
// over and hashed. core/physics/figure_plant.h is the first one.
#pragma once

#include <array>
#include <concepts>

#include "core/physics/environment.h"
#include "core/physics/figure.h"
#include "core/physics/snapshot.h"
#include "core/physics/terms.h"
#include "core/physics/trajectory_hash.h"
#include "core/signal/actuator_targets.h"
#include "core/signal/ports.h"
#include "core/signal/readings.h"
#include "core/signal/time.h"

namespace gaitsmith {

/// P simulates kLanes bodies side by side, one in each lane of the vector types of numeric/lane.h. No lane
/// may influence another one, and a lane's bits must not depend on the number of lanes. Its types and
/// members:
///
///   kLanes, kModel        number of lanes; the version of the physical model, >= 1, that documents name
///   Body                  topology and constants, made from a valid figure; outlives its plants. How far
///                         bodies may differ from lane to lane is the plant's own affair
///   State                 everything that changes, of all lanes; LaneState: that of a plant of one lane
///   CountPorts, PortsOf   actuators and contacts: in [0, kMaxActuators] and [0, kMaxContacts]
///
///   P(body, environment, start, step_s)   at rest in its drawn pose, or moving as the start says
///   Save(), Restore()     saves and restores: what follows has the same bits
///   BeginAt(state)        puts every lane where one body is, and measures distance, greatest height, slip
///   and
///                         turns from there. A body that broke physics stays broken
///   Give(push)            an impulse [N s] between two steps
///   Step(step, targets)   advances by step_s [s]. step: number of the step since the start, from 0.
///                         targets: [rad] for joints, with time constants
///   Read()                what controllers and style meters read, in physical units
///   Upright()             cosine of the turn from the drawn pose, [-1, 1]; HeadHeight(): above ground [m]
///   TermsOf(lane)         primary and paper's terms since the start, or since BeginAt
///   AddTo(hash, lane)     the positions of the present step; whatever differs in them differs in the hash
///   Observe(lane)         for recorded motions
///   ContactPoint(i, lane) of contact i relative to the centre of mass [m], x along the ground, y away from
///   it ContactForce(i, lane) of the ground in the last step [N], along the ground and away from it
template <class P>
concept Plant = requires(P plant, const P seen, const Figure& figure, const typename P::Body& body,
                         const Push& push, const ActuatorTargets<P::kLanes>& targets,
                         const typename P::LaneState& lane_state, TrajectoryHash& hash, int number) {
  requires P::kLanes >= 1 && P::kModel >= 1;
  requires std::constructible_from<typename P::Body, const Figure&>;
  { P::CountPorts(figure) } -> std::same_as<PortCount>;
  { P::PortsOf(body) } -> std::same_as<Ports>;
  requires std::constructible_from<P, const typename P::Body&, const Environment&, const StartState&, float>;
  { seen.Save() } -> std::same_as<const typename P::State&>;
  plant.Restore(seen.Save());
  plant.BeginAt(lane_state);
  plant.Give(push);
  plant.Step(number, targets);
  { seen.Read() } -> std::same_as<Readings<P::kLanes>>;
  { seen.Upright() } -> std::same_as<typename Lane<P::kLanes>::F>;
  { seen.HeadHeight() } -> std::same_as<typename Lane<P::kLanes>::F>;
  { seen.TermsOf(number) } -> std::same_as<Terms>;
  seen.AddTo(hash, number);
  { seen.Observe(number) } -> std::same_as<Snapshot>;
  { seen.ContactPoint(number, number) } -> std::same_as<std::array<float, 2>>;
  { seen.ContactForce(number, number) } -> std::same_as<std::array<float, 2>>;
};

}  // namespace gaitsmith
