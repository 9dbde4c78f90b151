// SPDX-License-Identifier: MIT
#include "shell/stage/stage_actions.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "shell/words/figure_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kGap = 8.0f;
constexpr float kMargin = 16.0f;
constexpr float kLeastStage = 230.0f;  // lower ones have no room for buttons
constexpr float kRulerRoom = 48.0f;    // of the ruler and the letters, below the ground line

float ActionHeight(const Ui& ui) { return ui.Look().touch ? 46.0f : 40.0f; }

bool Searches(Session& session) { return session.Search().Running() && session.Search().ShowsImprovements(); }

struct Action {
  const char* id;
  std::string label;
  std::function<void()> run;
  ButtonLook look = ButtonLook::kOutlined;
  bool last = false;  // at the right end of the row
};

// Only what the arrangement allows, and nothing that would cut off a search of the queue.
std::vector<Action> FoundActions(Session& session) {
  const Arrangement& layout = session.Layout();
  const bool free = !session.Search().Running();
  std::vector<Action> actions;
  const auto add = [&](bool possible, Action action) {
    if (possible) actions.push_back(std::move(action));
  };
  const char* another = layout.Locks(LockedPart::kSearch)
                            ? TeachWords(session.Doc().figure.name, session.Doc().task.kind)
                            : Tr("Try another");
  add(free, {"stage/another", another, [&session] { session.Synthesize(); }, ButtonLook::kPrimary});
  add(!layout.Locks(LockedPart::kWorld),
      {"stage/push", Tr("Push it"), [&session] { session.World().Shove(); }});
  const bool styled = free && !layout.Locks(LockedPart::kStyle);
  add(styled, {"stage/calmer", Tr("Calmer"), [&session] { session.TryManner(Manner::kCalmer); }});
  add(styled, {"stage/quicker", Tr("Quicker"), [&session] { session.TryManner(Manner::kQuicker); }});
  add(styled, {"stage/higher", Tr("Higher"), [&session] { session.TryManner(Manner::kHigher); }});
  add(free, {"stage/five", Tr("Try 5 more"), [&session] { session.TryMore(); }});
  add(layout.Shows(IndexOf(Panel::kTimeline)) && !layout.Locks(LockedPart::kTimeline),
      {"stage/chain", Tr("Add to timeline"), [&session] { session.Timeline().AddClip(); },
       ButtonLook::kOutlined, true});
  return actions;
}

// Buttons from both ends of the row. Those that do not fit are left out, the last of the list first.
void DrawRow(Ui& ui, const ImRect& row, std::vector<Action> actions) {
  const auto width_of = [&](const Action& action) {
    const Type type = action.look == ButtonLook::kPrimary ? Type::kStrong : Type::kBody;
    return ui.Letters().Width(type, action.label) + 30.0f;
  };
  float used = -kGap;
  const auto over = std::ranges::find_if(actions, [&](const Action& action) {
    used += width_of(action) + kGap;
    return used > row.GetWidth();
  });
  actions.erase(over, actions.end());
  float left = row.Min.x, right = row.Max.x;
  std::function<void()> chosen;
  for (const Action& action : actions) {
    const float width = width_of(action);
    const float x = action.last ? right - width : left;
    if (ui.Button(action.id, {{x, row.Min.y}, {x + width, row.Max.y}}, action.label, action.look))
      chosen = action.run;
    (action.last ? right : left) += action.last ? -width - kGap : width + kGap;
  }
  if (chosen) chosen();
}

void DrawStop(Ui& ui, Session& session, const ImRect& row) {
  const SearchProgress& progress = session.Search().Progress();
  const float width = std::min(row.GetWidth(), 320.0f);
  const float left = row.GetCenter().x - 0.5f * width;
  const ImRect button({left, row.Min.y}, {left + width, row.Max.y});
  if (ui.Button("stage/stop", button, Tr("Stop and keep this"))) session.Stop();
  const float share = progress.budget > 0
                          ? static_cast<float>(progress.evaluations) / static_cast<float>(progress.budget)
                          : 0.0f;
  ui.Canvas()->AddRectFilled(
      {button.Min.x + 3.0f, button.Max.y - 4.0f},
      {button.Min.x + 3.0f + std::clamp(share, 0.0f, 1.0f) * (width - 6.0f), button.Max.y - 1.0f},
      ui.Ink().accent, 1.5f);
}

}  // namespace

bool HasStageActions(const Session& session, const ImRect& stage) {
  return stage.GetHeight() >= kLeastStage && session.Layout().Shows(IndexOf(Panel::kSearch));
}

bool Invites(const Session& session) {
  return session.Doc().timeline.empty() && !session.Search().Running() && !session.Lab().Running();
}

float GroundRoom(const Session& session, const ImRect& stage) {
  const float height = stage.GetHeight();
  const float bare = std::clamp(0.178f * height, std::min(62.0f, 0.17f * height), 130.0f);
  const bool beside = Invites(session) && stage.GetWidth() >= kPhoneWidth;  // the button is above the ground
  return HasStageActions(session, stage) && !beside ? std::max(bare, 104.0f) : bare;
}

void DrawInvitation(Ui& ui, Session& session, const ImRect& stage) {
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  const std::string& name = session.Doc().figure.name;
  const std::string headline = CannotMoveWords(name);
  const bool wide = stage.GetWidth() >= kPhoneWidth;  // else the button is below the figure
  const ImVec2 at(stage.Min.x + (wide ? 28.0f : kMargin), stage.Min.y + (wide ? 40.0f : 28.0f));
  const float room = stage.Max.x - kMargin - at.x;
  const bool tall = stage.GetHeight() > 330.0f;
  const bool title = wide && tall && letters.Width(Type::kTitle, headline) <= room;
  const Type type = title ? Type::kTitle : Type::kLarge;
  std::string_view rest = headline;
  float line = at.y;
  for (float height = 28.0f; !rest.empty(); line += height) {
    const std::size_t length = letters.FitLine(type, rest, room);
    letters.DrawElided(ui.Canvas(), type, {at.x, line}, room, p.ink, rest.substr(0, length));
    rest.remove_prefix(length);
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  }
  ui.DescribeText(headline, {{at.x, at.y - 18.0f}, {at.x + room, line - 10.0f}});
  if (tall) {
    const char* aside = Tr("The computer finds out how, by trying.");
    if (title) line += 6.0f;
    letters.DrawElided(ui.Canvas(), wide ? Type::kBody : Type::kNote, {at.x, line},
                       wide ? room : room - 100.0f, p.second_ink, aside);
    ui.DescribeText(aside, {{at.x, line - 9.0f}, {at.x + room, line + 9.0f}});
  }

  if (session.AtDoor()) {
    const float high = ui.Look().touch ? 44.0f : 32.0f;
    const ImVec2 corner(stage.Max.x - (wide ? 98.0f : 12.0f), stage.Min.y + (wide ? 10.0f : 48.0f));
    const char* settings = Tr("Settings");
    const float width = ui.Letters().Width(Type::kBody, settings) + 28.0f;
    if (ui.Button("stage/settings", {{corner.x - width, corner.y}, {corner.x, corner.y + high}}, settings))
      session.LeaveDoor();
  }
  ImRect button;
  if (wide) {
    const float width = std::clamp(0.36f * stage.GetWidth(), 250.0f, 500.0f);
    const float height = std::clamp(0.16f * stage.GetHeight(), 58.0f, 104.0f);
    const ImVec2 centre(stage.Min.x + 0.73f * stage.GetWidth(), stage.Min.y + 0.47f * stage.GetHeight());
    button = {{centre.x - 0.5f * width, centre.y - 0.5f * height},
              {centre.x + 0.5f * width, centre.y + 0.5f * height}};
    if (tall)
      letters.Draw(ui.Canvas(), Type::kBody, {centre.x, button.Max.y + 22.0f}, p.second_ink,
                   Tr("takes a second or two · or press Enter"), Align::kCentre);
  } else {
    button = {{stage.Min.x + kMargin, stage.Max.y - 66.0f}, {stage.Max.x - kMargin, stage.Max.y - 8.0f}};
  }
  if (ui.LargeButton("stage/teach", button, Icon::kPlay, TeachWords(name, session.Doc().task.kind)))
    session.Synthesize();
}

void DrawStageActions(Ui& ui, Session& session, const ImRect& stage) {
  const float height = ActionHeight(ui);
  const float space = GroundRoom(session, stage) - kRulerRoom;
  const float top = stage.Max.y - 0.5f * (space + height);
  const ImRect row({stage.Min.x + kMargin, top}, {stage.Max.x - kMargin, top + height});
  if (Searches(session)) return DrawStop(ui, session, row);
  if (!session.Doc().timeline.empty() && !session.Lab().Running()) DrawRow(ui, row, FoundActions(session));
}

}  // namespace gaitsmith::shell
