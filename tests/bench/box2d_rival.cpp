// SPDX-License-Identifier: MIT
#include "tests/bench/box2d_rival.h"

#include <box2d/box2d.h>

#include <array>
#include <cmath>

#include "core/physics/mechanism.h"

namespace gaitsmith::bench {

namespace {

constexpr float kHalfThicknessM = 0.02f;
/// Motor torque [N m], enough that prescribed joints never yield.
constexpr float kStrongNm = 1000.0f;
constexpr int kStepsPerTarget = kBox2dSteps / kPeerTargets;
constexpr std::size_t kPeerRods = 5;

b2Body* AddRod(b2World& world, const b2Vec2& hub, float angle_rad, const Rod& rod) {
  b2BodyDef placed;
  placed.type = b2_dynamicBody;
  placed.position = hub;
  placed.angle = angle_rad;
  placed.allowSleep = false;
  b2Body* body = world.CreateBody(&placed);
  b2PolygonShape box;
  box.SetAsBox(0.5f * rod.length_m, kHalfThicknessM, {0.5f * rod.length_m, 0.0f}, 0.0f);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.density = rod.mass_kg / (rod.length_m * 2.0f * kHalfThicknessM);
  fixture.friction = kPeerFriction;
  fixture.restitution = 0.0f;
  fixture.filter.groupIndex = -1;
  body->CreateFixture(&fixture);
  return body;
}

/// Greatest torque of a rod's joint [N m], as the document's model has it.
float MotorTorque(const Document& document, const Mechanism& body, std::size_t rod) {
  return document.model == 1 ? kStrongNm : body.torque_nm[rod];
}

}  // namespace

float RunInBox2d(const Workload& peers, int figure) {
  const std::vector<Rod>& rods = peers.document.figure.rods;
  const Mechanism body(peers.document.figure);  // its limbs are in the order of the star's rods
  b2World world({0.0f, -peers.document.environment.gravity_mps2});

  b2BodyDef still;
  b2EdgeShape line;
  line.SetTwoSided({-1000.0f, 0.0f}, {1000.0f, 0.0f});
  b2FixtureDef ground;
  ground.shape = &line;
  ground.friction = kPeerFriction;
  world.CreateBody(&still)->CreateFixture(&ground);

  // The lowest rods point down and outward, 1/5 turn apart. The figure starts standing on them.
  float deepest = 0.0f;
  for (std::size_t i = 1; i < rods.size(); ++i) {
    deepest = std::min(deepest, rods[i].length_m * std::sin(rods[0].rest_rad + rods[i].rest_rad));
  }
  const b2Vec2 hub(0.0f, -deepest + kHalfThicknessM);
  b2Body* root = AddRod(world, hub, rods[0].rest_rad, rods[0]);
  std::array<b2RevoluteJoint*, kPeerRods - 1> joints{};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    b2RevoluteJointDef joint;
    const float angle_rad = rods[0].rest_rad + rods[i + 1].rest_rad;
    joint.Initialize(root, AddRod(world, hub, angle_rad, rods[i + 1]), hub);
    joint.enableMotor = true;
    joint.maxMotorTorque = MotorTorque(peers.document, body, i + 1);
    joints[i] = static_cast<b2RevoluteJoint*>(world.CreateJoint(&joint));
  }

  for (int interval = 0; interval < kPeerTargets; ++interval) {
    std::array<float, kPeerRods - 1> targets{};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      targets[i] = PeerTarget(peers, figure, interval, static_cast<int>(i));
    }
    for (int step = 0; step < kStepsPerTarget; ++step) {
      for (std::size_t i = 0; i < joints.size(); ++i) {
        joints[i]->SetMotorSpeed((targets[i] - joints[i]->GetJointAngle()) / kPeerTauS);
      }
      world.Step(1.0f / 60.0f, 8, 3);
    }
  }
  return root->GetPosition().x;
}

}  // namespace gaitsmith::bench
