// SPDX-License-Identifier: MIT
#include "shell/panels/search/found_card.h"

#include <array>
#include <cmath>

#include "shell/timeline/found_drop.h"
#include "shell/words/algorithm_words.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kStripHeight = 54.0f;
constexpr float kLine = 17.0f;  // height of a text line

/// The found controller's kind, senses and rules. The document's settings for the next search may differ.
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
  const std::string mode = ControlModeWords(control.kind, control.senses);
  if (found.origin == Origin::kByHand) return Tr("saved · {1}", mode);
  const char* pattern =
      with_unit ? TrLater("{1} · seed {2} · {3} evaluations · {4}") : TrLater("{1} · seed {2} · {3} · {4}");
  if (found.origin == Origin::kStopped) {
    pattern = with_unit ? TrLater("{1} · seed {2} · stopped at {3} evaluations · {4}")
                        : TrLater("{1} · seed {2} · stopped at {3} · {4}");
  } else if (found.origin == Origin::kFailed) {
    pattern = with_unit ? TrLater("{1} · seed {2} · failed at {3} evaluations · {4}")
                        : TrLater("{1} · seed {2} · failed at {3} · {4}");
  }
  return Tr(pattern, AlgorithmName(d.search.algorithm), std::to_string(d.search.seed),
            Grouped(found.evaluations), mode);
}

bool HasTerms(const FoundMotion& found) { return found.Moves() && !found.terms.broke_physics; }

/// Progress of the motion on a card, [0, 1); below 0 while playback is paused.
float ShareNow(const Session& session, const Document& document) {
  if (!session.Player().Playing()) return -1.0f;
  const double length = document.duration_steps * static_cast<double>(kStep);
  return static_cast<float>(std::fmod(ImGui::GetTime(), length) / length);
}

/// The buttons below the text, from left to right.
class ButtonRow {
 public:
  ButtonRow(Ui& ui, const ImRect& row) : ui_(ui), size_(row.GetHeight()), x_(row.Min.x), row_(row) {}
  ImRect Next() {
    const ImRect place({x_, row_.Min.y}, {x_ + size_, row_.Max.y});
    x_ += size_ + 2.0f;
    return place;
  }
  bool Put(const std::string& id, Icon icon, const std::string& label, bool enabled = true) {
    return ui_.IconButton(id, Next(), icon, label, ButtonLook::kPlain, enabled);
  }
  /// The rest of the row.
  [[nodiscard]] ImRect Rest() const { return {{x_ + 4.0f, row_.Min.y}, row_.Max}; }

 private:
  Ui& ui_;
  float size_, x_;
  ImRect row_;
};

bool DrawKeepSwitch(Ui& ui, const std::string& id, const ImRect& rect, const std::string& scene, bool kept) {
  const Touch star = ui.Area(id, rect, Grab::kPress,
                             {.label = Tr("Save: {1}", scene),
                              .role = "switch",
                              .value = Tr(kept ? "on" : "off"),
                              .state = {.checked = kept}});
  if (!star.visible) return star.pressed;
  if (star.hovered)
    ui.Canvas()->AddRectFilled(rect.Min, rect.Max, Mix(ui.Ink().panel, ui.Ink().ink, 0.05f), kCornerRadius);
  DrawIcon(ui.Canvas(), kept ? Icon::kBookmarkFull : Icon::kBookmark, rect.GetCenter(), 14.0f,
           kept ? ui.Ink().accent : ui.Ink().second_ink);
  ui.DrawFocus(star, rect);
  return star.pressed;
}

CardAction DrawButtons(Ui& ui, const Session& session, const FoundMotions::Entry& entry, const ImRect& row,
                       const std::string& scene) {
  const FoundMotion& found = entry.motion;
  const std::string id = "found/" + entry.id;
  CardAction action = CardAction::kNothing;
  ButtonRow buttons(ui, row);
  if (buttons.Put(id + "/insert", Icon::kPlus, Tr("Insert into the timeline at the moment shown: {1}", scene),
                  found.Moves()))
    action = CardAction::kInsert;
  if (DrawKeepSwitch(ui, id + "/keep", buttons.Next(), scene, found.kept)) action = CardAction::kKeep;
  if (session.Results().CanAskName() && buttons.Put(id + "/rename", Icon::kPencil, Tr("Name: {1}", scene)))
    action = CardAction::kRename;
  if (buttons.Put(id + "/again", Icon::kRestart,
                  Tr("Make again, with the same seed and settings: {1}", scene), found.CanRepeat()))
    action = CardAction::kAgain;
  if (found.Moves() && session.Results().CanLearn()) {
    if (buttons.Put(id + "/like", Icon::kHeart, Tr("More like this: {1}", scene)))
      action = CardAction::kMoreLike;
    if (buttons.Put(id + "/dislike", Icon::kNoHeart, Tr("Less like this: {1}", scene)))
      action = CardAction::kLessLike;
  }
  if (found.Moves() && session.CanTryBrain(found.document) &&
      buttons.Put(id + "/brain", Icon::kSwap, Tr("Try on the shown body: {1}", scene)))
    action = CardAction::kBrain;
  if (buttons.Put(id + "/delete", Icon::kClose, Tr("Delete: {1}", scene))) action = CardAction::kDelete;
  const ImRect rest = buttons.Rest();
  const std::string metres = MetresText(found);
  if (ui.Letters().Width(Type::kStrong, metres) > rest.GetWidth() - 6.0f) return action;  // on phones
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {rest.Max.x - 6.0f, rest.GetCenter().y},
                    ui.Ink().ScoreInk(found.Score()), metres, Align::kRight);
  return action;
}

void DrawWords(const Ui& ui, const FoundMotion& found, ImVec2 at, float width) {
  const Fonts& letters = ui.Letters();
  letters.DrawElided(ui.Canvas(), Type::kStrong, at, width, ui.Ink().ink, CardName(found));
  at.y += kLine;
  if (HasTerms(found)) {
    letters.DrawElided(ui.Canvas(), Type::kNote, at, width, ui.Ink().second_ink, TermsLine(found.terms));
    at.y += kLine;
  }
  letters.DrawElided(ui.Canvas(), Type::kNote, at, width, ui.Ink().second_ink, LineOf(found, false));
}

}  // namespace

std::string CardName(const FoundMotion& found) {
  return found.name.empty() ? SearchTitle(found.document) : found.name;
}

std::string MetresText(const FoundMotion& found) {
  if (!found.Moves()) return Tr("failed");
  const Terms& terms = found.terms;
  if (terms.broke_physics) return Tr("no score");
  const bool jump = found.document.task.kind == TaskKind::kJump;
  return Fixed(jump ? terms.max_cm_height_m - terms.start_height_m : terms.travel_m, 1) + " m";
}

std::string SceneText(const FoundMotion& found) {
  const Control control = ControlOf(found.document);
  return CardName(found) + ", " + ControllerWords(control.kind, control.senses, control.rules);
}

CardAction DrawFoundCard(Ui& ui, const Session& session, const FoundMotions::Entry& entry,
                         MotionStrips& strips) {
  const FoundMotion& found = entry.motion;
  const float buttons = ui.Look().ControlHeight();
  const float words = kLine * (HasTerms(found) ? 3.0f : 2.0f) + 4.0f;
  const float strip = found.Moves() ? kStripHeight : 0.0f;
  const ImRect card = ui.Row(strip + words + buttons + 14.0f);
  ui.Gap(8.0f);
  // Of up to a hundred cards only a few are visible. Skip the others.
  const bool seen = ImGui::IsRectVisible(card.Min, card.Max);
  const bool shown = seen && session.Results().IsShown(entry);
  const Palette& p = ui.Ink();
  const std::string scene = seen ? SceneText(found) : CardName(found);
  std::string spoken;
  if (seen) {
    spoken = LineOf(found, true) + ". " +
             (found.Moves() ? ScoreWords(found.document, found.terms) : Tr("The search failed."));
  }
  const ImRect upper(card.Min, {card.Max.x, card.Max.y - buttons - 4.0f});
  const Touch touch = ui.Area(
      "found/" + entry.id, upper, Grab::kPress,
      {.label = Tr("Show {1}", scene), .role = "button", .value = spoken, .state = {.selected = shown}});
  if (found.Moves()) OfferFound(ui, entry.id, CardName(found));
  CardAction action = touch.pressed ? CardAction::kShow : CardAction::kNothing;
  if (seen) {
    const ImU32 fill =
        shown ? Mix(p.panel, p.accent, 0.10f) : Mix(p.panel, p.ink, touch.hovered ? 0.04f : 0.0f);
    ui.Frame(card, fill, shown ? p.accent : p.line);
    const ImRect picture({card.Min.x + 5.0f, card.Min.y + 5.0f}, {card.Max.x - 5.0f, card.Min.y + strip});
    if (found.Moves()) {
      const MotionStrip* poses = strips.Of(entry.id, [&found] { return found.document; });
      if (poses != nullptr) DrawMotionStrip(ui, *poses, picture, ShareNow(session, found.document));
    }
    DrawWords(ui, found, {card.Min.x + 8.0f, card.Min.y + strip + 12.0f}, card.GetWidth() - 16.0f);
    ui.DrawFocus(touch, upper);
  }
  const ImRect row({card.Min.x + 3.0f, upper.Max.y}, {card.Max.x, upper.Max.y + buttons});
  const CardAction below = DrawButtons(ui, session, entry, row, scene);
  return below != CardAction::kNothing ? below : action;
}

}  // namespace gaitsmith::shell
