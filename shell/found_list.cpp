// SPDX-License-Identifier: MIT
#include "shell/found_list.h"

#include <array>
#include <string>

#include "shell/algorithm_words.h"
#include "shell/language.h"
#include "shell/search_words.h"
#include "shell/style_words.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

enum class Wish { kNothing, kShow, kInsert, kKeep, kDelete };

std::string ScoreText(const FoundMotion& found) {
  if (!found.Moves()) return Tr("failed");
  return found.Score() <= kVoidScore ? Tr("no score") : Fixed(found.Score(), 2);
}

/// What controls it: the controller's own, which need not be what its document would search next.
struct Control {
  ControllerKind kind;
  SenseSpec senses;
  int rules;
};
Control ControlOf(const Document& d) {
  if (d.controllers.empty()) return {d.kind, d.senses, d.rules};
  const Controller& last = d.controllers.back();
  return {last.kind, last.senses, last.rules};
}

/// "SPHC · seed 3 · 40,000 · physical", "SPHC · seed 3 · stopped at 3,100 · timer 0.80 s", "kept by hand ·
/// network"
std::string LineOf(const FoundMotion& found, bool with_unit) {
  const Document& d = found.document;
  const Control control = ControlOf(d);
  const std::string decider = DeciderWords(control.kind, control.senses);
  if (found.origin == Origin::kByHand) return Tr("kept by hand · {1}", decider);
  const char* pattern =
      with_unit ? TrLater("{1} · seed {2} · {3} evaluations · {4}") : TrLater("{1} · seed {2} · {3} · {4}");
  if (found.origin == Origin::kStopped) {
    pattern = with_unit ? TrLater("{1} · seed {2} · stopped at {3} evaluations · {4}")
                        : TrLater("{1} · seed {2} · stopped at {3} · {4}");
  } else if (found.origin == Origin::kFailed) {
    pattern = with_unit ? TrLater("{1} · seed {2} · failed at {3} evaluations · {4}")
                        : TrLater("{1} · seed {2} · failed at {3} · {4}");
  }
  return Tr(pattern, WordsOf(d.search.algorithm).name, std::to_string(d.search.seed),
            Grouped(found.evaluations), decider);
}

std::string SceneText(const FoundMotion& found) {
  const Control control = ControlOf(found.document);
  return SearchTitle(found.document) + ", " + ControllerWords(control.kind, control.senses, control.rules);
}

Wish DrawEntry(Ui& ui, const Session& session, const FoundMotions::Entry& entry) {
  const FoundMotion& found = entry.motion;
  const bool shown = session.InHand(entry);
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  const float size = ui.Look().ControlHeight();
  const std::string id = "found/" + entry.id;
  const ImRect row = ui.Row(size + 14.0f);
  const ImRect words(row.Min, {row.Max.x - 3.0f * size - 2.0f, row.Max.y - 2.0f});
  Wish wish = Wish::kNothing;
  std::string scene, score, spoken;
  // Of a hundred entries a few are to be seen, and the others must not cost a frame.
  if (ImGui::IsRectVisible(row.Min, row.Max)) {
    scene = SceneText(found);
    score = ScoreText(found);
    spoken = LineOf(found, true) + ". " +
             (found.Moves() ? ScoreWords(found.document.task, found.terms) : Tr("It failed."));
  }
  const Touch touch = ui.Area(
      id, words, Grab::kPress,
      {.label = Tr("Show {1}", scene), .role = "button", .value = spoken, .state = {.selected = shown}});
  if (touch.pressed) wish = Wish::kShow;
  if (touch.visible) {
    const ImU32 fill =
        shown ? Mix(p.panel, p.accent, 0.12f) : Mix(p.panel, p.ink, touch.hovered ? 0.05f : 0.0f);
    if (shown || touch.hovered) ui.Canvas()->AddRectFilled(words.Min, words.Max, fill, kCornerRadius);
    const float left = words.Min.x + 6.0f;
    const float right = words.Max.x - 6.0f;
    const float y = words.GetCenter().y;
    const float score_width = letters.Width(Type::kStrong, score);
    const ImU32 score_ink = !found.Moves() || found.Score() <= kVoidScore ? p.bad : p.ink;
    letters.DrawElided(ui.Canvas(), Type::kBody, {left, y - 8.0f}, right - left - score_width - 8.0f, p.ink,
                       SearchTitle(found.document));
    letters.Draw(ui.Canvas(), Type::kStrong, {right, y - 8.0f}, score_ink, score, Align::kRight);
    letters.DrawElided(ui.Canvas(), Type::kNote, {left, y + 9.0f}, right - left, p.second_ink,
                       LineOf(found, false));
    ui.DrawFocus(touch, words);
  }
  const float top = words.GetCenter().y - 0.5f * size;
  const ImRect remove({row.Max.x - size, top}, {row.Max.x, top + size});
  const ImRect keep({remove.Min.x - size, top}, {remove.Min.x, top + size});
  const ImRect insert({keep.Min.x - size, top}, {keep.Min.x, top + size});
  if (ui.IconButton(id + "/insert", insert, Icon::kPlus,
                    Tr("Insert into the timeline at the moment shown: {1}", scene), ButtonLook::kPlain,
                    found.Moves())) {
    wish = Wish::kInsert;
  }
  const Touch star = ui.Area(id + "/keep", keep, Grab::kPress,
                             {.label = Tr("Keep: {1}", scene),
                              .role = "switch",
                              .value = Tr(found.kept ? "on" : "off"),
                              .state = {.checked = found.kept}});
  if (star.pressed) wish = Wish::kKeep;
  if (star.visible) {
    if (star.hovered)
      ui.Canvas()->AddRectFilled(keep.Min, keep.Max, Mix(p.panel, p.ink, 0.05f), kCornerRadius);
    DrawIcon(ui.Canvas(), found.kept ? Icon::kBookmarkFull : Icon::kBookmark, keep.GetCenter(), 14.0f,
             found.kept ? p.accent : p.second_ink);
    ui.DrawFocus(star, keep);
  }
  if (ui.IconButton(id + "/delete", remove, Icon::kClose, Tr("Delete: {1}", scene))) wish = Wish::kDelete;
  return wish;
}

}  // namespace

void DrawFound(Ui& ui, Session& session, FoundMotions::Order& order) {
  FoundMotions& found = session.found;
  if (const FoundMotions::Entry* removed = found.Removed()) {
    const ImRect row = ui.ControlRow();
    const ImRect button({row.Max.x - 96.0f, row.Min.y}, row.Max);
    ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {row.Min.x, row.GetCenter().y}, row.GetWidth() - 104.0f,
                            ui.Ink().second_ink, Tr("Deleted: {1}", SceneText(removed->motion)));
    if (ui.Button("found/bring-back", button, Tr("Bring back"))) found.BringBack();
    ui.Gap(6.0f);
  }
  if (found.Empty()) {
    ui.Paragraph(Tr("What searches find is listed here, and what you keep."), Type::kNote);
    return;
  }
  static constexpr std::array<const char*, 2> kOrders = {TrLater("Newest first"), TrLater("Best first")};
  int chosen = static_cast<int>(order);
  if (ui.Segmented("found/order", ui.ControlRow(), Tr("Order of the results"), kOrders, chosen))
    order = static_cast<FoundMotions::Order>(chosen);
  ui.Gap(6.0f);
  // What is pressed changes the list, so it is done after it.
  Wish wish = Wish::kNothing;
  std::string id;
  bool kept = false;
  for (const FoundMotions::Entry* entry : found.Sorted(order)) {
    const Wish here = DrawEntry(ui, session, *entry);
    if (here == Wish::kNothing) continue;
    wish = here;
    id = entry->id;
    kept = entry->motion.kept;
  }
  ui.Gap(4.0f);
  ui.Paragraph(Tr("Up to 100 stay; where room is short, the oldest that are not kept go."), Type::kNote);
  if (wish == Wish::kShow) session.ShowFound(id);
  if (wish == Wish::kInsert) session.InsertFound(id);
  if (wish == Wish::kKeep) found.Keep(id, !kept);
  if (wish == Wish::kDelete) found.Remove(id);
}

}  // namespace gaitsmith::shell
