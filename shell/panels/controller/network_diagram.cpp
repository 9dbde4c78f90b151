// SPDX-License-Identifier: MIT
#include "shell/panels/controller/network_diagram.h"

#include <algorithm>
#include <cmath>

#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kPitch = 24.0f;  // between nodes of a column
constexpr float kNode = 6.5f;    // radius

/// Layout of one network, and the inputs that fire at this moment.
struct Diagram {
  const NetworkShape& shape;
  const Controller& controller;
  ImRect rect;
  std::uint64_t firing;

  [[nodiscard]] bool Fires(int input) const { return (firing >> input & 1u) != 0; }
  [[nodiscard]] ImVec2 NodeCentre(float column, int index, int count) const {
    const float height = rect.GetHeight();
    const float y = rect.Min.y + (static_cast<float>(index) + 0.5f) * height / static_cast<float>(count);
    return {rect.Min.x + column * rect.GetWidth(), y};
  }
  [[nodiscard]] ImVec2 Input(int input) const {
    const int sensors = shape.touches + shape.joints;
    return input < sensors ? NodeCentre(0.24f, input, sensors)
                           : NodeCentre(0.54f, input - sensors, shape.hidden);
  }
  [[nodiscard]] ImVec2 Node(int node) const {
    return shape.IsActuator(node) ? NodeCentre(0.80f, node - shape.hidden, shape.joints)
                                  : NodeCentre(0.54f, node, shape.hidden);
  }
};

void DrawWeights(Ui& ui, const Diagram& diagram) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const NetworkShape& shape = diagram.shape;
  // Edges with a firing input are drawn over the others.
  for (const bool live : {false, true}) {
    for (int node = 0; node < shape.Nodes(); ++node) {
      for (int input = 0; input < shape.Inputs(); ++input) {
        if (diagram.Fires(input) != live) continue;
        const float weight =
            Decode(diagram.controller.genes[shape.Weight(node, input)], -kMaxWeight, kMaxWeight);
        const float share = std::abs(weight) / kMaxWeight;
        // Weak edges would blur into a grey cloud.
        if (share < (live ? 0.25f : 0.6f)) continue;
        const ImVec2 from = diagram.Input(input), to = diagram.Node(node);
        const ImU32 colour =
            Fade(weight > 0.0f ? p.good : p.bad, live ? 0.35f + 0.5f * share : 0.10f * share);
        if (from.x < to.x) {
          list->AddLine({from.x + kNode, from.y}, {to.x - kNode, to.y}, colour, live ? 1.5f : 1.0f);
        } else {
          // From one hidden node to another, or to itself: an arc beside the column.
          const float side = 16.0f + 0.12f * std::abs(from.y - to.y);
          list->AddBezierCubic({from.x + kNode, from.y}, {from.x + side, from.y - 4.0f},
                               {to.x + side, to.y + 4.0f}, {to.x + kNode, to.y}, colour, live ? 1.5f : 1.0f);
        }
      }
    }
  }
}

void DrawNodes(Ui& ui, const Diagram& diagram, const Session& session) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const NetworkShape& shape = diagram.shape;
  const auto draw = [&](ImVec2 at, bool fires) {
    list->AddCircleFilled(at, kNode, fires ? p.ink : p.panel);
    list->AddCircle(at, kNode, fires ? p.ink : p.second_ink, 0, 1.5f);
  };
  for (int input = 0; input < shape.Inputs(); ++input) {
    const ImVec2 at = diagram.Input(input);
    draw(at, diagram.Fires(input));
    if (input < shape.touches + shape.joints) {
      ui.Letters().Draw(list, Type::kSmall, {at.x - kNode - 6.0f, at.y}, p.second_ink,
                        TrSentence(InputName(shape, input)), Align::kRight);
    }
  }
  const Motion& motion = session.Player().Shown();
  const Skeleton& bones = motion.Bones();
  for (int joint = 0; joint < shape.joints; ++joint) {
    const ImVec2 at = diagram.Node(shape.hidden + joint);
    const Skeleton::Limb& limb = bones.limbs[static_cast<std::size_t>(joint) + 1];
    const float share =
        (motion.AngleRad(session.Player().Frame(), joint) - limb.min_rad) * limb.inverse_range;
    const float width = 40.0f, x = at.x - kNode;
    list->AddRectFilled({x, at.y - 4.0f}, {x + width, at.y + 4.0f}, p.soft, 4.0f);
    list->AddRectFilled({x, at.y - 4.0f}, {x + width * std::clamp(share, 0.0f, 1.0f), at.y + 4.0f}, p.ink,
                        4.0f);
    ui.Letters().Draw(list, Type::kSmall, {x + width + 6.0f, at.y}, p.second_ink, std::to_string(joint + 1));
  }
}

std::string FiringWords(const Diagram& diagram) {
  std::string words;
  for (int input = 0; input < diagram.shape.Inputs(); ++input) {
    if (diagram.Fires(input))
      words += (words.empty() ? "" : ", ") + TrSentence(InputName(diagram.shape, input));
  }
  return words.empty() ? Tr("no node is on") : Tr("on: {1}", words);
}

}  // namespace

void DrawNetwork(Ui& ui, const Session& session, const Controller& controller) {
  const Motion& motion = session.Player().Shown();
  const Motion::Frame& now = motion.At(session.Player().Frame());
  const NetworkShape shape(controller.rules, motion.Bones().rods);
  const int tallest = std::max({shape.touches + shape.joints, shape.hidden, shape.joints});
  ui.Paragraph(Tr("Filled: on. Green raises, red lowers. Bars: the joints' angles."), Type::kNote);
  ui.Gap(6.0f);
  const ImRect row = ui.Row(kPitch * static_cast<float>(tallest));
  const Diagram diagram{shape, controller, row, now.clip == session.Timeline().Selected() ? now.firing : 0};
  const Touch touch = ui.Area("controller/network", row, Grab::kPress,
                              {.label = Tr("Network of {1} hidden nodes", shape.hidden),
                               .role = "img",
                               .value = FiringWords(diagram)});
  if (touch.visible) {
    DrawWeights(ui, diagram);
    DrawNodes(ui, diagram, session);
    ui.DrawFocus(touch, row, 9.0f);
  }
}

}  // namespace gaitsmith::shell
