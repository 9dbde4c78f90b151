// SPDX-License-Identifier: MIT
// Layout and time. Commands and the keyboard are in app_keys.cpp.
#include "shell/app/app.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "shell/panels/controller/controller_panel.h"
#include "shell/panels/figure/drawing_stage.h"
#include "shell/panels/figure/figure_row.h"
#include "shell/panels/make/make_panel.h"
#include "shell/panels/style/style_panel.h"
#include "shell/stage/invitation.h"
#include "shell/stage/stage.h"
#include "shell/timeline/timeline.h"
#include "shell/timeline/transition_strip.h"
#include "shell/timeline/transport.h"
#include "shell/words/language.h"
#include "shell/workspace/panels.h"

namespace gaitsmith::shell {
namespace {

constexpr float kLeastPanel = 300.0f;
constexpr float kLeastSheet = 190.0f;

}  // namespace

bool App::Advance(double seconds) {
  // After the page was suspended (a hidden tab), the motion continues where it stopped.
  const double step = std::min(seconds, 0.1);
  const bool tells = tooltip_.Advance(step);
  return session_.Advance(step) || tells;
}

bool App::ShowsKeyframes() const {
  return session_.Keyframes().Open() || session_.Doc().view.panel == static_cast<int>(Panel::kKeyframes);
}

std::vector<int> App::ShownTabs() {
  std::vector<int> shown;
  const bool simple = session_.Simple() && (OffersChoices() || session_.Doc().timeline.empty());
  if (simple || session_.Viewing()) return shown;
  for (int panel = 0; panel < static_cast<int>(kPanels.size()); ++panel) {
    const bool tab = timeline_in_tabs_ || kPanels[static_cast<std::size_t>(panel)].tab_on_desk;
    // Keyframes appear once they are asked for.
    const bool hidden =
        kPanels[static_cast<std::size_t>(panel)].panel == Panel::kKeyframes && !ShowsKeyframes();
    if (tab && !hidden && session_.Layout().Shows(panel)) shown.push_back(panel);
  }
  return shown;
}

int App::DrawTabs(Ui& ui, const ImRect& rect, const std::vector<int>& shown) {
  std::vector<const char*> names;
  names.reserve(shown.size());
  for (const int panel : shown) names.push_back(kPanels[static_cast<std::size_t>(panel)].label);
  const int open = NearestPanel(kPanels, shown, session_.Doc().view.panel);
  auto tab = static_cast<int>(std::ranges::find(shown, open) - shown.begin());
  const bool chosen = ui.Tabs("panels", rect, Tr("Panels"), names, tab);
  const int panel = shown[static_cast<std::size_t>(tab)];
  if (chosen) {
    sheet_open_ = panel != panel_before_ || !sheet_open_ || stage_.world.open;
    if (low_) stage_.world.open = false;
    const int number = kPanels[static_cast<std::size_t>(panel)].Number();
    session_.SetView([number](View& view) { view.panel = number; });
  }
  return panel;
}

void App::Draw() {
  Theme& theme = window_.Look();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  // Upright tablets, too, have the panel under the stage.
  wide_ = size.x >= kWideCanvas;
  phone_ = size.x < kPhoneWidth || (!wide_ && size.y > size.x);
  low_ = size.y < kLowHeight;
  tall_ = size.y >= kTallHeight;
  timeline_in_tabs_ = phone_ || low_;
  if (phone_) theme.touch = true;
  Ui ui(theme, window_.Registry(), window_.Behind());
  if (const WidgetRequest* due = window_.Registry().Requests().Due(); due != nullptr && due->begins)
    session_.BeginGesture();
  ShowDrawing();
  // While a number is typed its digits are no wishes of their own.
  session_.Following().Hold(ImGui::GetIO().WantTextInput ||
                            (ImGui::GetActiveID() != 0 && ImGui::IsMouseDown(ImGuiMouseButton_Left)));

  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(size);
  ImGui::Begin("Gaitsmith", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground);
  const ImRect whole({0.0f, 0.0f}, size);
  if (phone_) {
    DrawPhone(ui, whole);
  } else {
    DrawDesk(ui, whole);
  }
  tooltip_.Draw(ui, window_.Registry());
  ImGui::End();
  if (std::exchange(stage_.asks_for_rules, false)) Run("panel/Controller");
  if (!first_frame_reported_) host_.FirstFrame();
  first_frame_reported_ = true;
}

// The stage must be in view while a person draws on it.
void App::ShowDrawing() {
  const bool begins = session_.Ground().Drawing() && !drew_ground_;
  drew_ground_ = session_.Ground().Drawing();
  if (!begins) return;
  figure_panel_.on_stage = false;
  if (low_) stage_.world.open = sheet_open_ = false;
}

void App::DrawDesk(Ui& ui, const ImRect& whole) {
  const std::vector<int> shown = ShownTabs();
  const bool figures = ShowsFigureRow();
  const bool choices = OffersChoices();
  const bool dock = choices && !figures && !low_;
  const bool timeline = session_.Layout().Shows(IndexOf(Panel::kTimeline)) && !timeline_in_tabs_ &&
                        !session_.Viewing() && !dock;
  const float widest = std::min(620.0f, 0.5f * whole.GetWidth());
  const float panel_width = beside_.Size(kPanelWidth, kLeastPanel, widest);
  const float panel_x = shown.empty() && !choices ? whole.Max.x : whole.Max.x - panel_width;
  const float timeline_y =
      dock ? whole.Max.y - DockTabHeight(ui) - kTimelineHeight - TransitionStripHeight(session_)
      : !timeline || figures ? whole.Max.y
                             : whole.Max.y - kTimelineHeight - TransitionStripHeight(session_) -
                                   (ui.Look().touch ? 14.0f : 0.0f);
  const float transport_y =
      timeline_y - (figures ? kFigureRowHeight : PlaybackHeight(ui, panel_x - whole.Min.x));
  const ImRect stage(whole.Min, {panel_x, transport_y});
  const ImRect card = WorldCardOn(stage, stage_.world);
  const bool draws = DrawsOnStage(session_, figure_panel_);
  if (draws)
    DrawDrawingStage(ui, session_, figure_panel_, stage);
  else
    DrawStage(ui, session_, stage_, stage, stage_.world.open ? stage.Max.x - card.Min.x : 0.0f);
  if (stage_.world.open && !draws) {
    ui.Frame(card, ui.Ink().panel, ui.Ink().line);
    DrawWorld(ui, card);
  }
  const ImRect below({whole.Min.x, transport_y}, {panel_x, timeline_y});
  if (figures) DrawFigures(ui, below);
  if (!figures && Moves()) DrawTransport(ui, session_, below);
  const ImRect bottom({whole.Min.x, timeline_y}, {panel_x, whole.Max.y});
  if (timeline && !figures) DrawTimeline(ui, session_, bottom);
  if (dock) DrawDock(ui, bottom, DockTab::kFigures);
  DrawSettingsButton(ui, stage);
  if (shown.empty() && !choices) return;
  ui.VerticalLine(panel_x, whole.Min.y, whole.Max.y);
  DrawSplit(ui, beside_, {panel_x, whole.Max.x, whole.Min.y, whole.Max.y, true}, kLeastPanel, widest);
  const ImRect beside({panel_x + 1.0f, whole.Min.y}, whole.Max);
  if (choices && low_) return DrawDock(ui, beside, DockTab::kGoal);
  if (choices) return DrawChoices(ui, beside);
  const float tab_height = ui.Look().touch ? kTouchTabHeight : kTabHeight;
  const ImRect tabs({panel_x + 1.0f, whole.Min.y}, {whole.Max.x, whole.Min.y + tab_height});
  const int panel = DrawTabs(ui, tabs, shown);
  panel_before_ = panel;
  DrawPanel(ui, {{panel_x + 1.0f, tabs.Max.y}, whole.Max}, panel);
}

// A push moves a figure that cannot move by itself.
bool App::Moves() const { return !session_.Doc().timeline.empty() || !session_.Doc().pushes.empty(); }

float App::PlaybackHeight(const Ui& ui, float width) const {
  return Moves() ? TransportHeight(ui.Look(), width, low_) : 0.0f;
}

bool App::OffersChoices() const {
  const Arrangement& layout = session_.Layout();
  const auto open = [&](Panel panel) {
    return layout.Shows(IndexOf(panel)) && !layout.LocksPanel(IndexOf(panel));
  };
  const bool room = low_ ? !phone_ : wide_ || phone_ || tall_ || Invites(session_);
  return session_.Simple() && !session_.Viewing() && room && open(Panel::kStyle) &&
         open(Panel::kController) && open(Panel::kSearch) && !layout.Locks(LockedPart::kSearch);
}

// Where the choices of a first visit have no room, this opens the panels.
void App::DrawSettingsButton(Ui& ui, const ImRect& stage) {
  if (!session_.Simple() || OffersChoices() || !Invites(session_) || DrawsOnStage(session_, figure_panel_))
    return;
  const bool wide = InvitesBeside(stage);
  const float high = ui.Look().touch ? 44.0f : 32.0f;
  const ImVec2 corner(stage.Max.x - (wide ? 98.0f : 12.0f), stage.Min.y + (wide ? 10.0f : 48.0f));
  const char* settings = Tr("Settings");
  const float width = ui.Letters().Width(Type::kBody, settings) + 28.0f;
  if (ui.Button("stage/settings", {{corner.x - width, corner.y}, {corner.x, corner.y + high}}, settings))
    session_.ShowAll();
}

float App::DockTabHeight(const Ui& ui) { return ui.Look().touch ? kTouchTabHeight : 34.0f; }

void App::DrawDock(Ui& ui, const ImRect& rect, DockTab first) {
  struct Tab {
    DockTab tab;
    const char* label;
  };
  static constexpr std::array<Tab, 4> kTabs = {{{DockTab::kGoal, TrLater("Goal")},
                                                {DockTab::kFigures, TrLater("Figures")},
                                                {DockTab::kMotions, TrLater("Motions")},
                                                {DockTab::kTimeline, TrLater("Timeline")}}};
  // A clip that was added is shown.
  const std::size_t clips = session_.Doc().timeline.size();
  if (clips > clips_before_ && clips > 1) dock_ = DockTab::kTimeline;
  clips_before_ = clips;
  if (dock_ < first) dock_ = DockTab::kMotions;
  // A low first screen has as few choices as a high one.
  const DockTab last = low_ && Invites(session_) ? DockTab::kFigures : DockTab::kTimeline;
  if (dock_ > last) dock_ = first;
  std::vector<const char*> names;
  for (const Tab& tab : kTabs) {
    if (tab.tab >= first && tab.tab <= last) names.push_back(tab.label);
  }
  int chosen = static_cast<int>(dock_) - static_cast<int>(first);
  const ImRect tabs(rect.Min, {rect.Max.x, rect.Min.y + DockTabHeight(ui)});
  if (ui.Tabs("dock", tabs, low_ ? Tr("Beside the stage") : Tr("Below the stage"), names, chosen))
    dock_ = static_cast<DockTab>(chosen + static_cast<int>(first));
  const ImRect inside({rect.Min.x, tabs.Max.y}, rect.Max);
  switch (dock_) {
    case DockTab::kGoal:
      DrawChoices(ui, inside);
      break;
    case DockTab::kFigures:
      DrawFigures(ui, inside);
      break;
    case DockTab::kMotions:
      if (DrawFoundRail(
              ui, session_, rail_,
              {inside.Min, {inside.Max.x, std::min(inside.Max.y, inside.Min.y + kFigureRowHeight)}})) {
        search_panel_.found = true;
        Run("panel/Search");
      }
      if (rail_.strips.Waiting()) window_.RequestOneFrame();
      break;
    case DockTab::kTimeline:
      DrawTimeline(ui, session_, inside);
      break;
  }
}

// Without the latest sentence, which would move the choices under the pointer. The status line has it.
void App::DrawChoices(Ui& ui, const ImRect& rect) {
  const PartScope part = ui.Part("panel", "region", Tr("Choices"));
  DrawScrolled(ui, rect, "panel/make", [&] { DrawMakePanel(ui, session_); });
}

void App::DrawScrolled(Ui& ui, const ImRect& rect, const std::string& id, const std::function<void()>& draw) {
  ImGui::SetCursorScreenPos(rect.Min);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPanelPadding, 14.0f});
  ImGui::BeginChild(id.c_str(), rect.GetSize(), ImGuiChildFlags_AlwaysUseWindowPadding,
                    ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  draw();
  ui.Gap(6.0f);
  ui.ScrollByTouch();
  ui.ScrollBar("panel/scroll");
  ImGui::EndChild();
}

bool App::ShowsFigureRow() const {
  const Arrangement& layout = session_.Layout();
  return Invites(session_) && !low_ && session_.Doc().pushes.empty() &&
         layout.Shows(IndexOf(Panel::kSearch)) && layout.Shows(IndexOf(Panel::kFigure)) &&
         !layout.Locks(LockedPart::kFigure);
}

void App::DrawFigures(Ui& ui, const ImRect& rect) {
  const FigureRowChoice choice = DrawFigureRow(ui, session_, rect);
  if (choice.figure >= 0) session_.ChooseFigure(choice.figure);
  if (choice.draw) DrawOwnFigure(session_, figure_panel_, OwnFigure::kRods, !low_);
  figure_panel_.gallery_open |= choice.more;
  if (choice.more || (choice.draw && (low_ || !session_.Simple()))) Run("panel/Figure");
}

void App::DrawWorld(Ui& ui, const ImRect& rect) {
  ui.Lock(session_.Layout().Locks(LockedPart::kWorld));
  DrawWorldCard(ui, session_, stage_.world, rect);
  ui.Lock(false);
}

void App::DrawPhone(Ui& ui, const ImRect& whole) {
  // The stage is above the panel. On a low canvas a press on a tab opens the panel over the stage, or closes
  // it.
  const std::vector<int> shown = ShownTabs();
  const bool covers = low_ && (sheet_open_ || stage_.world.open);
  const float highest = 0.65f * whole.GetHeight();
  const float sheet =
      low_ ? 0.0f
           : below_.Size(std::clamp(0.33f * whole.GetHeight(), kLeastSheet, 420.0f), kLeastSheet, highest);
  const bool choices = OffersChoices() && !stage_.world.open;
  const float tabs_y = choices                               ? whole.Max.y - sheet
                       : shown.empty() && !stage_.world.open ? whole.Max.y
                                                             : whole.Max.y - sheet - kTouchTabHeight;
  if (!covers) {
    const bool draws = DrawsOnStage(session_, figure_panel_);  // with all the room there is
    const bool figures = ShowsFigureRow() && !draws;
    const float below_y =
        draws ? tabs_y : tabs_y - (figures ? kFigureRowHeight : PlaybackHeight(ui, whole.GetWidth()));
    const ImRect below({whole.Min.x, below_y}, {whole.Max.x, tabs_y});
    const ImRect stage(whole.Min, {whole.Max.x, below_y});
    if (draws)
      DrawDrawingStage(ui, session_, figure_panel_, stage);
    else
      DrawStage(ui, session_, stage_, stage);
    DrawSettingsButton(ui, stage);
    if (figures) DrawFigures(ui, below);
    if (!figures && !draws && Moves()) DrawTransport(ui, session_, below);
  }
  ui.HorizontalLine(whole.Min.x, whole.Max.x, tabs_y);
  if (!low_ && tabs_y < whole.Max.y)
    DrawSplit(ui, below_, {tabs_y, tabs_y + sheet, whole.Min.x, whole.Max.x, false}, kLeastSheet, highest);
  const ImRect below_stage({whole.Min.x, tabs_y + 1.0f}, whole.Max);
  if (choices && ShowsFigureRow()) return DrawChoices(ui, below_stage);
  if (choices) return DrawDock(ui, below_stage, DockTab::kGoal);

  const ImRect tabs({whole.Min.x, tabs_y}, {whole.Max.x, tabs_y + kTouchTabHeight});
  const int panel = shown.empty() ? -1 : DrawTabs(ui, tabs, shown);
  // Choosing another panel, by tab, key or command, closes the world card that would cover it.
  if (panel != panel_before_) stage_.world.open = false;
  if (shown.empty() && low_ && stage_.world.open && ui.Button("world/open", tabs, Tr("Close")))
    stage_.world.open = false;
  panel_before_ = panel;
  if (low_ && !sheet_open_ && !stage_.world.open) return;
  const ImRect rest =
      low_ ? ImRect(whole.Min, {whole.Max.x, tabs_y}) : ImRect({whole.Min.x, tabs.Max.y}, whole.Max);
  if (stage_.world.open) {
    DrawWorld(ui, rest);  // the stage is too small for the card
  } else if (panel >= 0) {
    DrawPanel(ui, rest, panel);
  }
}

void App::DrawPanel(Ui& ui, const ImRect& rect, int panel) {
  if (panel == IndexOf(Panel::kTimeline)) {
    const PartScope part = ui.Part("panel", "tabpanel", Tr(kPanels[static_cast<std::size_t>(panel)].label));
    DrawTimeline(ui, session_, rect);
    return;
  }
  const PanelRow& row = kPanels[static_cast<std::size_t>(panel)];
  const PartScope part = ui.Part("panel", "tabpanel", Tr(row.label));
  DrawScrolled(ui, rect, "panel/" + std::string(row.label), [&] {
    if (!session_.Notice().empty()) {
      ui.Paragraph(session_.Notice(), ui.Ink().accent, Type::kNote);
      ui.Gap(8.0f);
    }
    const bool locked = session_.Layout().LocksPanel(panel);
    if (locked) ui.LockNote();
    ui.Lock(locked);
    DrawContents(ui, row.panel);
    ui.Lock(false);
  });
}

void App::DrawContents(Ui& ui, Panel panel) {
  switch (panel) {
    case Panel::kFigure:
      DrawFigurePanel(ui, session_, figure_panel_);
      break;
    case Panel::kController:
      DrawControllerPanel(ui, session_, controller_panel_);
      stage_.felt_rule = controller_panel_.LookedAt();
      break;
    case Panel::kStyle:
      DrawStylePanel(ui, session_, style_panel_);
      break;
    case Panel::kLab:
      DrawLabPanel(ui, session_, lab_panel_);
      break;
    case Panel::kSearch:
      DrawSearchPanel(ui, session_, search_panel_);
      if (search_panel_.list.strips.Waiting() || search_panel_.elite_map.poses.Waiting() ||
          search_panel_.front_map.poses.Waiting())
        window_.RequestOneFrame();
      break;
    case Panel::kKeyframes:
      DrawKeyframesPanel(ui, session_, keyframes_panel_);
      break;
    case Panel::kTimeline:  // drawn by DrawPanel
      break;
  }
}

}  // namespace gaitsmith::shell
