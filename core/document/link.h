// SPDX-License-Identifier: MIT
// A document as the fragment of a link: its binary form in base64url [RFC 4648, section 5], without padding.
#pragma once

#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith {

/// The hash of the document's trajectory travels along: its own, if it has one (so that a motion which
/// differs from its maker's is never passed on as if it were the same), else computed. @param document valid
[[nodiscard]] std::string EncodeLink(const Document& document);

/// @param link a payload, or a whole address whose part after '#' is one; white space around it is ignored
[[nodiscard]] Result<Document> DecodeLink(std::string_view link);

}  // namespace gaitsmith
