// SPDX-License-Identifier: MIT
// Figures of springs beside Chipmunk and Box2D, where they are installed: the same worm, pulled by the same
// muscles, on level ground with friction. Rounds in turn within one run; processor time. Each rival at the
// step and iterations that its manual recommends; nodes do not collide with each other, nothing is drawn, and
// rests are given.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/springs/spring_plant.h"
#ifdef GAITSMITH_CHIPMUNK
#include <chipmunk/chipmunk.h>
#endif
#ifdef GAITSMITH_BOX2D
#include <box2d/box2d.h>
#endif

namespace {

using namespace gaitsmith;

constexpr int kSeconds = 20;  // of motion in a round
constexpr int kRounds = 9;

/// Two rows of six nodes, held together by 26 springs. Four of the lower row are muscles.
Figure Worm() {
  Figure figure;
  for (int i = 0; i < 12; ++i)
    figure.nodes.push_back({0.2f * static_cast<float>(i / 2), 0.2f * static_cast<float>(i % 2), 0.1f});
  const auto add = [&](int from, int to) {
    figure.springs.push_back({.from = from, .to = to, .stiffness_npm = 400.0f, .damping_nspm = 1.0f});
  };
  for (int i = 0; i < 12; i += 2) add(i, i + 1);
  for (int i = 0; i + 2 < 12; ++i) add(i, i + 2);
  for (int i = 0; i + 2 < 12; i += 2) {
    add(i, i + 3);
    add(i + 1, i + 2);
  }
  for (const std::size_t muscle : {6U, 8U, 10U, 12U}) {
    figure.springs[muscle].min_rest = 0.7f;
    figure.springs[muscle].max_rest = 1.3f;
  }
  return figure;
}

/// The rest of a muscle, over its drawn length, at a time: a wave.
float RestAt(int muscle, float time_s) {
  return 1.0f + 0.25f * std::sin(6.0f * time_s + 1.5f * static_cast<float>(muscle));
}

volatile float sink;

template <int W>
void Ours() {
  const Lattice body(Worm());
  SpringPlant<W> plant(body, {}, {}, kStep);
  ActuatorTargets<W> targets{};
  for (int step = 0; step < kSeconds * 100; ++step) {
    for (std::size_t j = 0; j < body.muscles; ++j) {
      targets.target[j] = Lane<W>::Splat(RestAt(static_cast<int>(j), static_cast<float>(step) * kStep));
      targets.decay[j] = Lane<W>::Splat(0.6f);
      targets.inverse_tau[j] = Lane<W>::Splat(20.0f);
    }
    plant.Step(step, targets);
  }
  sink = static_cast<float>(plant.Observe(0).x_m);
}

#ifdef GAITSMITH_CHIPMUNK
void Chipmunk() {
  const Figure worm = Worm();
  cpSpace* space = cpSpaceNew();
  cpSpaceSetGravity(space, cpv(0.0, -9.8));
  cpShape* ground =
      cpSpaceAddShape(space, cpSegmentShapeNew(cpSpaceGetStaticBody(space), cpv(-100, 0), cpv(100, 0), 0.0));
  cpShapeSetFriction(ground, 0.8);
  std::vector<cpBody*> bodies;
  std::vector<cpShape*> shapes;
  for (const Node& node : worm.nodes) {
    cpBody* body = cpSpaceAddBody(
        space, cpBodyNew(static_cast<double>(node.mass_kg), std::numeric_limits<double>::infinity()));
    cpBodySetPosition(body, cpv(static_cast<double>(node.x_m), static_cast<double>(node.y_m) + 0.01));
    shapes.push_back(cpSpaceAddShape(space, cpCircleShapeNew(body, 0.01, cpvzero)));
    cpShapeSetFriction(shapes.back(), 1.0);
    cpShapeSetFilter(shapes.back(), cpShapeFilterNew(1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
    bodies.push_back(body);
  }
  std::vector<cpConstraint*> springs;
  std::vector<std::size_t> muscles;
  for (std::size_t i = 0; i < worm.springs.size(); ++i) {
    const Spring& spring = worm.springs[i];
    springs.push_back(cpSpaceAddConstraint(
        space, cpDampedSpringNew(
                   bodies[static_cast<std::size_t>(spring.from)], bodies[static_cast<std::size_t>(spring.to)],
                   cpvzero, cpvzero, static_cast<double>(DrawnLength(worm, spring)),
                   static_cast<double>(spring.stiffness_npm), static_cast<double>(spring.damping_nspm))));
    if (spring.IsMuscle()) muscles.push_back(i);
  }
  for (int step = 0; step < kSeconds * 60; ++step) {
    for (std::size_t j = 0; j < muscles.size(); ++j) {
      const float rest = RestAt(static_cast<int>(j), static_cast<float>(step) / 60.0f);
      cpDampedSpringSetRestLength(springs[muscles[j]],
                                  static_cast<double>(DrawnLength(worm, worm.springs[muscles[j]]) * rest));
    }
    cpSpaceStep(space, 1.0 / 60.0);
  }
  sink = static_cast<float>(cpBodyGetPosition(bodies[0]).x);
  for (cpConstraint* each : springs) {
    cpSpaceRemoveConstraint(space, each);
    cpConstraintFree(each);
  }
  for (cpShape* each : shapes) {
    cpSpaceRemoveShape(space, each);
    cpShapeFree(each);
  }
  for (cpBody* each : bodies) {
    cpSpaceRemoveBody(space, each);
    cpBodyFree(each);
  }
  cpSpaceRemoveShape(space, ground);
  cpShapeFree(ground);
  cpSpaceFree(space);
}
#endif

#ifdef GAITSMITH_BOX2D
void Box2d() {
  const Figure worm = Worm();
  b2World world({0.0f, -9.8f});
  world.SetAllowSleeping(false);
  b2BodyDef fixed;
  b2EdgeShape line;
  line.SetTwoSided({-100.0f, 0.0f}, {100.0f, 0.0f});
  world.CreateBody(&fixed)->CreateFixture(&line, 0.0f)->SetFriction(0.8f);
  std::vector<b2Body*> bodies;
  for (const Node& node : worm.nodes) {
    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    moving.fixedRotation = true;
    moving.position = {node.x_m, node.y_m + 0.01f};
    b2Body* body = world.CreateBody(&moving);
    b2CircleShape point;
    point.m_radius = 0.01f;
    b2FixtureDef made;
    made.shape = &point;
    made.density = node.mass_kg / (b2_pi * 0.01f * 0.01f);
    made.friction = 0.8f;
    made.filter.groupIndex = -1;
    body->CreateFixture(&made);
    bodies.push_back(body);
  }
  std::vector<b2DistanceJoint*> muscles;
  for (const Spring& spring : worm.springs) {
    b2Body *from = bodies[static_cast<std::size_t>(spring.from)],
           *to = bodies[static_cast<std::size_t>(spring.to)];
    b2DistanceJointDef joint;
    joint.Initialize(from, to, from->GetPosition(), to->GetPosition());
    joint.minLength = 0.0f;
    joint.maxLength = 10.0f;
    joint.stiffness = spring.stiffness_npm;
    joint.damping = spring.damping_nspm;
    auto* made = static_cast<b2DistanceJoint*>(world.CreateJoint(&joint));
    if (spring.IsMuscle()) muscles.push_back(made);
  }
  const float drawn = muscles.front()->GetLength();
  for (int step = 0; step < kSeconds * 60; ++step) {
    for (std::size_t j = 0; j < muscles.size(); ++j)
      muscles[j]->SetLength(drawn * RestAt(static_cast<int>(j), static_cast<float>(step) / 60.0f));
    world.Step(1.0f / 60.0f, 8, 3);
  }
  sink = bodies[0]->GetPosition().x;
}
#endif

struct Rival {
  std::string name;
  int figures;  // that a round simulates
  std::function<void()> round;
  std::vector<double> us_per_second = {};  // microseconds of the processor for a second of one figure
  float x_m = 0.0f;
};

}  // namespace

int main() {
  std::vector<Rival> rivals = {
      {"ours, 1 lane", 1, Ours<1>}, {"ours, 4 lanes", 4, Ours<4>}, {"ours, 8 lanes", 8, Ours<8>}};
#ifdef GAITSMITH_CHIPMUNK
  rivals.push_back({"Chipmunk", 1, Chipmunk});
#endif
#ifdef GAITSMITH_BOX2D
  rivals.push_back({"Box2D", 1, Box2d});
#endif
  for (int round = 0; round < kRounds; ++round) {
    for (Rival& one : rivals) {
      const std::clock_t start = std::clock();
      one.round();
      const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      one.us_per_second.push_back(spent * 1e6 / kSeconds / one.figures);
      one.x_m = sink;
    }
  }
  std::vector<double> medians;
  for (Rival& one : rivals) {
    std::ranges::nth_element(one.us_per_second, one.us_per_second.begin() + kRounds / 2);
    medians.push_back(one.us_per_second[kRounds / 2]);
  }
  const double best = *std::min_element(medians.begin(), medians.begin() + 3);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    std::printf("%-14s %8.2f us for a second of a worm, %6.2f times our best; it went %.2f m\n",
                rivals[i].name.c_str(), medians[i], medians[i] / best, static_cast<double>(rivals[i].x_m));
  }
}
