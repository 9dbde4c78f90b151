// SPDX-License-Identifier: MIT
// The window (in a browser: the canvas) with the contexts of OpenGL and Dear ImGui. Frames are drawn only on
// request or after an event. Text and lines stay sharp when the device's pixel ratio changes.
#pragma once

#include <SDL.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "shell/widgets/backdrop.h"
#include "shell/widgets/theme.h"
#include "shell/widgets/widget_registry.h"

namespace gaitsmith::shell {

class Window {
 public:
  struct Options {
    std::string title = "Gaitsmith";
    int width = 1280;  // [points]
    int height = 720;
    float scale = 1.0f;  // enlargement, for displays whose system reports no pixel ratio
  };

  /// @return nothing if there is no display or no OpenGL; SDL_GetError() has the reason
  [[nodiscard]] static std::unique_ptr<Window> Open(const Options&);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Receives every event first; returning true hides the event from the interface.
  using EventFilter = std::function<bool(const SDL_Event&)>;

  /// Handles all pending events, after waiting up to `wait_ms` for the first one. @return false if the user
  /// closed the window
  bool TakeEvents(int wait_ms, const EventFilter& filter);

  /// True for several frames after an event: Dear ImGui needs a second frame to settle.
  [[nodiscard]] bool NeedsFrame() const { return frames_due_ > 0; }
  /// Whether one of the first two frames after an event is due. They show the response and must not be late.
  [[nodiscard]] bool OwesResponse() const { return frames_due_ > 1; }
  void RequestFrame() { frames_due_ = 3; }
  /// Requests a frame for a change without an event.
  void RequestOneFrame() { frames_due_ = std::max(frames_due_, 1); }

  void Draw(const std::function<void()>& contents);

  void SetPalette(PaletteName);
  /// Enlarges everything, in (0, 8].
  void SetScale(float scale);
  void SetTitle(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }
  /// In a browser: sets the canvas's size on the page [CSS pixels]. Call it also if only the density changed.
  void SetSize(int width, int height);

  [[nodiscard]] Theme& Look() { return theme_; }
  [[nodiscard]] WidgetRegistry& Registry() { return registry_; }
  /// Rectangles behind the contents. The rest of the window has the panels' colour.
  [[nodiscard]] Backdrop& Behind() { return backdrop_; }

 private:
  Window(SDL_Window* window, SDL_GLContext context, float scale);
  void Handle(SDL_Event event);
  void FollowDensity();
  void RasteriseType(float density);
  void DrawBackdrop();
  [[nodiscard]] float Density() const;

  SDL_Window* window_;
  SDL_GLContext context_;
  float scale_;
  int frames_due_ = 3;
  ImVec2 pointer_{-1e6f, -1e6f};
  Theme theme_;
  WidgetRegistry registry_;
  Backdrop backdrop_;
};

}  // namespace gaitsmith::shell
