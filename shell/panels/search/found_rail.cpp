// SPDX-License-Identifier: MIT
#include "shell/panels/search/found_rail.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shell/panels/search/found_card.h"
#include "shell/timeline/found_drop.h"
#include "shell/words/language.h"
#include "shell/words/style_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kCardWidth = 168.0f;  // at least
constexpr float kBetween = 10.0f;
constexpr float kInset = 14.0f;
constexpr float kCaption = 24.0f;

/// What the motion does: its own name, or its first clip's.
std::string RailName(const FoundMotion& found) {
  const Document& d = found.document;
  if (!found.name.empty()) return found.name;
  return TrTitle(d.controllers[static_cast<std::size_t>(d.timeline[0].controller)].name);
}

/// @return whether it was pressed
bool DrawRailCard(Ui& ui, const Session& session, const FoundMotions::Entry& entry, MotionStrips& strips,
                  const ImRect& card) {
  const FoundMotion& found = entry.motion;
  // By its trajectory: the open document may have another goal.
  const bool shown = found.document.hash == session.Player().Shown().Hash();
  const std::string name = RailName(found);
  const Touch touch =
      ui.Area("rail/" + entry.id, card, Grab::kPress,
              {.label = Tr("Show {1}", name + ", " + ReachedWords(found.document.task.kind, found.terms)),
               .role = "button",
               .state = {.selected = shown}});
  OfferFound(ui, entry.id, name);
  const Palette& p = ui.Ink();
  ui.CardFrame(card, shown, touch.hovered);
  const double length = found.document.duration_steps * static_cast<double>(kStep);
  const bool moves = session.Player().Playing();
  const float share = moves ? static_cast<float>(std::fmod(ImGui::GetTime(), length) / length) : -1.0f;
  if (const MotionStrip* poses = strips.Of(entry.id, [&found] { return found.document; }); poses != nullptr)
    DrawMotionStrip(ui, *poses,
                    {{card.Min.x + 6.0f, card.Min.y + 5.0f}, {card.Max.x - 6.0f, card.Max.y - kCaption}},
                    share);
  const float y = card.Max.y - 0.5f * kCaption;
  const std::string metres = MetresText(found);
  const float room = card.GetWidth() - 22.0f - ui.Letters().Width(Type::kStrong, metres);
  ui.Letters().DrawElided(ui.Canvas(), shown ? Type::kStrong : Type::kBody, {card.Min.x + 8.0f, y}, room,
                          p.ink, name);
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {card.Max.x - 8.0f, y}, p.ScoreInk(found.Score()), metres,
                    Align::kRight);
  ui.DrawFocus(touch, card, 9.0f);
  return touch.pressed && !shown;
}

/// Asks whether a motion may take the place of several clips.
void DrawQuestion(Ui& ui, Session& session, FoundRailState& state, const ImRect& rect) {
  const float middle = rect.GetCenter().y;
  const float half = 0.5f * ui.Look().ControlHeight();
  const std::string question =
      Tr("Replace the {1} clips of the timeline?", static_cast<int>(session.Doc().timeline.size()));
  ui.Letters().DrawElided(ui.Canvas(), Type::kStrong, {rect.Min.x + kInset, middle - half - 14.0f},
                          rect.GetWidth() - 2.0f * kInset, ui.Ink().ink, question);
  ui.DescribeText(
      question, {{rect.Min.x + kInset, middle - half - 22.0f}, {rect.Max.x - kInset, middle - half - 6.0f}});
  float x = rect.Min.x + kInset;
  const auto button = [&](const char* id, const char* label, ButtonLook look) {
    const float width = ui.Letters().Width(Type::kStrong, label) + 28.0f;
    const ImRect place({x, middle - half + 6.0f}, {x + width, middle + half + 6.0f});
    x += width + kBetween;
    return ui.Button(id, place, label, look);
  };
  const std::string id = state.replacing;
  const bool replaces = button("rail/replace", Tr("Replace"), ButtonLook::kPrimary);
  const bool adds = button("rail/insert", Tr("Insert here"), ButtonLook::kOutlined);
  const bool cancels = button("rail/cancel", Tr("Cancel"), ButtonLook::kOutlined);
  if (replaces) session.ShowFound(id, NextGoal::kOfOpen);
  if (adds) session.Timeline().InsertFound(id);
  if (replaces || adds || cancels) state.replacing.clear();
}

}  // namespace

bool DrawFoundRail(Ui& ui, Session& session, FoundRailState& state, const ImRect& rect) {
  const PartScope part = ui.Part("rail", "region", Tr("Motions"));
  if (!state.replacing.empty() && session.Results().Motions().Find(state.replacing) != nullptr) {
    DrawQuestion(ui, session, state, rect);
    return false;
  }
  state.replacing.clear();
  std::vector<const FoundMotions::Entry*> motions;
  for (const FoundMotions::Entry* entry : session.Results().Motions().Sorted(FoundMotions::Order::kNewest)) {
    if (entry->motion.Moves()) motions.push_back(entry);
  }
  if (motions.empty()) {
    const char* empty = Tr("Motions that searches find appear here.");
    ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {rect.Min.x + kInset, rect.GetCenter().y},
                            rect.GetWidth() - 2.0f * kInset, ui.Ink().second_ink, empty);
    ui.DescribeText(empty, rect);
    return false;
  }
  state.strips.BeginFrame();
  const float room = rect.GetWidth() - 2.0f * kInset + kBetween;
  const auto places = static_cast<std::size_t>(std::max(2.0f, room / (kCardWidth + kBetween)));
  const bool more = motions.size() > places;
  const float width = room / static_cast<float>(places) - kBetween;
  float x = rect.Min.x + kInset;
  const auto next = [&] {
    const ImRect card({x, rect.Min.y + 10.0f}, {x + width, rect.Max.y - 8.0f});
    x += width + kBetween;
    return card;
  };
  std::string pressed;
  for (std::size_t i = 0; i < std::min(motions.size(), more ? places - 1 : places); ++i) {
    if (DrawRailCard(ui, session, *motions[i], state.strips, next())) pressed = motions[i]->id;
  }
  const bool all =
      more && ui.Button("rail/all", next(), Tr("All {1} motions", static_cast<int>(motions.size())));
  if (!pressed.empty()) {
    if (session.Doc().timeline.size() > 1) {
      state.replacing = pressed;
    } else {
      session.ShowFound(pressed, NextGoal::kOfOpen);
    }
  }
  return all;
}

}  // namespace gaitsmith::shell
