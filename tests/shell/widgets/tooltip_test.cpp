// SPDX-License-Identifier: MIT
#include "shell/widgets/tooltip.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <string>

#include "shell/words/hints.h"
#include "tests/shell/widgets/panel.h"

namespace gaitsmith::shell::test {
namespace {

// Two buttons with a tooltip.
class Hinted {
 public:
  Hinted() {
    REQUIRE(SetHints(R"({"go": "Starts {1}.", "grey": "Stops it.", "grey!": "Nothing runs."})"));
    Draw();
  }
  ~Hinted() { SetHints("{}"); }
  Hinted(const Hinted&) = delete;
  Hinted& operator=(const Hinted&) = delete;

  void Draw() {
    for (int frame = 0; frame < 3; ++frame) {
      panel_.Draw([this](Ui& ui) {
        ui.Gap(60.0f);
        pressed += ui.Button("go", ui.ControlRow(), "all") ? 1 : 0;
        ui.Gap(60.0f);
        ui.Button("grey", ui.ControlRow(), "Grey", ButtonLook::kOutlined, false);
        tooltip.Draw(ui, panel_.Registry());
      });
    }
  }
  void PointAt(ImVec2 at) {
    ImGui::GetIO().AddMousePosEvent(at.x, at.y);
    Draw();
  }
  void PointAt(const char* id) { PointAt(panel_.Registry().Find(id)->rect.GetCenter()); }
  void Hold(bool down) {
    ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, down);
    Draw();
  }
  void Focus(const char* id) {
    panel_.Registry().Requests().Add({.id = id});
    Draw();
  }
  bool Wait(double seconds) {
    const bool due = tooltip.Advance(seconds);
    Draw();
    return due;
  }
  const Widget* Shown() {
    const auto& widgets = panel_.Registry().Widgets();
    const auto found = std::ranges::find(widgets, "tooltip", &Widget::role);
    return found == widgets.end() ? nullptr : &*found;
  }
  std::string Words() { return Shown() == nullptr ? "" : Shown()->label; }

  int pressed = 0;
  Tooltip tooltip;

 private:
  Panel panel_;
};

}  // namespace

TEST_CASE("tooltip: it comes after half a second, stays while it is pointed at, and can be hidden") {
  Hinted page;
  page.PointAt("go");
  CHECK_FALSE(page.Wait(0.4));
  CHECK(page.Words().empty());
  CHECK(page.Wait(0.2));
  REQUIRE(page.Words() == "Starts all.");
  const ImRect at = page.Shown()->rect;
  page.PointAt(at.GetCenter());
  CHECK(page.Words() == "Starts all.");
  CHECK(page.tooltip.Hide());
  CHECK_FALSE(page.tooltip.Hide());
  page.PointAt(ImVec2(390.0f, 290.0f));
  page.PointAt("go");
  page.Wait(2.0);
  CHECK(page.Words() == "Starts all.");  // another visit
  page.tooltip.Hide();
  page.Wait(2.0);
  CHECK(page.Words().empty());  // not the same one
}

TEST_CASE("tooltip: a click hides it, and nothing shows one elsewhere") {
  Hinted page;
  page.PointAt("go");
  page.Wait(1.0);
  page.Hold(true);
  page.Hold(false);
  CHECK(page.pressed == 1);
  page.Wait(1.0);
  CHECK(page.Words().empty());
  page.PointAt(ImVec2(390.0f, 290.0f));
  CHECK_FALSE(page.Wait(1.0));
}

TEST_CASE("tooltip: a disabled control has its reason under the pointer and with the focus") {
  Hinted page;
  page.PointAt("grey");
  page.Wait(1.0);
  CHECK(page.Words() == "Stops it. Nothing runs.");
  page.PointAt(ImVec2(390.0f, 290.0f));
  page.Focus("grey");
  CHECK(page.Words().empty());
  page.Wait(0.6);
  CHECK(page.Words() == "Stops it. Nothing runs.");
}

TEST_CASE("tooltip: a finger that stays shows it and presses nothing") {
  Hinted page;
  ImGui::GetIO().AddMouseSourceEvent(ImGuiMouseSource_TouchScreen);
  page.PointAt("go");
  CHECK_FALSE(page.Wait(1.0));  // no finger is down
  page.Hold(true);
  CHECK(page.Wait(0.6));
  CHECK(page.Words() == "Starts all.");
  page.Hold(false);
  CHECK(page.pressed == 0);
  CHECK(page.Words() == "Starts all.");
  page.Hold(true);
  CHECK(page.Words().empty());
  page.Hold(false);
  CHECK(page.pressed == 1);
}

TEST_CASE("tooltip: it lies within the window and beside its control") {
  Hinted page;
  SetHints(R"({"*": "A long sentence that needs several lines, because it explains how to take it back."})");
  for (const char* id : {"go", "grey"}) {
    page.PointAt(ImVec2(395.0f, 295.0f));
    page.PointAt(id);
    page.Wait(1.0);
    REQUIRE(page.Shown() != nullptr);
    const ImRect at = page.Shown()->rect;
    CHECK(ImRect(0.0f, 0.0f, 400.0f, 300.0f).Contains(at));
    CHECK(at.GetHeight() > 40.0f);
  }
}

}  // namespace gaitsmith::shell::test
