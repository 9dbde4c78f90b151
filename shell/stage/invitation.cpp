// SPDX-License-Identifier: MIT
#include "shell/stage/invitation.h"

#include <algorithm>

#include "core/document/standing.h"
#include "shell/words/figure_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kSide = 16.0f;
constexpr float kLine = 28.0f;       // between the lines of a headline
constexpr float kHeadline = 70.0f;   // height that it takes
constexpr float kLowStage = 330.0f;  // on lower ones the figure would reach into the headline

constexpr float kBeside = 0.54f;  // share of the stage's width to the left of the button

}  // namespace

bool Invites(const Session& session) {
  return session.Doc().timeline.empty() && !session.Search().Running() && !session.Lab().Running();
}

bool InvitesBeside(const ImRect& stage) { return stage.GetWidth() >= kPhoneWidth; }

Framing InvitationFraming(const ImRect& stage) {
  const bool beside = InvitesBeside(stage);
  return {.headroom = beside && stage.GetHeight() >= kLowStage ? 0.0f : kHeadline,
          .left = 0.06f,
          .right = beside ? kBeside : 0.94f};
}

void DrawInvitation(Ui& ui, Session& session, const ImRect& stage) {
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  const std::string& name = session.Doc().figure.name;
  const std::string headline = CannotMoveWords(name);
  const bool wide = InvitesBeside(stage);
  const ImVec2 at(stage.Min.x + (wide ? 28.0f : kSide), stage.Min.y + (wide ? 40.0f : 28.0f));
  const float room = stage.Max.x - kSide - at.x;
  const bool tall = stage.GetHeight() >= kLowStage;
  const bool title = wide && tall && letters.Width(Type::kTitle, headline) <= room;
  const Type type = title ? Type::kTitle : Type::kLarge;
  std::string_view rest = headline;
  float line = at.y;
  for (; !rest.empty(); line += kLine) {
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

  const bool quick = session.Doc().search.evaluations <= kQuickEvaluations;
  ImRect button;
  if (wide) {
    const float free = (1.0f - kBeside) * stage.GetWidth() - kSide;
    const float width = std::min(free, 500.0f);
    const float height = std::clamp(0.16f * stage.GetHeight(), 58.0f, 104.0f);
    const ImVec2 centre(stage.Min.x + kBeside * stage.GetWidth() + 0.5f * free,
                        stage.Min.y + 0.47f * stage.GetHeight());
    button = {{centre.x - 0.5f * width, centre.y - 0.5f * height},
              {centre.x + 0.5f * width, centre.y + 0.5f * height}};
    if (tall)
      letters.Draw(ui.Canvas(), Type::kBody, {centre.x, button.Max.y + 22.0f}, p.second_ink,
                   Tr(quick ? "takes a second or two · or press Enter" : "or press Enter"), Align::kCentre);
  } else {
    button = {{stage.Min.x + kSide, stage.Max.y - 66.0f}, {stage.Max.x - kSide, stage.Max.y - 8.0f}};
  }
  if (ui.LargeButton("stage/teach", button, Icon::kPlay, TeachWords(session.Doc()))) session.Synthesize();
}

}  // namespace gaitsmith::shell
