// SPDX-License-Identifier: MIT
// The application: one session, laid out for a desk or a phone, advanced in time and drawn.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shell/app/split.h"
#include "shell/app/window.h"
#include "shell/panels/controller/controller_panel.h"
#include "shell/panels/figure/figure_panel.h"
#include "shell/panels/keyframes/keyframes_panel.h"
#include "shell/panels/lab/lab_panel.h"
#include "shell/panels/search/found_rail.h"
#include "shell/panels/search/search_panel.h"
#include "shell/panels/style/style_panel.h"
#include "shell/session/commands.h"
#include "shell/session/session.h"
#include "shell/stage/stage.h"
#include "shell/widgets/tooltip.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {

class App {
 public:
  App(Host& host, Window& window) : host_(host), window_(window), session_(host) {}

  /// Advances playback and the search. @return true if a new frame is due
  bool Advance(double seconds);
  void Draw();

  /// Handles the application's own keys. @return true if the interface must not get the event
  bool Take(const SDL_Event& event);

  /// All commands: those of the table, then the shelf's.
  [[nodiscard]] std::vector<Command> Commands();
  /// @return false: there is no such command, or it is unavailable
  bool Run(std::string_view id);
  /// Handles a key press. @param name as in Command::keys. @param on_canvas the canvas has the focus, so that
  /// its focused control takes precedence. @return true if a command handled it
  bool Key(std::string_view name, bool on_canvas, bool repeated);
  /// Ends drawing the ground by hand. @return false: it is not being drawn
  bool EndDrawing();

  [[nodiscard]] Session& State() { return session_; }
  [[nodiscard]] Window& Surface() { return window_; }

 private:
  void ShowDrawing();
  void DrawDesk(Ui&, const ImRect& whole);
  void DrawPhone(Ui&, const ImRect& whole);
  /// @param shown at least one panel, as indices in kPanels. @return the chosen one
  int DrawTabs(Ui&, const ImRect&, const std::vector<int>& shown);
  void DrawPanel(Ui&, const ImRect&, int panel);
  void DrawWorld(Ui&, const ImRect&);
  /// What a panel holds, within its scrolled area.
  void DrawContents(Ui&, Panel panel);
  /// Draws into an area that scrolls.
  void DrawScrolled(Ui&, const ImRect&, const std::string& id, const std::function<void()>& draw);
  /// Whether the choices of a first visit take the place of the panels.
  [[nodiscard]] bool OffersChoices() const;
  /// Whether there is something to play.
  [[nodiscard]] bool Moves() const;
  [[nodiscard]] float PlaybackHeight(const Ui&, float width) const;
  void DrawChoices(Ui&, const ImRect&);
  void DrawSettingsButton(Ui&, const ImRect& stage);
  /// What lies below the stage beside the choices, in the order of the tabs; on a low canvas in their place.
  /// The goal is a tab where the choices have no panel of their own.
  enum class DockTab { kGoal, kFigures, kMotions, kTimeline };
  /// @param first the tabs from this one on
  void DrawDock(Ui&, const ImRect&, DockTab first);
  static float DockTabHeight(const Ui&);
  /// Whether figures to choose from take the place of playback and timeline.
  [[nodiscard]] bool ShowsFigureRow() const;
  void DrawFigures(Ui&, const ImRect&);
  bool TakeFingers(const SDL_Event&);
  void OpenPanel();
  /// The tabs, as indices in kPanels: on a phone or a low canvas all shown panels, else those with a tab on
  /// a desk.
  [[nodiscard]] bool ShowsKeyframes() const;
  [[nodiscard]] std::vector<int> ShownTabs();

  Host& host_;
  Window& window_;
  Session session_;
  FigurePanelState figure_panel_;
  StageState stage_;
  Tooltip tooltip_;
  bool drew_ground_ = false;  // in the last frame
  DockTab dock_ = DockTab::kGoal;
  Split beside_, below_;          // of the panel, where it is beside the stage and where it is below
  std::size_t clips_before_ = 0;  // of the timeline, in the frame before
  FoundRailState rail_;
  int panel_before_ = -1;    // in the frame before
  bool wide_ = false;        // a canvas with room for a panel beside the stage
  bool phone_ = false;       // a narrow or upright canvas: the panel lies under the stage
  bool low_ = false;         // a low one
  bool tall_ = false;        // one with room for a dock, however narrow
  bool sheet_open_ = false;  // on a low phone: the panel covers the stage
  bool timeline_in_tabs_ = false;
  ControllerPanelState controller_panel_;
  KeyframesPanelState keyframes_panel_;
  SearchPanelState search_panel_;
  LabPanelState lab_panel_;
  StylePanelState style_panel_;
  bool first_frame_reported_ = false;
};

}  // namespace gaitsmith::shell
