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
constexpr std::size_t kMostInRow = 9;  // with the menu: more are hard to take in
constexpr float kRulerRoom = 48.0f;    // of the ruler and the letters, below the ground line

bool Searches(Session& session) { return session.Search().Running() && session.Search().ShowsImprovements(); }

struct Action {
  const char* id;
  std::string label;
  std::function<void()> run;
  int rank = 0;        // where not all fit, the highest ranks go into the menu
  bool right = false;  // at the right end of the row
  ButtonLook look = ButtonLook::kOutlined;
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
  add(free, {"stage/another", another, [&session] { session.Synthesize(); }, 0, false, ButtonLook::kPrimary});
  add(!layout.Locks(LockedPart::kWorld),
      {"stage/push", Tr("Push it"), [&session] { session.World().Shove(); }, 1});
  const bool styled = free && !layout.Locks(LockedPart::kStyle);
  add(styled, {"stage/calmer", Tr("Calmer"), [&session] { session.TryManner(Manner::kCalmer); }, 3});
  add(styled, {"stage/quicker", Tr("Quicker"), [&session] { session.TryManner(Manner::kQuicker); }, 5});
  add(styled, {"stage/higher", Tr("Higher"), [&session] { session.TryManner(Manner::kHigher); }, 8});
  add(free, {"stage/five", Tr("Try 5 more"), [&session] { session.TryMore(); }, 9});
  add(layout.Shows(IndexOf(Panel::kTimeline)) && !layout.Locks(LockedPart::kTimeline),
      {"stage/chain", Tr("Add to timeline"), [&session] { session.Timeline().AddClip(); }, 6, true});
  add(free && layout.Shows(IndexOf(Panel::kKeyframes)) && !layout.Locks(LockedPart::kTimeline) &&
          !session.Doc().figure.HasSprings(),
      {"stage/keyframes", Tr("Keyframes"), [&session] { session.OpenKeyframes(); }, 10, true});
  const auto dialog = [&](const char* id, const char* label, const char* command, int rank) {
    add(session.HasDialogs(), {id, label, [&session, command] { session.OpenDialog(command); }, rank, true});
  };
  if (free && !layout.Locks(LockedPart::kController) && !layout.Locks(LockedPart::kSearch))
    dialog("stage/breed", Tr("Breed"), "motion/breed", 4);
  dialog("stage/share", Tr("Share"), "document/share", 2);
  dialog("stage/export", Tr("Export"), "document/export", 7);
  return actions;
}

// Takes away actions until the others have room and are few enough, those of the highest ranks. @return what
// was taken away
std::vector<Action> TakeExcess(std::vector<Action>& actions,
                               const std::function<float(const Action&)>& width_of, float room,
                               float menu_width) {
  std::vector<Action> excess;
  const auto used = [&] {
    float width = excess.empty() ? -kGap : menu_width;
    for (const Action& action : actions) width += width_of(action) + kGap;
    return width;
  };
  const auto count = [&] { return actions.size() + (excess.empty() ? 0 : 1); };
  while (!actions.empty() && (used() > room || count() > kMostInRow)) {
    const auto least = std::ranges::max_element(actions, {}, &Action::rank);
    excess.push_back(std::move(*least));
    actions.erase(least);
  }
  std::ranges::reverse(excess);
  return excess;
}

// Buttons from both ends of the row. Those that do not fit are in a menu at the right end.
void DrawRow(Ui& ui, const ImRect& row, std::vector<Action> actions) {
  const auto width_of = [&](const Action& action) {
    const Type type = action.look == ButtonLook::kPrimary ? Type::kStrong : Type::kBody;
    return ui.Letters().Width(type, action.label) + 30.0f;
  };
  const char* more = Tr("More");
  const float menu_width = ui.Letters().Width(Type::kBody, more) + 46.0f;
  const std::vector<Action> excess = TakeExcess(actions, width_of, row.GetWidth(), menu_width);
  float left = row.Min.x, right = row.Max.x - (excess.empty() ? 0.0f : menu_width + kGap);
  for (const Action& action : actions) right -= action.right ? width_of(action) + kGap : 0.0f;
  right += kGap;
  std::function<void()> chosen;
  for (const Action& action : actions) {
    float& x = action.right ? right : left;
    const float width = width_of(action);
    if (ui.Button(action.id, {{x, row.Min.y}, {x + width, row.Max.y}}, action.label, action.look))
      chosen = action.run;
    x += width + kGap;
  }
  if (!excess.empty()) {
    std::vector<std::string> labels;
    labels.reserve(excess.size());
    for (const Action& action : excess) labels.push_back(action.label);
    const int picked = ui.Menu("stage/more", {{row.Max.x - menu_width, row.Min.y}, row.Max}, more, labels);
    if (picked >= 0) chosen = excess[static_cast<std::size_t>(picked)].run;
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
