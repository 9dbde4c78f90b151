// SPDX-License-Identifier: MIT
// The interface of a physical model. A model that satisfies it can be driven by controllers, scored,
// recorded, handed over and hashed. core/physics/figure_plant.h is the first one.
#pragma once

#include <array>
#include <concepts>

#include "core/physics/figure.h"
#include "core/physics/snapshot.h"
#include "core/physics/terms.h"
#include "core/physics/trajectory_hash.h"
#include "core/signal/actuator_targets.h"
#include "core/signal/ports.h"
#include "core/signal/readings.h"
#include "core/signal/time.h"
#include "core/world/environment.h"

namespace gaitsmith {

/// P simulates kLanes bodies side by side, one in each lane of the vector types of numeric/lane.h. Lanes must
/// not influence each other, and a lane's bits must not depend on the number of lanes. Its types and members:
///
///   kLanes, kModel        number of lanes; the version of the physical model in documents, >= 1
///   Body                  topology and constants, made from a valid figure; outlives its plants. The plant
///                         decides how far bodies may differ from lane to lane
///   State, LaneState      everything that changes, of all lanes; of a plant of one lane
///   Muscles               measures the impulses of the actuators, [N m s] for joints: see physics/muscles.h.
///                         A plant that knows their work says that: see springs/spring_muscles.h
///   CountPorts, PortsOf   actuators and contacts: in [0, kMaxActuators] and [0, kMaxContacts]
///
///   P(body, environment, start, step_s)   in its drawn pose, at rest or moving as in start
///   Save(), Restore()     saves and restores; the motion continues with the same bits
///   BeginAt(state)        copies the state of one body into every lane, and measures distance, greatest
///                         height, slip and turns from there. A body that broke physics stays broken
///   Give(push)            applies an impulse [N s] between two steps
///   Step(step, targets)   advances by step_s [s]. step: number of the step since the start, from 0.
///                         targets: [rad] for joints, with time constants
///   Read()                the readings for controllers and style meters, in physical units
///   Upright()             cosine of the turn from the drawn pose, [-1, 1]
///   HeadHeight()          height of the head above ground [m]
///   TermsOf(lane)         primary and paper's terms since the start, or since BeginAt
///   AddTo(hash, lane)     hashes the positions of the present step; different positions, different hash
///   Observe(lane)         the snapshot for recorded motions
///   ContactPoint(i, lane) position of contact i relative to the centre of mass [m], x along the ground,
///                         y away from it
///   ContactForce(i, lane) force of the ground in the last step [N], along the ground and away from it
template <class P>
concept Plant = requires(P plant, const P seen, const Figure& figure, const typename P::Body& body,
                         const Push& push, const ActuatorTargets<P::kLanes>& targets,
                         const typename P::LaneState& lane_state, TrajectoryHash& hash, int number) {
  requires P::kLanes >= 1 && P::kModel >= 1;
  requires std::constructible_from<typename P::Body, const Figure&>;
  requires std::constructible_from<typename P::Muscles, const typename P::Body&, float>;
  requires std::copyable<typename P::Muscles::Memory>;
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
