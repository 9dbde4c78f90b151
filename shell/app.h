// SPDX-License-Identifier: MIT
// The application: one session, laid out for a desk or a phone, advanced in time and drawn.
#pragma once

#include "shell/panel_controller.h"
#include "shell/panel_figure.h"
#include "shell/session.h"
#include "shell/window.h"

namespace gaitsmith::shell {

class App {
 public:
  App(Host& host, Window& window) : host_(host), window_(window), session_(host) {}

  /// Moves playback and search on. @return true when a new frame is due
  bool Advance(double seconds);
  void Draw();

  /// Keys that the application itself takes. @return true when the interface must not see the event
  bool Take(const SDL_Event& event);

  [[nodiscard]] Session& State() { return session_; }
  [[nodiscard]] Window& Surface() { return window_; }

 private:
  void DrawDesk(Ui&, const ImRect& whole);
  void DrawPhone(Ui&, const ImRect& whole);
  void DrawPanel(Ui&, const ImRect&, int panel);
  [[nodiscard]] int Panel(int panels) const;
  void ChoosePanel(int panel);

  Host& host_;
  Window& window_;
  Session session_;
  FigurePanelState figure_panel_;
  ControllerPanelState controller_panel_;
  bool first_frame_told_ = false;
};

}  // namespace gaitsmith::shell
