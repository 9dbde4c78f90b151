// SPDX-License-Identifier: MIT
// A figure and its world as a MuJoCo model (MJCF), with its start and its poses as keyframes. Lengths are in
// metres, x points along the ground and z away from it; a slope tilts gravity instead.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "core/physics/mechanism.h"
#include "core/world/terrain.h"
#include "shell/export/exporters.h"
#include "shell/export/moving_bones.h"
#include "shell/export/number_text.h"
#include "shell/export/xml_text.h"

namespace gaitsmith::shell {

namespace {

constexpr double kStepS = 0.002;        // of MuJoCo
constexpr int kPoseSteps = 25;          // between poses
constexpr double kTouchRadiusM = 0.01;  // of the balls at the rods' ends, which alone touch the ground
constexpr double kBeyondM = 50.0;       // how far a drawn ground goes on level at both ends
constexpr double kStiffness = 20.0;     // of a joint's servo, in weights times the longest rod per radian

std::string Nine(double value) { return Digits(value, 9); }
std::string Triple(double x, double y, double z) { return Nine(x) + " " + Nine(y) + " " + Nine(z); }

class MujocoText {
 public:
  MujocoText(const Document& document, const Motion& motion)
      : document_(document), motion_(motion), bones_(motion), body_(document.figure) {
    Walk(0);
  }

  std::string Whole() {
    const Environment& world = document_.environment;
    const SineCosine slope = SinCos(world.slope_rad);
    const auto gravity = static_cast<double>(world.gravity_mps2);
    return "<mujoco model=\"" + EscapedXml(document_.figure.name) +
           "\">\n  <compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n  <option timestep=\"" +
           Nine(kStepS) + "\" integrator=\"implicitfast\" cone=\"elliptic\" impratio=\"10\" gravity=\"" +
           Triple(-gravity * static_cast<double>(slope.sine), 0.0,
                  -gravity * static_cast<double>(slope.cosine)) +
           "\"/>\n  <default>\n    <geom friction=\"" + Nine(static_cast<double>(world.friction)) +
           " 0.005 0.0001\" solref=\"0.004 1\" solimp=\"0.99 0.999 0.001\" contype=\"0\" "
           "conaffinity=\"0\"/>\n    <default class=\"ground\">\n      <geom "
           "conaffinity=\"1\" "
           "rgba=\"0.86 0.83 0.77 1\"/>\n    </default>\n    <default class=\"rod\">\n      <geom "
           "type=\"capsule\" "
           "rgba=\"0.114 0.153 0.2 1\"/>\n    </default>\n    <default class=\"touch\">\n      <geom "
           "type=\"sphere\" size=\"" +
           Nine(kTouchRadiusM) +
           "\" contype=\"1\" rgba=\"0.114 0.153 0.2 1\"/>\n    </default>\n  </default>\n  <worldbody>\n" +
           "    <light pos=\"0 -3 4\" dir=\"0 0.6 -0.8\" mode=\"trackcom\"/>\n" + Ground() +
           BodyText(0, "    ") + "  </worldbody>\n" + Actuators() + "  <keyframe>\n" + Keys() +
           "  </keyframe>\n</mujoco>\n";
  }

 private:
  [[nodiscard]] const Skeleton::Limb& Limb(int bone) const {
    return body_.limbs[static_cast<std::size_t>(bone)];
  }
  [[nodiscard]] bool Turns(int bone) const { return Limb(bone).max_rad > Limb(bone).min_rad; }
  [[nodiscard]] double TorqueNm(int bone) const {
    return static_cast<double>(body_.torque_nm[static_cast<std::size_t>(bone)]);
  }
  /// Limp joints have none.
  [[nodiscard]] bool HasServo(int bone) const { return document_.model == 1 || TorqueNm(bone) > 0.0; }
  static std::string JointName(int bone) { return "joint " + std::to_string(bone); }

  /// MuJoCo numbers bodies and joints depth first.
  void Walk(int bone) {
    if (bone > 0 && Turns(bone)) order_.push_back(bone);
    for (int child = bone + 1; child < bones_.Count(); ++child) {
      if (bones_.ParentOf(child) == bone) Walk(child);
    }
  }

  /// The balls' centres are at the rods' ends, so the ground is a radius lower.
  [[nodiscard]] std::string Ground() const {
    const Terrain terrain(document_.environment.ground);
    if (terrain.Level())
      return "    <geom name=\"ground\" class=\"ground\" type=\"plane\" size=\"0 0 1\" pos=\"" +
             Triple(0.0, 0.0, -kTouchRadiusM) + "\"/>\n";
    constexpr double kThickM = 0.5;
    const std::vector<Corner>& corners = document_.environment.ground;
    const double left = static_cast<double>(corners.front().x_m) - kBeyondM;
    const double right = static_cast<double>(corners.back().x_m) + kBeyondM;
    std::string text;
    for (const Terrain::Face& face : terrain.Faces()) {
      // Along a level face at the end only as far as the ground is drawn.
      const double from = face.x < left ? (left - face.x) / face.ux : 0.0;
      const double to = face.ux > 0.0 ? std::min(face.length, (right - face.x) / face.ux) : face.length;
      const double middle = 0.5 * (from + to), below = 0.5 * kThickM + kTouchRadiusM;
      text += "    <geom class=\"ground\" type=\"box\" size=\"" +
              Triple(0.5 * (to - from), 1.0, 0.5 * kThickM) + "\" pos=\"" +
              Triple(face.x + middle * face.ux + below * face.uy, 0.0,
                     face.y + middle * face.uy - below * face.ux) +
              "\" xyaxes=\"" + Triple(face.ux, 0.0, face.uy) + " 0 1 0\"/>\n";
    }
    return text;
  }

  [[nodiscard]] std::string BodyText(int bone, const std::string& indent) const {
    const double length = bones_.LengthM(bone), mass = static_cast<double>(Limb(bone).mass_kg);
    const double inertia = mass * length * length / 12.0;
    const std::string in = indent + "  ";
    std::string text = indent + "<body name=\"" + bones_.NameOf(bone) + "\" pos=\"" +
                       Triple(bones_.JointM(bone), 0.0, 0.0) + "\"";
    if (bone > 0) text += " euler=\"" + Triple(0.0, -static_cast<double>(Limb(bone).rest_rad), 0.0) + "\"";
    text += ">\n";
    if (bone == 0) {
      text += in + "<joint name=\"forth\" type=\"slide\" axis=\"1 0 0\"/>\n" + in +
              "<joint name=\"up\" type=\"slide\" axis=\"0 0 1\"/>\n" + in +
              "<joint name=\"turn\" axis=\"0 -1 0\"/>\n";
    } else if (Turns(bone)) {
      text += in + "<joint name=\"" + JointName(bone) + "\" axis=\"0 -1 0\" limited=\"true\" range=\"" +
              Nine(static_cast<double>(Limb(bone).min_rad)) + " " +
              Nine(static_cast<double>(Limb(bone).max_rad)) + "\"/>\n";
    }
    // Nothing turns about a rod's own axis, so any third moment of inertia will do.
    text += in + "<inertial pos=\"" + Triple(0.5 * length, 0.0, 0.0) + "\" mass=\"" + Nine(mass) +
            "\" diaginertia=\"" + Triple(inertia, inertia, inertia) + "\"/>\n";
    text += in + "<geom class=\"rod\" fromto=\"0 0 0 " + Triple(length, 0.0, 0.0) + "\" size=\"" +
            Nine(0.5 * bones_.ThicknessM()) + "\"/>\n";
    if (bone == 0) text += in + "<geom class=\"touch\"/>\n";
    text += in + "<geom class=\"touch\" pos=\"" + Triple(length, 0.0, 0.0) + "\"/>\n";
    for (int child = bone + 1; child < bones_.Count(); ++child) {
      if (bones_.ParentOf(child) == bone) text += BodyText(child, in);
    }
    return text + indent + "</body>\n";
  }

  /// A servo for each joint. Its target is the joint's angle against the drawn pose, as in gaitsmith.h.
  [[nodiscard]] std::string Actuators() const {
    if (std::ranges::none_of(order_, [this](int bone) { return HasServo(bone); })) return "";
    const double unit = static_cast<double>(body_.mass_kg) * static_cast<double>(kStandardGravity) *
                        static_cast<double>(body_.longest_rod_m);
    std::string text = "  <actuator>\n";
    for (const int bone : order_) {
      if (!HasServo(bone)) continue;
      const std::string name = JointName(bone);
      text += "    <position name=\"" + name + "\" joint=\"" + name + "\" kp=\"" + Nine(kStiffness * unit) +
              "\" dampratio=\"1\" ctrllimited=\"true\" ctrlrange=\"" +
              Nine(static_cast<double>(Limb(bone).min_rad)) + " " +
              Nine(static_cast<double>(Limb(bone).max_rad)) + "\"";
      if (document_.model > 1) {
        const double torque = TorqueNm(bone);
        text += " forcelimited=\"true\" forcerange=\"" + Nine(-torque) + " " + Nine(torque) + "\"";
      }
      text += "/>\n";
    }
    return text + "  </actuator>\n";
  }

  [[nodiscard]] std::string Key(const std::string& name, int frame, bool moving) const {
    const auto start = bones_.Start(frame);
    std::string place = Triple(start[0], start[1], bones_.AngleRad(frame, 0)), rates, targets;
    for (const int bone : order_) {
      const std::string angle = Nine(static_cast<double>(motion_.AngleRad(frame, bone - 1)));
      place += " " + angle;
      rates += " " + Nine(static_cast<double>(motion_.RateRadps(frame, bone - 1)));
      if (HasServo(bone)) targets += (targets.empty() ? "" : " ") + angle;
    }
    std::string text = "    <key name=\"" + name + "\" qpos=\"" + place + "\"";
    if (moving) {
      // The figure starts as one body, about its centre of mass.
      const StartState& begin = document_.start;
      const auto spin = static_cast<double>(begin.spin_radps);
      const Motion::Point from_centre = motion_.Endpoint(frame, 0);
      text += " qvel=\"" +
              Triple(static_cast<double>(begin.velocity_x_mps) - spin * static_cast<double>(from_centre.y),
                     static_cast<double>(begin.velocity_y_mps) + spin * static_cast<double>(from_centre.x),
                     spin) +
              rates + "\"";
    }
    return text + (targets.empty() ? "" : " ctrl=\"" + targets + "\"") + "/>\n";
  }

  [[nodiscard]] std::string Keys() const {
    std::string text = Key("start", 0, true);
    for (int frame = kPoseSteps; frame < motion_.Frames(); frame += kPoseSteps)
      text += Key(Decimal(0.01 * frame, 2) + " s", frame, false);
    return text;
  }

  const Document& document_;
  const Motion& motion_;
  MovingBones bones_;
  Mechanism body_;
  std::vector<int> order_;  // bones with a joint, as MuJoCo has them
};

}  // namespace

std::string MujocoModel(const Document& document, const Motion& motion, const ExportOptions&) {
  return MujocoText(document, motion).Whole();
}

}  // namespace gaitsmith::shell
