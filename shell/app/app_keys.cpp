// SPDX-License-Identifier: MIT
// Commands, and what the keyboard and fingers do beside them.
#include <algorithm>

#include "shell/app/app.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {

std::vector<Command> App::Commands() {
  std::vector<Command> list = CommandsOf(session_, timeline_in_tabs_);
  list.push_back({.id = "view/world",
                  .group = TrLater("View"),
                  .title = Tr(stage_.world.open ? "Close the world card"
                                                : "World: push, slope, friction, gravity, ghost"),
                  .run = [this] { stage_.world.open = !stage_.world.open; }});
  for (Command& command : ShelfOf(session_)) list.push_back(std::move(command));
  return list;
}

void App::OpenPanel() {
  sheet_open_ = true;
  session_.LeaveViewer();
  session_.ShowAll();
}

bool App::Run(std::string_view id) {
  const std::vector<Command> list = Commands();
  const auto command = std::ranges::find(list, id, &Command::id);
  if (command == list.end() || !command->why_not.empty()) return false;
  session_.BeginGesture();
  command->run();
  if (id.starts_with("panel/")) OpenPanel();
  window_.RequestFrame();
  return true;
}

bool App::EndDrawing() {
  if (!session_.Ground().Drawing()) return false;
  session_.Ground().Draw(false);
  stage_.gaze = {};
  return true;
}

bool App::Key(std::string_view name, bool on_canvas, bool repeated) {
  if (ImGui::GetIO().MouseDown[0]) return false;  // do not disturb a drag
  if (name == "Escape" && (tooltip_.Hide() || EndDrawing())) {
    window_.RequestFrame();
    return true;
  }
  if (on_canvas && (ImGui::GetIO().WantTextInput || ImGui::GetCurrentContext()->OpenPopupStack.Size > 0))
    return false;
  const std::string_view coming = window_.Registry().Requests().Last();
  // After a click no ring shows which control has the focus, so Space and Enter do not press it.
  const bool plays = (name == "Space" || name == "Enter") &&
                     ImGui::GetCurrentContext()->NavDisableHighlight && coming.empty();
  const auto wants_keys = [coming](const Widget& w) {
    const bool focused = coming.empty() ? w.state.focused : w.id == coming;
    return focused && w.id != "stage" && w.id != "transport/scrub";
  };
  if (on_canvas && !plays && BelongsToControls(name) &&
      std::ranges::any_of(window_.Registry().Widgets(), wants_keys))
    return false;
  for (const Command& command : CommandsOf(session_, timeline_in_tabs_)) {
    if (std::ranges::find(command.keys, name) == command.keys.end()) continue;
    if (repeated && !command.repeats) return true;
    if (!command.why_not.empty()) {
      host_.Status(command.why_not);
      return true;
    }
    session_.BeginGesture();
    command.run();
    if (command.id.starts_with("panel/")) OpenPanel();
    window_.RequestFrame();
    return true;
  }
  return false;
}

// SDL emulates a mouse for the first finger, which must be released when a second finger touches.
bool App::TakeFingers(const SDL_Event& event) {
  if (event.type == SDL_FINGERDOWN || event.type == SDL_FINGERMOTION || event.type == SDL_FINGERUP) {
    if (stage_.pinch.Take(event.tfinger, ImGui::GetIO().DisplaySize)) {
      ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
      ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, false);
    }
    return false;
  }
  if (!stage_.pinch.Holds()) return false;
  return (event.type == SDL_MOUSEMOTION && event.motion.which == SDL_TOUCH_MOUSEID) ||
         ((event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP) &&
          event.button.which == SDL_TOUCH_MOUSEID);
}

bool App::Take(const SDL_Event& event) {
  // Key repeats, and keys in a text field, continue the gesture.
  const bool key_down = event.type == SDL_KEYDOWN;
  const bool fresh_key = key_down && event.key.repeat == 0 && !ImGui::GetIO().WantTextInput;
  if (fresh_key || event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_FINGERDOWN) session_.BeginGesture();
  if (TakeFingers(event)) return true;
  if (!key_down) return false;
  const SDL_Keysym key = event.key.keysym;
  const bool busy = ImGui::GetIO().WantTextInput || ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
  if (busy) return false;
  const auto& widgets = window_.Registry().Widgets();
  const auto focused = std::ranges::find_if(widgets, [](const Widget& w) { return w.state.focused; });

  // The Tab key visits each widget of the canvas once and then leaves the canvas. Escape leaves immediately.
  if (key.sym == SDLK_ESCAPE) {
    host_.LeaveCanvas(0);
    return true;
  }
  if (key.sym == SDLK_TAB && (key.mod & (KMOD_CTRL | KMOD_ALT)) == 0 && !widgets.empty() &&
      focused != widgets.end()) {
    const bool back = (key.mod & KMOD_SHIFT) != 0;
    if (!window_.Registry().StopsBeyondFocus(back)) {
      host_.LeaveCanvas(back ? -1 : 1);
      return true;
    }
  }
  return false;
}

}  // namespace gaitsmith::shell
