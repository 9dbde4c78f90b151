// SPDX-License-Identifier: MIT
// A panel that Dear ImGui draws without a window, for tests of widgets.
#pragma once

#include <functional>

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell::test {

// Draws frames without a renderer.
class Panel {
 public:
  Panel() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {400.0f, 300.0f};
    io.DeltaTime = 0.02f;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    theme_.palette = PaletteOf(PaletteName::kLight);
    theme_.fonts.Build(1.0f);
    registry_.Attach();
  }
  ~Panel() { ImGui::DestroyContext(); }
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  void Draw(const std::function<void(Ui&)>& contents) {
    ImGui::NewFrame();
    registry_.BeginFrame();
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({400.0f, 300.0f});
    ImGui::Begin("whole", nullptr, ImGuiWindowFlags_NoDecoration);
    ImGui::BeginChild("panel", {380.0f, 200.0f}, 0,
                      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoScrollbar);
    Ui ui(theme_, registry_, backdrop_);
    contents(ui);
    ImGui::EndChild();
    ImGui::End();
    registry_.EndFrame();
    ImGui::Render();
  }
  WidgetRegistry& Registry() { return registry_; }

 private:
  Theme theme_;
  WidgetRegistry registry_;
  Backdrop backdrop_;
};

}  // namespace gaitsmith::shell::test
