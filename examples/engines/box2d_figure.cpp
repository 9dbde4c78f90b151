// SPDX-License-Identifier: MIT
// A document's figure in Box2D 2.4, driven by gaitsmith.h:   box2d_figure DOC [seconds] [substeps]
// Builds a body for each rod and a revolute joint with a motor where they meet, over level ground. Prints how
// the figure moved, as JSON. planck_body.mjs and play.mjs do the same in JavaScript.
#include <box2d/box2d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "core/physics/mechanism.h"
#include "core/runtime/gaitsmith.h"
#include "shell/export/exporters.h"

namespace {

using namespace gaitsmith;  // NOLINT: a program of one file

constexpr float kStepS = 0.01f;
constexpr float kBallM = 0.01f;  // at the ends of rods, which alone touch the ground
// Box2D lets bodies overlap by one slop, and lines are thicker than they look.
constexpr float kGroundM = -kBallM - b2_polygonRadius + b2_linearSlop;
constexpr float kFollowsRad = 0.05f;  // how far a joint may be from where the runtime has it

/// Sums the impulses of the ground on each endpoint.
class Pushes : public b2ContactListener {
 public:
  std::array<float, kMaxEndpoints> impulse_ns{};

  void PostSolve(b2Contact* contact, const b2ContactImpulse* given) override {
    for (b2Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
      const auto endpoint = fixture->GetUserData().pointer;  // counted from 1; 0: the ground
      if (endpoint > 0) impulse_ns[endpoint - 1] += given->normalImpulses[0];
    }
  }
};

class Figure2d {
 public:
  Figure2d(const Document& document, int substeps)
      : body_(document.figure), world_({0.0f, -document.environment.gravity_mps2}), substeps_(substeps) {
    const float friction = document.environment.friction;
    b2BodyDef still;
    b2EdgeShape line;
    line.SetTwoSided({-1e4f, kGroundM}, {1e4f, kGroundM});
    b2FixtureDef ground;
    ground.shape = &line;
    ground.friction = friction;
    world_.CreateBody(&still)->CreateFixture(&ground);
    world_.SetContactListener(&pushes);

    std::vector<b2Vec2> ends(1, b2Vec2(0.0f, 0.0f));
    std::vector<float> angles;
    for (int i = 0; i < body_.rods; ++i) {
      const Skeleton::Limb& limb = Limb(i);
      const float parent = limb.parent < 0 ? 0.0f : angles[static_cast<std::size_t>(limb.parent)];
      angles.push_back(i == 0 ? body_.start_angle_rad : parent + limb.rest_rad);
      const b2Vec2 start = ends[static_cast<std::size_t>(limb.start)];
      ends.emplace_back(start.x + limb.length_m * std::cos(angles.back()),
                        start.y + limb.length_m * std::sin(angles.back()));
    }
    const float lowest =
        std::min_element(ends.begin(), ends.end(), [](b2Vec2 a, b2Vec2 b) { return a.y < b.y; })->y;
    for (int i = 0; i < body_.rods; ++i) {
      const Skeleton::Limb& limb = Limb(i);
      b2BodyDef placed;
      placed.type = b2_dynamicBody;
      placed.position = ends[static_cast<std::size_t>(limb.start)] - b2Vec2(0.0f, lowest);
      placed.angle = angles[static_cast<std::size_t>(i)];
      placed.allowSleep = false;
      b2Body* rod = world_.CreateBody(&placed);
      if (i == 0) AddBall(*rod, 0.0f, 0, friction);
      AddBall(*rod, limb.length_m, i + 1, friction);
      b2MassData mass;
      mass.mass = limb.mass_kg;
      mass.center.Set(0.5f * limb.length_m, 0.0f);
      mass.I = limb.inertia_kgm2 +
               0.25f * limb.mass_kg * limb.length_m * limb.length_m;  // about the body's origin
      rod->SetMassData(&mass);
      rods_.push_back(rod);
      if (i == 0) continue;
      b2RevoluteJointDef joint;
      joint.Initialize(rods_[static_cast<std::size_t>(limb.parent)], rod, placed.position);
      joint.enableMotor = true;  // without limits of its own: the runtime keeps within them
      joint.maxMotorTorque = document.model == 1
                                 ? 100.0f * body_.mass_kg * kStandardGravity * body_.longest_rod_m
                                 : body_.torque_nm[static_cast<std::size_t>(i)];
      joints_.push_back(static_cast<b2RevoluteJoint*>(world_.CreateJoint(&joint)));
    }
  }

  Pushes pushes;

  [[nodiscard]] int Joints() const { return body_.joints; }
  [[nodiscard]] int Endpoints() const { return body_.endpoints; }
  [[nodiscard]] b2RevoluteJoint& Joint(int joint) const { return *joints_[static_cast<std::size_t>(joint)]; }
  void Advance() {
    pushes.impulse_ns = {};
    for (int i = 0; i < substeps_; ++i) world_.Step(kStepS / static_cast<float>(substeps_), 20, 8);
  }
  /// Of the centre of mass: place [m] and velocity [m/s].
  [[nodiscard]] std::array<b2Vec2, 2> Centre() const {
    b2Vec2 place(0.0f, 0.0f), velocity(0.0f, 0.0f);
    for (const b2Body* rod : rods_) {
      place += rod->GetMass() / body_.mass_kg * rod->GetWorldCenter();
      velocity += rod->GetMass() / body_.mass_kg * rod->GetLinearVelocity();
    }
    return {place, velocity};
  }

 private:
  [[nodiscard]] const Skeleton::Limb& Limb(int rod) const {
    return body_.limbs[static_cast<std::size_t>(rod)];
  }

  static void AddBall(b2Body& rod, float along_m, int endpoint, float friction) {
    b2CircleShape ball;
    ball.m_radius = kBallM;
    ball.m_p.Set(along_m, 0.0f);
    b2FixtureDef fixture;
    fixture.shape = &ball;
    fixture.friction = friction;
    fixture.filter.groupIndex = -1;
    fixture.userData.pointer = static_cast<std::uintptr_t>(endpoint) + 1;
    rod.CreateFixture(&fixture);
  }

  Mechanism body_;
  b2World world_;
  int substeps_;
  std::vector<b2Body*> rods_;
  std::vector<b2RevoluteJoint*> joints_;
};

/// What the figure feels, in the order of the controller's senses (docs/runtime.md).
void Feel(const Controller& kind, const Figure2d& figure, const gaitsmith_controller& controller,
          std::array<float, GAITSMITH_SENSES>& senses) {
  std::size_t count = 0;
  const auto feel = [&](float reading) {
    senses[count] = kind.kind == ControllerKind::kNetwork
                        ? reading
                        : gaitsmith_normalise(&controller, static_cast<int>(count), reading);
    ++count;
  };
  const auto angles = [&] {
    for (int j = 0; j < figure.Joints(); ++j) feel(figure.Joint(j).GetJointAngle());
  };
  const auto forces = [&] {
    for (int k = 0; k < figure.Endpoints(); ++k)
      feel(figure.pushes.impulse_ns[static_cast<std::size_t>(k)] / kStepS);
  };
  if (kind.kind == ControllerKind::kNetwork) {
    forces();
    angles();
    return;
  }
  if (kind.kind == ControllerKind::kTrajectory || kind.senses.kind == SenseKind::kTimer)
    return;  // the runtime counts
  const auto [place, velocity] = figure.Centre();
  angles();
  forces();
  feel(place.y);
  feel(velocity.y);
  if (kind.senses.kind != SenseKind::kSight) return;
  feel(0.0f);  // level ground: nothing is higher ahead,
  feel(1e6f);  // and there is no corner
}

}  // namespace

int main(int count, char** words) {
  std::ifstream file(count > 1 ? words[1] : "");
  const auto document = DecodeJson(std::string(std::istreambuf_iterator<char>(file), {}));
  if (!document || !shell::HasController(*document) || document->figure.HasSprings()) {
    std::fprintf(stderr, "box2d_figure DOC [seconds] [substeps]: %s\n",
                 !document                       ? document.error().Sentence().c_str()
                 : document->figure.HasSprings() ? "it is a figure of springs, and bodies here are of rods"
                                                 : "it has no controller");
    return 1;
  }
  const std::string text = shell::ControllerJson(*document);
  const auto controller = std::make_unique<gaitsmith_controller>();
  gaitsmith_state state;
  std::size_t where = 0;
  if (gaitsmith_load(controller.get(), text.data(), text.size(), &where) != GAITSMITH_OK) return 1;
  Figure2d figure(*document, count > 3 ? std::max(1, std::atoi(words[3])) : 2);
  std::array<float, GAITSMITH_JOINTS> angle{}, rate{};
  std::array<float, GAITSMITH_SENSES> senses{};
  gaitsmith_begin(controller.get(), &state);
  const float from = figure.Centre()[0].x;
  const int steps = static_cast<int>(100.0 * (count > 2 ? std::atof(words[2]) : 10.0));
  for (int step = 0; step < steps; ++step) {
    for (int j = 0; j < figure.Joints(); ++j) {
      const auto i = static_cast<std::size_t>(j);
      const float now = figure.Joint(j).GetJointAngle();
      // A motor that is too weak, or a limb that is held: the joint goes on from where it is.
      if (std::abs(now - angle[i]) > kFollowsRad) {
        angle[i] = now;
        rate[i] = figure.Joint(j).GetJointSpeed();
      }
      gaitsmith_move(controller.get(), &state, j, &angle[i], &rate[i]);
      figure.Joint(j).SetMotorSpeed((angle[i] - now) / kStepS);
    }
    figure.Advance();
    Feel(document->controllers[static_cast<std::size_t>(document->timeline[0].controller)], figure,
         *controller, senses);
    gaitsmith_step(controller.get(), &state, senses.data());
  }
  std::printf("{\"engine\":\"box2d\",\"x_m\":%.3f,\"height_m\":%.3f}\n",
              static_cast<double>(figure.Centre()[0].x - from), static_cast<double>(figure.Centre()[0].y));
  return 0;
}
