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
  const bool repeats = session.Search().WouldRepeat() && !layout.Locks(LockedPart::kSearch);
  const char* another = repeats ? Tr("Try another") : TeachWords(session.Doc());
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
  const float width = std::min(row.GetWidth(), 320.0f);
  const float left = row.GetCenter().x - 0.5f * width;
  const ImRect button({left, row.Min.y}, {left + width, row.Max.y});
  if (ui.Button("stage/stop", button, Tr("Stop and keep this"))) session.Stop();
  ui.Canvas()->AddRectFilled(
      {button.Min.x + 3.0f, button.Max.y - 4.0f},
      {button.Min.x + 3.0f + session.Search().Progress().Share() * (width - 6.0f), button.Max.y - 1.0f},
      ui.Ink().accent, 1.5f);
}

}  // namespace

bool HasStageActions(const Session& session, const ImRect& stage) {
  return stage.GetHeight() >= kLeastStage && session.Layout().Shows(IndexOf(Panel::kSearch));
}

ImRect ActionRow(const Ui& ui, const Session& session, const ImRect& stage, float ground_y) {
  const float height = ui.Look().touch || session.Viewing() ? 46.0f : 40.0f;
  const float top = stage.Max.y - 0.5f * (stage.Max.y - ground_y - kRulerRoom + height);
  return {{stage.Min.x + kMargin, top}, {stage.Max.x - kMargin, top + height}};
}

void DrawStageActions(Ui& ui, Session& session, const ImRect& row) {
  if (Searches(session)) return DrawStop(ui, session, row);
  if (!session.Doc().timeline.empty() && !session.Lab().Running()) DrawRow(ui, row, FoundActions(session));
}

}  // namespace gaitsmith::shell
