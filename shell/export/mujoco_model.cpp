// SPDX-License-Identifier: MIT
// A figure and its world as a MuJoCo model (MJCF), with its start and its poses as keyframes. Lengths are in
// metres, x points along the ground and z away from it; a slope tilts gravity instead.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
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
constexpr double kDeepM = 1.0, kHalfWidthM = 1.0;  // of a drawn ground
constexpr double kLeastPieceM = 1e-4;              // of it
constexpr double kStiffness = 20.0;  // of a joint's servo, in weights times the longest rod per radian

// Only the balls at the rods' ends touch, and only the ground. Contacts are firm and grip, as in Gaitsmith.
constexpr std::string_view kClasses =
    R"( 0.005 0.0001" solref="0.004 1" solimp="0.99 0.999 0.001" contype="0" conaffinity="0"/>
    <default class="ground">
      <geom conaffinity="1" rgba="0.86 0.83 0.77 1"/>
    </default>
    <default class="rod">
      <geom type="capsule" rgba="0.114 0.153 0.2 1"/>
    </default>
    <default class="touch">
      <geom type="sphere" contype="1" rgba="0.114 0.153 0.2 1"/>
    </default>
  </default>
)";

std::string Nine(double value) { return Digits(value, 9); }
std::string Triple(double x, double y, double z) { return Nine(x) + " " + Nine(y) + " " + Nine(z); }

class MujocoText {
 public:
  MujocoText(const Document& document, const Motion& motion, bool from_start)
      : document_(document),
        motion_(motion),
        bones_(motion),
        body_(document.figure),
        from_start_(from_start) {
    Walk(0);
    AddGround();
  }

  std::string Whole() {
    const Environment& world = document_.environment;
    const SineCosine slope = SinCos(world.slope_rad);
    const auto gravity = static_cast<double>(world.gravity_mps2);
    std::string text = "<mujoco model=\"" + EscapedXml(document_.figure.name) + "\">\n";
    text += "  <compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n";
    text += "  <option timestep=\"" + Nine(kStepS) +
            "\" integrator=\"implicitfast\" cone=\"elliptic\" impratio=\"10\" gravity=\"" +
            Triple(-gravity * static_cast<double>(slope.sine), 0.0,
                   -gravity * static_cast<double>(slope.cosine)) +
            "\"/>\n";
    text += "  <default>\n    <geom friction=\"" + Nine(static_cast<double>(world.friction));
    text += kClasses;
    if (!assets_.empty()) text += "  <asset>\n" + assets_ + "  </asset>\n";
    text += "  <worldbody>\n    <light pos=\"0 -3 4\" dir=\"0 0.6 -0.8\" mode=\"trackcom\"/>\n" + ground_;
    text += BodyText(0, "    ") + "  </worldbody>\n" + Actuators();
    return text + "  <keyframe>\n" + Keys() + "  </keyframe>\n</mujoco>\n";
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

  /// The balls' centres are at the rods' ends, so the ground is a radius lower. What is below each face is a
  /// convex piece: nothing sticks out beyond it.
  void AddGround() {
    const Terrain terrain(document_.environment.ground);
    if (terrain.Level()) {
      ground_ = "    <geom name=\"ground\" class=\"ground\" type=\"plane\" size=\"0 0 1\" pos=\"" +
                Triple(0.0, 0.0, -kTouchRadiusM) + "\"/>\n";
      return;
    }
    const std::vector<Corner>& corners = document_.environment.ground;
    const double left = static_cast<double>(corners.front().x_m) - kBeyondM;
    const double right = static_cast<double>(corners.back().x_m) + kBeyondM;
    const double bottom = static_cast<double>(std::ranges::min(corners, {}, &Corner::y_m).y_m) - kDeepM;
    int piece = 0;
    for (const Terrain::Face& face : terrain.Faces()) {
      const double from = std::max(face.x, left), to = std::min(face.x + face.length * face.ux, right);
      if (to - from < kLeastPieceM) continue;  // a vertical face is the side of its neighbour
      const double lower = kTouchRadiusM / face.ux;
      const auto height = [&](double x) { return face.y + (x - face.x) * face.uy / face.ux - lower; };
      std::string vertices;
      for (const double y : {-kHalfWidthM, kHalfWidthM}) {
        vertices.append(Triple(from, y, bottom) + " " + Triple(to, y, bottom) + " ");
        vertices.append(Triple(from, y, height(from)) + " " + Triple(to, y, height(to)) + " ");
      }
      ++piece;
      const std::string name = "ground " + std::to_string(piece);
      assets_.append("    <mesh name=\"")
          .append(name)
          .append("\" vertex=\"")
          .append(vertices)
          .append("\"/>\n");
      ground_.append("    <geom class=\"ground\" type=\"mesh\" mesh=\"").append(name).append("\"/>\n");
    }
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
    if (bone == 0) text += in + "<geom class=\"touch\" size=\"" + Nine(kTouchRadiusM) + "\"/>\n";
    text += in + "<geom class=\"touch\" size=\"" + Nine(kTouchRadiusM) + "\" pos=\"" +
            Triple(length, 0.0, 0.0) + "\"/>\n";
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
      text.append("    <position name=\"").append(name).append("\" joint=\"").append(name);
      text += "\" kp=\"" + Nine(kStiffness * unit) + "\" dampratio=\"1\" ctrllimited=\"true\" ctrlrange=\"" +
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

  /// How fast the root moves and turns at first. A figure that starts as its document says is one body, about
  /// its centre of mass. Other motions begin with limbs that move.
  [[nodiscard]] std::string RootRates() const {
    const StartState& start = document_.start;
    if (from_start_) {
      const auto spin = static_cast<double>(start.spin_radps);
      const Motion::Point from_centre = motion_.Endpoint(0, 0);
      return Triple(static_cast<double>(start.velocity_x_mps) - spin * static_cast<double>(from_centre.y),
                    static_cast<double>(start.velocity_y_mps) + spin * static_cast<double>(from_centre.x),
                    spin);
    }
    constexpr double kPerSecond = 100.0;
    const int next = std::min(1, motion_.Frames() - 1);
    const auto now = bones_.Start(0), then = bones_.Start(next);
    return Triple(kPerSecond * (then[0] - now[0]), kPerSecond * (then[1] - now[1]),
                  kPerSecond * (bones_.AngleRad(next, 0) - bones_.AngleRad(0, 0)));
  }

  [[nodiscard]] std::string Key(const std::string& name, int frame) const {
    const auto start = bones_.Start(frame);
    std::string place = Triple(start[0], start[1], bones_.AngleRad(frame, 0)), rates, targets;
    for (const int bone : order_) {
      const std::string angle = Nine(static_cast<double>(motion_.AngleRad(frame, bone - 1)));
      place += " " + angle;
      rates += " " + Nine(static_cast<double>(motion_.RateRadps(frame, bone - 1)));
      if (HasServo(bone)) targets += (targets.empty() ? "" : " ") + angle;
    }
    std::string text = "    <key name=\"" + name + "\" qpos=\"" + place + "\"";
    if (frame == 0) text += " qvel=\"" + RootRates() + rates + "\"";
    return text + (targets.empty() ? "" : " ctrl=\"" + targets + "\"") + "/>\n";
  }

  [[nodiscard]] std::string Keys() const {
    std::string text = Key("start", 0);
    for (int frame = kPoseSteps; frame < motion_.Frames(); frame += kPoseSteps)
      text += Key(Decimal(0.01 * frame, 2) + " s", frame);
    return text;
  }

  const Document& document_;
  const Motion& motion_;
  MovingBones bones_;
  Mechanism body_;
  bool from_start_;
  std::string ground_, assets_;
  std::vector<int> order_;  // bones with a joint, as MuJoCo has them
};

}  // namespace

std::string MujocoModel(const Document& document, const Motion& motion, const ExportOptions& options) {
  return MujocoText(document, motion, options.from_start).Whole();
}

}  // namespace gaitsmith::shell
