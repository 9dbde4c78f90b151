// SPDX-License-Identifier: MIT
// gaitsmith catalogue: the names used in documents, in links and on the command line, as JSON.
#include "shell/catalogue/catalogue.h"

#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

Outcome CatalogueCommand(Words words) {
  if (!words.empty()) return Fail(ErrorCode::kTrailing, std::string(words[0]), "catalogue takes no words");
  if (const auto done = WriteText("-", CatalogueJson()); !done) return std::unexpected(done.error());
  return {};
}

}  // namespace gaitsmith::shell
