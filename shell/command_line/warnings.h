// SPDX-License-Identifier: MIT
// What a command reports on standard error although it goes on.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Warns if the document's joints are limited and its rods too unequal for them. @param name of the document
/// or figure, may be empty
void WarnOfMasses(const std::string& name, const Document&);

}  // namespace gaitsmith::shell
