// SPDX-License-Identifier: MIT
#include "shell/stage/live_switch.h"

#include "shell/words/language.h"

namespace gaitsmith::shell {

void DrawLiveSwitch(Ui& ui, Session& session, std::string_view id) {
  if (!session.Following().Possible()) return;
  bool on = session.Following().On();
  if (ui.Switch(id, Tr("Live: search on as you change it"), on)) session.Following().Switch(on);
  ui.Gap(8.0f);
}

}  // namespace gaitsmith::shell
