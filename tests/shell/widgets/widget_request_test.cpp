// SPDX-License-Identifier: MIT
// Requests to widgets, drawn by Dear ImGui without a window.
#include "shell/widgets/widget_request.h"

#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "tests/shell/widgets/panel.h"

namespace gaitsmith::shell::test {
namespace {

using Kind = WidgetRequest::Kind;

TEST_CASE("a requested widget reacts in the next frame, once, as to a click or a key") {
  Panel panel;
  int pressed = 0;
  bool on = false;
  double value = 0.5;
  int number = 7;
  const auto contents = [&](Ui& ui) {
    pressed += ui.Button("go", ui.ControlRow(), "Go") ? 1 : 0;
    pressed += ui.Button("grey", ui.ControlRow(), "Grey", ButtonLook::kOutlined, false) ? 100 : 0;
    ui.Switch("switch", "Switch", on);
    ui.Slider("slider", "Slider", value, {.low = 0.0, .high = 1.0, .step = 0.1}, "");
    ui.Number("number", "Number", number, 0, 10);
  };
  panel.Draw(contents);
  panel.Draw(contents);
  WidgetRequests& requests = panel.Registry().Requests();

  requests.Add({.id = "go", .kind = Kind::kPress});
  requests.Add({.id = "switch", .kind = Kind::kPress});
  requests.Add({.id = "slider", .kind = Kind::kSet, .number = 0.33});
  requests.Add({.id = "number", .kind = Kind::kStep, .number = 2.0});
  panel.Draw(contents);
  CHECK(pressed == 1);
  CHECK_FALSE(on);
  panel.Draw(contents);
  CHECK(on);
  panel.Draw(contents);
  CHECK(std::abs(value - 0.3) < 1e-9);  // on the slider's grid
  panel.Draw(contents);
  CHECK(number == 9);
  CHECK_FALSE(requests.Waiting());
  panel.Draw(contents);
  CHECK(pressed == 1);
  CHECK(on);

  requests.Add({.id = "number", .kind = Kind::kSet, .number = 99.0});
  panel.Draw(contents);
  CHECK(number == 10);
  requests.Add({.id = "grey", .kind = Kind::kPress});
  requests.Add({.id = "nowhere", .kind = Kind::kPress});
  panel.Draw(contents);
  panel.Draw(contents);
  CHECK(pressed == 1);
  CHECK_FALSE(requests.Waiting());
}

TEST_CASE("a request moves the keyboard focus to its widget and scrolls it into view") {
  Panel panel;
  double value = 0.0;
  const auto contents = [&](Ui& ui) {
    for (int i = 0; i < 12; ++i) {
      const std::string name = std::to_string(i);
      ui.Slider("slider/" + name, "Slider " + name, value, {}, "");
    }
  };
  panel.Draw(contents);
  panel.Draw(contents);
  const Widget* last = panel.Registry().Find("slider/11");
  REQUIRE(last != nullptr);
  CHECK_FALSE(last->in_sight);
  CHECK(panel.Registry().Json().find("slider/11") == std::string::npos);
  CHECK(panel.Registry().MirrorJson().find("slider/11") != std::string::npos);

  panel.Registry().Requests().Add({.id = "slider/11", .kind = Kind::kStep, .number = 3.0});
  for (int i = 0; i < 3; ++i) panel.Draw(contents);
  CHECK(std::abs(value - 0.03) < 1e-9);
  last = panel.Registry().Find("slider/11");
  REQUIRE(last != nullptr);
  CHECK(last->in_sight);
  int focused = 0;
  for (const Widget& widget : panel.Registry().Widgets()) focused += widget.state.focused ? 1 : 0;
  CHECK(focused == 1);
  CHECK(last->state.focused);
}

TEST_CASE("a click on a button ends typing in a number below it, and presses the button") {
  Panel panel;
  int pressed = 0;
  int number = 7;
  const auto contents = [&](Ui& ui) {
    pressed += ui.Button("go", ui.ControlRow(), "Go") ? 1 : 0;
    ui.Number("number", "Number", number, 0, 100);
  };
  const auto at = [&](const char* id) { return panel.Registry().Find(id)->rect.GetCenter(); };
  const auto click = [&](ImVec2 place) {
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(place.x, place.y);
    for (const bool down : {true, false}) {
      panel.Draw(contents);
      io.AddMouseButtonEvent(ImGuiMouseButton_Left, down);
    }
    panel.Draw(contents);
    panel.Draw(contents);
  };
  panel.Draw(contents);
  panel.Draw(contents);
  click(at("number"));
  REQUIRE(panel.Registry().Find("number")->role == "textbox");
  ImGui::GetIO().AddInputCharactersUTF8("42");
  for (int i = 0; i < 4; ++i) panel.Draw(contents);
  click(at("number"));  // inside the field: typing goes on
  CHECK(panel.Registry().Find("number")->role == "textbox");
  click(at("go"));
  CHECK(number == 42);
  CHECK(pressed == 1);
  CHECK(panel.Registry().Find("number")->role == "spinbutton");
}

TEST_CASE("steps add up, numbers replace each other, and no other request is lost") {
  WidgetRequests requests;
  requests.Add({.id = "a", .kind = Kind::kFocus});
  requests.Add({.id = "a", .kind = Kind::kStep, .number = 1.0});
  requests.Add({.id = "a", .kind = Kind::kStep, .number = 1.0, .begins = false});
  requests.Add({.id = "b", .kind = Kind::kSet, .number = 1.0});
  requests.Add({.id = "b", .kind = Kind::kSet, .number = 2.0, .begins = false});
  requests.Add({.id = "b", .kind = Kind::kPress});
  requests.Add({.id = "b", .kind = Kind::kPress});
  CHECK(requests.Last() == "b");
  std::string order;
  for (; requests.Waiting(); requests.EndFrame()) {
    requests.BeginFrame();
    REQUIRE(requests.Due() != nullptr);
    CHECK(requests.DueFor("elsewhere") == nullptr);
    CHECK(requests.Due()->begins);
    order += requests.Due()->id + std::to_string(static_cast<int>(requests.Due()->number)) + " ";
  }
  CHECK(order == "a2 b2 b0 b0 ");
}

TEST_CASE("parts contain what is drawn in them") {
  Panel panel;
  int chosen = 0;
  static constexpr std::array<const char*, 2> kOptions = {"One", "Two"};
  panel.Draw([&](Ui& ui) {
    const PartScope part = ui.Part("outer", "region", "Outer");
    ui.Segmented("choice", ui.ControlRow(), "Choice", kOptions, chosen);
    ui.Paragraph("Words.");
  });
  const WidgetRegistry& registry = panel.Registry();
  REQUIRE(registry.Parts().size() == 2);
  CHECK(registry.Parts()[1].label == "Choice");
  CHECK(registry.Parts()[1].parent == 0);
  const Widget* option = registry.Find("choice/1");
  REQUIRE(option != nullptr);
  CHECK(option->part == 1);
  const Widget* words = registry.Find("text/outer/1");
  REQUIRE(words != nullptr);
  CHECK(words->label == "Words.");
  CHECK(words->part == 0);
}

}  // namespace
}  // namespace gaitsmith::shell::test
