// SPDX-License-Identifier: MIT
#include "shell/stage/world_card.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/joints.h"
#include "core/numeric/scalar_math.h"
#include "shell/stage/ground/ground_form.h"
#include "shell/stage/live_switch.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kWidth = 290.0f;
constexpr float kButtonWidth = 78.0f;
constexpr double kDegree = kPi / 180.0;

std::string NameOfPlace(const Motion& motion, int endpoint) {
  if (endpoint == kCentreOfMass) return Tr("centre of mass");
  return Tr(motion.Connections().muscles ? "at node {1}" : "endpoint {1}", endpoint + 1);
}

void DrawSlopeAndGravity(Ui& ui, Session& session) {
  const Environment& world = session.Doc().environment;
  const auto change = [&](float Environment::* field, double value) {
    session.Change([&](Document& d) { d.environment.*field = static_cast<float>(value); });
  };
  double slope = static_cast<double>(world.slope_rad) / kDegree;
  if (ui.Slider("world/slope", Tr("Slope"), slope, {.low = -30.0, .high = 30.0, .step = 0.5},
                Tr(slope > 0.0   ? "{1}° up"
                   : slope < 0.0 ? "{1}° down"
                                 : "{1}°",
                   Fixed(slope, 1)))) {
    change(&Environment::slope_rad, slope * kDegree);
  }
  double sway = static_cast<double>(world.sway_rad) / kDegree;
  if (ui.Slider("world/sway", Tr("Rocking"), sway, {.low = 0.0, .high = 30.0, .step = 0.5},
                sway == 0.0 ? Tr("off") : "±" + Fixed(sway, 1) + "°")) {
    change(&Environment::sway_rad, sway * kDegree);
  }
  double period = static_cast<double>(world.sway_period_s);
  if (sway != 0.0 &&
      ui.Slider("world/sway-period", Tr("every"), period,
                {.low = 0.5, .high = 20.0, .step = 0.1, .logarithmic = true}, Fixed(period, 1) + " s")) {
    change(&Environment::sway_period_s, period);
  }
  double friction = static_cast<double>(world.friction);
  if (ui.Slider("world/friction", Tr("Friction"), friction, {.low = 0.0, .high = 2.0, .step = 0.05},
                Tr(friction < 0.15  ? "{1} ice"
                   : friction > 1.5 ? "{1} rubber"
                                    : "{1}",
                   Fixed(friction, 2)))) {
    change(&Environment::friction, friction);
  }
  double gravity = static_cast<double>(world.gravity_mps2);
  if (ui.Slider("world/gravity", Tr("Gravity"), gravity, {.low = 0.0, .high = 25.0, .step = 0.1},
                Fixed(gravity, 1) + " m/s²")) {
    change(&Environment::gravity_mps2, gravity);
  }
}

std::string StrengthWords(float strength) {
  const std::string number = Fixed(strength, 1);
  if (strength < 1.0f) return Tr("{1} weak", number);
  if (strength <= 4.0f) return Tr("{1} like an animal", number);
  return Tr(strength <= 10.0f ? "{1} strong" : "{1} like a machine", number);
}

void DrawJoints(Ui& ui, Session& session) {
  static constexpr std::array<const char*, 2> kLimits = {TrLater("Unlimited"), TrLater("Limited")};
  if (session.Doc().figure.Joints() == 0) return;
  ui.Heading(Tr("Joints"));
  int limited = HasLimitedJoints(session.Doc()) ? 1 : 0;
  const std::string why_not = GroundNeedsLimits(session.Doc())
                                  ? Tr("Drawn ground needs limited joints. Choose Level ground first.")
                                  : "";
  if (ui.Segmented("world/joints", ui.ControlRow(), Tr("How strong the joints are"), kLimits, limited,
                   why_not))
    session.World().LimitJoints(limited == 1);
  ui.Gap(4.0f);
  if (limited == 0) {
    ui.Paragraph(Tr("They always reach the pose of their rule, however hard that is."), Type::kNote);
    return;
  }
  const float present = JointStrength(session.Doc());
  double strength = static_cast<double>(present);
  if (ui.Slider("world/joint-strength", Tr("Strength"), strength,
                {.low = 0.5, .high = 20.0, .step = 0.1, .logarithmic = true}, StrengthWords(present))) {
    session.World().SetJointStrength(static_cast<float>(strength));
  }
  ui.Paragraph(Tr("1 holds the figure’s weight at the end of its longest rod."), Type::kNote);
  if (!why_not.empty()) {
    ui.Gap(4.0f);
    ui.Paragraph(why_not, Type::kNote);
  }
  if (HasUnequalRods(session.Doc())) {
    ui.Gap(4.0f);
    ui.Paragraph(Tr("The heaviest rod weighs {1} times as much as the lightest. Above {2}, motions may fail.",
                    Fixed(MassRatio(session.Doc().figure), 0), Fixed(kMostMassRatio, 0)),
                 ui.Ink().accent, Type::kNote);
  }
}

void DrawPushes(Ui& ui, Session& session, WorldCardState& state) {
  const Motion& motion = session.Player().Shown();
  const int endpoints = motion.Connections().contacts;
  const bool nodes = motion.Connections().muscles;
  ui.Heading(Tr("Push"));
  ui.Paragraph(nodes ? Tr("Pull at a node on the stage, or set it here.")
                     : Tr("Pull at a joint on the stage, or set it here."),
               Type::kNote);
  ui.Gap(6.0f);
  std::vector<std::string> places = {Tr("Centre of mass")};
  for (int k = 0; k < endpoints; ++k) places.push_back(Tr(nodes ? "Node {1}" : "Endpoint {1}", k + 1));
  state.endpoint = std::clamp(state.endpoint, 0, endpoints);
  ui.Combo("world/endpoint", Tr("Where"), places, state.endpoint);
  const double most = std::max(5.0, 8.0 * static_cast<double>(motion.Bones().mass_kg));
  state.strength_ns = std::min(state.strength_ns, most);
  ui.Slider("world/strength", Tr("Strength"), state.strength_ns, {.low = 0.5, .high = most, .step = 0.5},
            Fixed(state.strength_ns, 1) + " N s");
  ui.Slider("world/direction", Tr("Direction"), state.direction_deg,
            {.low = -180.0, .high = 180.0, .step = 5.0}, Fixed(state.direction_deg, 0) + "°");
  ui.Gap(6.0f);
  if (ui.Button("world/push", ui.ControlRow(), Tr("Push now"))) {
    const double angle = state.direction_deg * kDegree;
    session.World().Push(state.endpoint - 1, static_cast<float>(state.strength_ns * std::cos(angle)),
                         static_cast<float>(state.strength_ns * std::sin(angle)));
  }
  const auto& pushes = session.Doc().pushes;
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    const Push& push = pushes[i];
    const ImRect row = ui.ControlRow();
    const std::string words = Fixed(static_cast<float>(push.step) * kStep, 2) + " s · " +
                              Fixed(std::hypot(push.impulse_x_ns, push.impulse_y_ns), 1) + " N s · " +
                              NameOfPlace(motion, push.endpoint);
    ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {row.Min.x, row.GetCenter().y},
                            row.GetWidth() - row.GetHeight() - 4.0f, ui.Ink().second_ink, words);
    const ImRect button({row.Max.x - row.GetHeight(), row.Min.y}, row.Max);
    if (ui.IconButton("world/remove/" + std::to_string(i), button, Icon::kClose,
                      Tr("Remove the push at {1}", words))) {
      session.World().RemovePush(i);
      break;
    }
  }
}

// Found motions of figures with the same rods, newest first.
std::vector<const FoundMotions::Entry*> ComparableMotions(const Session& session) {
  constexpr std::size_t kMax = 12;  // fits on a phone
  std::vector<const FoundMotions::Entry*> motions;
  for (const FoundMotions::Entry* entry : session.Results().Motions().Sorted(FoundMotions::Order::kNewest)) {
    if (motions.size() == kMax) break;
    if (entry->motion.Moves() && SameTree(entry->motion.document.figure, session.Doc().figure))
      motions.push_back(entry);
  }
  return motions;
}

struct GhostChoice {
  std::string words;
  Ghost::Kind kind;
  int controller = -1;
  std::string found_id;
};

// @param chosen  receives the index of the present choice
std::vector<GhostChoice> GhostChoices(const Session& session, int& chosen) {
  using enum Ghost::Kind;
  std::vector<GhostChoice> choices = {
      {.words = Tr("Nothing"), .kind = kNone, .found_id = {}},
      {.words = Tr("Before the last search"), .kind = kEarlier, .found_id = {}},
      {.words = Tr("Without your changes"), .kind = kAsOpened, .found_id = {}}};
  for (int index = 0; const Controller& controller : session.Doc().controllers) {
    const std::string& name = controller.name;
    choices.push_back({.words = name.empty() ? Tr("Controller {1}", index + 1) : TrTitle(name),
                       .kind = kController,
                       .controller = index,
                       .found_id = {}});
    ++index;
  }
  for (const FoundMotions::Entry* entry : ComparableMotions(session)) {
    const Controller& controller = entry->motion.document.controllers.back();
    choices.push_back({.words = ReachedWords(entry->motion.document.task.kind, entry->motion.terms) + " · " +
                                ControlModeWords(controller.kind, controller.senses),
                       .kind = kFound,
                       .found_id = entry->id});
  }
  const Ghost& ghost = session.Comparison().Other();
  const auto now = std::ranges::find_if(choices, [&](const GhostChoice& c) {
    return c.kind == ghost.Source() && c.controller == ghost.ControllerIndex().value_or(-1) &&
           c.found_id == ghost.FoundId();
  });
  chosen = static_cast<int>(now - choices.begin());
  if (now == choices.end())  // the motion was removed from the results
    choices.push_back({.words = session.Comparison().Words(), .kind = kFound, .found_id = ghost.FoundId()});
  return choices;
}

void DrawGhostChoice(Ui& ui, Session& session) {
  int chosen = 0;
  const std::vector<GhostChoice> choices = GhostChoices(session, chosen);
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const GhostChoice& choice : choices) words.push_back(choice.words);
  ui.Heading(Tr("Compare"));
  if (ui.Combo("world/ghost", Tr("With"), words, chosen)) {
    const GhostChoice& wanted = choices[static_cast<std::size_t>(chosen)];
    if (wanted.kind == Ghost::Kind::kFound)
      session.Comparison().ChooseFound(wanted.found_id);
    else
      session.Comparison().Choose(wanted.kind, wanted.controller);
  }
  if (session.Comparison().Other().Player() == nullptr) return;
  static constexpr std::array<const char*, 2> kPlaces = {TrLater("Behind it"), TrLater("Beside it")};
  int place = session.Comparison().Other().Beside() ? 1 : 0;
  ui.Gap(6.0f);
  if (ui.Segmented("world/beside", ui.ControlRow(), Tr("Where the other figure is drawn"), kPlaces, place))
    session.Comparison().ShowBeside(place == 1);
}

}  // namespace

void DrawWorldButton(Ui& ui, WorldCardState& state, const ImRect& stage) {
  const float height = ui.Look().touch ? 44.0f : 32.0f;
  const ImVec2 corner(stage.Max.x - 12.0f, stage.Min.y + 10.0f);
  const ImRect button({corner.x - kButtonWidth, corner.y}, {corner.x, corner.y + height});
  if (ui.Button("world/open", button, Tr(state.open ? "Close" : "World"), ButtonLook::kOutlined, true,
                Tr(state.open ? "Close the world card" : "World: push, slope, friction, gravity, ghost")))
    state.open = !state.open;
}

ImRect WorldCardOn(const ImRect& stage, const WorldCardState& state) {
  const float top = stage.Min.y + 50.0f;
  return {{stage.Max.x - kWidth - 12.0f, top},
          {stage.Max.x - 12.0f, std::min(stage.Max.y - 10.0f, top + state.height)}};
}

void DrawWorldCard(Ui& ui, Session& session, WorldCardState& state, const ImRect& card) {
  const PartScope part = ui.Part("world", "region", Tr("World"));
  ImGui::SetCursorScreenPos(card.Min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {14.0f, 12.0f});
  ImGui::BeginChild(
      "world", card.GetSize(), ImGuiChildFlags_AlwaysUseWindowPadding,
      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  DrawSlopeAndGravity(ui, session);
  ui.Gap(8.0f);
  DrawLiveSwitch(ui, session, "world/live");
  DrawPushes(ui, session, state);
  ui.Gap(8.0f);
  DrawGroundForm(ui, session, state.ground);
  DrawJoints(ui, session);
  ui.Gap(8.0f);
  DrawGhostChoice(ui, session);
  ui.Gap(8.0f);
  ui.Switch("world/rods", Tr(session.Doc().figure.HasSprings() ? "Show springs only" : "Show rods only"),
            state.rods_only);
  ui.Gap(8.0f);
  if (ui.Button("world/reset", ui.ControlRow(), Tr("Back to the world as opened"), ButtonLook::kOutlined,
                session.World().Changed())) {
    session.World().Reset();
  }
  state.height = ImGui::GetCursorPosY() + ImGui::GetScrollY() + 8.0f;
  ui.ScrollByTouch();
  ui.ScrollBar("world/scroll");
  ImGui::EndChild();
}

}  // namespace gaitsmith::shell
