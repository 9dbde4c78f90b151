// SPDX-License-Identifier: MIT
#include "shell/stage/viewer.h"

#include <algorithm>
#include <string>

#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kEdge = 16.0f;
constexpr float kTallStage = 330.0f;  // lower stages have no room for the sentence below the numbers
constexpr float kFlatStage = 200.0f;  // lower ones have room for the title alone
constexpr float kBetween = 8.0f;
constexpr float kIconRoom = 54.0f;  // of a large button's icon and borders

bool OffersPush(const Session& session) {
  return !session.World().Changed() && !session.Layout().Locks(LockedPart::kWorld);
}

const char* PushHint() { return Tr("Drag the figure to push it."); }

}  // namespace

float DrawViewerWords(Ui& ui, const Session& session, const ImRect& stage) {
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  const bool wide = stage.GetWidth() >= kPhoneWidth;
  const bool low = stage.GetHeight() < kFlatStage;
  const float left = stage.Min.x + kEdge;
  const float room = stage.Max.x - kEdge - left;
  float y = stage.Min.y + (low ? 18.0f : wide ? 36.0f : 30.0f);
  const auto line = [&](Type type, ImU32 colour, std::string_view text, float height) {
    letters.DrawElided(ui.Canvas(), type, {left, y}, room, colour, text);
    ui.DescribeText(text, {{left, y - 0.5f * height}, {left + room, y + 0.5f * height}});
    y += height;
  };
  // A search's own title goes on with its settings, which a stranger does not need.
  const std::string whole = TrTitle(session.Doc().title);
  const std::string title = whole.substr(0, whole.find(" · "));
  const bool large = letters.Width(Type::kTitle, title) <= room;
  line(low ? Type::kHeading : large ? Type::kTitle : Type::kLarge, p.ink, title, low ? 24.0f : 34.0f);
  if (low) return y;

  // Not described: the stage's value has the same numbers.
  const Terms& terms = session.Player().TermsNow();
  const bool jump = session.Doc().task.kind == TaskKind::kJump;
  const std::string metres =
      Fixed(jump ? terms.max_cm_height_m - terms.start_height_m : terms.travel_m, 2) + " m";
  letters.Draw(ui.Canvas(), Type::kHeading, {left, y}, p.ink, metres);
  letters.Draw(ui.Canvas(), Type::kBody, {left + letters.Width(Type::kHeading, metres) + 7.0f, y},
               p.second_ink, Tr(jump ? "jump in {1} s" : "in {1} s", Fixed(session.Player().TimeS(), 1)));
  y += 25.0f;
  if (stage.GetHeight() >= kTallStage)
    line(Type::kBody, p.second_ink, Tr("Nobody animated this. A computer found it."), 24.0f);
  if (!wide && OffersPush(session)) line(Type::kBody, p.second_ink, PushHint(), 24.0f);
  return y;
}

bool DrawViewerActions(Ui& ui, Session& session, const ImRect& row) {
  const Fonts& letters = ui.Letters();
  const bool wide = row.GetWidth() + 2.0f * kEdge >= kPhoneWidth;
  const bool explains = session.Layout().Shows(IndexOf(Panel::kController));
  const char* how = Tr("How it works");
  const float how_width = explains ? letters.Width(Type::kBody, how) + 34.0f : 0.0f;
  const char* make = Tr("Make your own");
  const float room = row.GetWidth() - how_width - kBetween;
  const float width = wide ? std::min(room, letters.Width(Type::kLarge, make) + 90.0f) : room;
  const float x = row.Min.x + width + kBetween;
  const ImRect button(row.Min, {row.Min.x + width, row.Max.y});
  const bool makes = letters.Width(Type::kLarge, make) + kIconRoom <= width
                         ? ui.LargeButton("stage/make", button, Icon::kPencil, make)
                         : ui.Button("stage/make", button, make, ButtonLook::kPrimary);
  const bool asks = explains && ui.Button("stage/how", {{x, row.Min.y}, {x + how_width, row.Max.y}}, how);
  if (wide && OffersPush(session)) {
    const std::string_view hint = PushHint();
    const float free = row.Max.x - x - how_width - 2.0f * kBetween;
    const float length = std::min(free, letters.Width(Type::kBody, hint));
    const float y = row.GetCenter().y;
    letters.DrawElided(ui.Canvas(), Type::kBody, {row.Max.x - length, y}, length + 1.0f, ui.Ink().second_ink,
                       hint);
    ui.DescribeText(hint, {{row.Max.x - length, y - 9.0f}, {row.Max.x, y + 9.0f}});
  }
  if (makes) session.LeaveViewer();
  return asks;
}

}  // namespace gaitsmith::shell
