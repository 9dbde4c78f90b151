// SPDX-License-Identifier: MIT
#include "shell/panels/figure/spring_form.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "shell/panels/figure/drawing_board.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

struct Form {
  Ui& ui;
  Session& session;
  SpringBoardState& state;

  [[nodiscard]] const Figure& Now() const { return session.Doc().figure; }
  bool Replace(Figure figure) const {
    figure.name = kOwnFigure;
    return session.ReplaceFigure(figure);
  }
  /// Numbers do not make it another figure.
  void Change(const Figure& figure) const { session.ReplaceFigure(figure); }
};

/// A switch for each other node: whether a spring leads there.
void EditTies(const Form& form) {
  const int from = form.state.chosen.index;
  std::vector<std::string> names;
  std::vector<int> free;
  for (int to = 0; to < static_cast<int>(form.Now().nodes.size()); ++to) {
    const bool tied = std::ranges::any_of(form.Now().springs, [&](const Spring& spring) {
      return std::minmax(spring.from, spring.to) == std::minmax(from, to);
    });
    if (to == from || tied) continue;
    free.push_back(to);
    names.push_back(Tr("Node {1}", to + 1));
  }
  if (names.empty()) return;
  int chosen = -1;
  if (form.ui.Combo("springs/join", Tr("New spring to"), names, chosen, Tr("Choose a node")) && chosen >= 0)
    form.Replace(WithSpring(form.Now(), from, free[static_cast<std::size_t>(chosen)],
                            form.state.MirrorOf(form.Now())));
}

void EditNode(const Form& form) {
  const int index = form.state.chosen.index;
  const Node node = form.Now().nodes[static_cast<std::size_t>(index)];
  double mass = static_cast<double>(node.mass_kg);
  if (form.ui.Slider("springs/mass", Tr("Mass"), mass,
                     {.low = 0.01, .high = 20.0, .step = 0.01, .logarithmic = true},
                     Fixed(node.mass_kg, 2) + " kg")) {
    Node changed = node;
    changed.mass_kg = static_cast<float>(mass);
    form.Change(WithNode(form.Now(), index, changed, form.state.MirrorOf(form.Now())));
  }
  // Whole centimetres, as on the board.
  constexpr double kAround = 3.0;
  for (const auto& [id, label, axis] : {std::tuple("springs/x", Tr("Place along the ground"), &Node::x_m),
                                        std::tuple("springs/y", Tr("Height"), &Node::y_m)}) {
    double place = static_cast<double>(node.*axis);
    if (!form.ui.Slider(id, label, place, {.low = -kAround, .high = kAround, .step = 0.01},
                        Fixed(node.*axis, 2) + " m"))
      continue;
    Node changed = node;
    changed.*axis = static_cast<float>(place);
    form.Change(WithNode(form.Now(), index, changed, form.state.MirrorOf(form.Now())));
  }
  EditTies(form);
}

void EditMuscle(const Form& form, const Spring& spring, const std::function<void(const Spring&)>& change) {
  bool muscle = spring.IsMuscle();
  if (form.ui.Switch("springs/muscle", Tr("Muscle: the controller sets its length"), muscle))
    form.Change(WithMuscleToggled(form.Now(), form.state.chosen.index, form.state.MirrorOf(form.Now())));
  if (!spring.IsMuscle()) return;
  double least = 100.0 * static_cast<double>(spring.min_rest);
  double most = 100.0 * static_cast<double>(spring.max_rest);
  const double rest = 100.0 * static_cast<double>(spring.rest);
  Spring changed = spring;
  constexpr double kRoom = 0.5;  // [%], below which a slider would have no end
  if (rest > 20.0 + kRoom &&
      form.ui.Slider("springs/shortest", Tr("At its shortest"), least,
                     {.low = 20.0, .high = rest, .step = 1.0}, Fixed(least, 0) + " %")) {
    changed.min_rest = std::min(static_cast<float>(least / 100.0), spring.rest);
    change(changed);
  }
  if (rest < 300.0 - kRoom &&
      form.ui.Slider("springs/longest", Tr("At its longest"), most, {.low = rest, .high = 300.0, .step = 1.0},
                     Fixed(most, 0) + " %")) {
    changed.max_rest = std::max(static_cast<float>(most / 100.0), spring.rest);
    change(changed);
  }
}

void EditSpring(const Form& form) {
  const int index = form.state.chosen.index;
  const Spring spring = form.Now().springs[static_cast<std::size_t>(index)];
  const std::function<void(const Spring&)> change = [&](const Spring& changed) {
    form.Change(WithSpringAs(form.Now(), index, changed, form.state.MirrorOf(form.Now())));
  };
  double stiffness = static_cast<double>(spring.stiffness_npm);
  double damping = static_cast<double>(spring.damping_nspm);
  Spring changed = spring;
  if (form.ui.Slider("springs/stiffness", Tr("Stiffness"), stiffness,
                     {.low = 1.0, .high = 100'000.0, .step = 1.0, .logarithmic = true},
                     Fixed(spring.stiffness_npm, 0) + " N/m")) {
    changed.stiffness_npm = static_cast<float>(stiffness);
    change(changed);
  }
  if (form.ui.Slider("springs/damping", Tr("Damping"), damping,
                     {.low = 0.1, .high = 1000.0, .step = 0.1, .logarithmic = true},
                     Fixed(spring.damping_nspm, 1) + " N s/m")) {
    changed = spring;
    changed.damping_nspm = static_cast<float>(damping);
    change(changed);
  }
  // A muscle begins with it. The controller changes it then.
  double rest = 100.0 * static_cast<double>(spring.rest);
  const bool muscle = spring.IsMuscle();
  if (form.ui.Slider("springs/rest", Tr("Length without force"), rest,
                     {.low = muscle ? 100.0 * static_cast<double>(spring.min_rest) : 20.0,
                      .high = muscle ? 100.0 * static_cast<double>(spring.max_rest) : 300.0,
                      .step = 1.0},
                     Fixed(rest, 0) + " %")) {
    changed = spring;
    changed.rest = static_cast<float>(rest / 100.0);
    if (muscle)
      changed.rest = std::clamp(changed.rest, spring.min_rest, spring.max_rest);
    else
      changed.min_rest = changed.max_rest = changed.rest;
    change(changed);
  }
  EditMuscle(form, spring, change);
}

void DrawChoice(const Form& form) {
  static constexpr std::array<const char*, 2> kKinds = {TrLater("Nodes"), TrLater("Springs")};
  SpringPart& chosen = form.state.chosen;
  int kind = static_cast<int>(chosen.kind);
  if (form.ui.Segmented("springs/kind", form.ui.ControlRow(), Tr("What is chosen"), kKinds, kind)) {
    chosen = {static_cast<SpringPart::Kind>(kind), 0};
    KeepChosen(form.Now(), form.state);
  }
  form.ui.Gap(6.0f);
  const bool node = chosen.kind == SpringPart::Kind::kNode;
  const auto count = static_cast<int>(node ? form.Now().nodes.size() : form.Now().springs.size());
  int number = chosen.index + 1;
  form.ui.Number("springs/number",
                 node ? Tr("Node {1} of {2}", number, count) : Tr("Spring {1} of {2}", number, count), number,
                 1, count);
  chosen.index = number - 1;
}

/// What the board does by hand, for those who have none.
void DrawActions(const Form& form) {
  const ImRect row = form.ui.ControlRow();
  const float middle = row.GetCenter().x;
  const bool node = form.state.chosen.kind == SpringPart::Kind::kNode;
  const bool room = static_cast<int>(form.Now().nodes.size()) < kMaxPoints;
  const auto before = static_cast<int>(form.Now().nodes.size());
  if (form.ui.Button("springs/add", {row.Min, {middle - 4.0f, row.Max.y}}, Tr("Add a node"),
                     ButtonLook::kOutlined, room && node)) {
    if (form.Replace(WithNodeGrown(form.Now(), form.state.chosen.index, form.state.MirrorOf(form.Now()))))
      form.state.chosen = {SpringPart::Kind::kNode, before};
  }
  const Figure rest = Without(form.Now(), form.state.chosen, form.state.MirrorOf(form.Now()));
  if (form.ui.Button("springs/delete", {{middle + 4.0f, row.Min.y}, row.Max}, Tr("Delete"),
                     ButtonLook::kOutlined, !rest.springs.empty()) &&
      form.Replace(rest)) {
    form.state.chosen.index = 0;
  }
  if (room) return;
  form.ui.Gap(4.0f);
  form.ui.Paragraph(Tr("A figure has at most {1} nodes.", kMaxPoints), Type::kNote);
}

void DrawStiffness(const Form& form) {
  form.ui.Fact(Tr("All of it"), StiffnessWords(form.Now()));
  const ImRect row = form.ui.ControlRow();
  const float middle = row.GetCenter().x;
  if (form.ui.Button("springs/softer", {row.Min, {middle - 4.0f, row.Max.y}}, Tr("Make it softer")))
    form.Change(WithStiffness(form.Now(), 0.5f));
  if (form.ui.Button("springs/stiffer", {{middle + 4.0f, row.Min.y}, row.Max}, Tr("Make it stiffer")))
    form.Change(WithStiffness(form.Now(), 2.0f));
}

}  // namespace

const char* SpringToolWords(const Figure& figure, const SpringBoardState& state) {
  if (state.blank) return Tr("Drag across the board: that is the first spring.");
  if (figure.Muscles() == 0 && figure.springs.size() > 2)
    return Tr("Tap a spring: it becomes a muscle, and the figure can learn to move.");
  return Tr(state.tool == SpringTool::kDraw ? "Tap: a node. Drag: a spring. Tap a spring: a muscle."
                                            : "Drag a node to move it. Tap a node or a spring to choose it.");
}

void DrawSpringForm(Ui& ui, Session& session, SpringBoardState& state) {
  KeepChosen(session.Doc().figure, state);
  const Form form{ui, session, state};
  bool symmetric = state.symmetric;
  if (ui.Switch("springs/symmetric", Tr("Symmetric: both sides at once"), symmetric))
    state.symmetric = symmetric;
  ui.Gap(8.0f);
  DrawChoice(form);
  if (state.chosen.kind == SpringPart::Kind::kNode) {
    EditNode(form);
  } else {
    EditSpring(form);
  }
  ui.Gap(8.0f);
  DrawActions(form);
  ui.Gap(10.0f);
  DrawStiffness(form);
}

}  // namespace gaitsmith::shell
