// SPDX-License-Identifier: MIT
// A document as the fragment of a link: its binary form in base64url [RFC 4648, section 5], without padding.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith {

/// Includes the hash of the document's trajectory. A hash in the document is kept, so that a motion that
/// differs from its author's is not passed on as if it were the same. Otherwise the hash is computed. @param
/// document must be valid
[[nodiscard]] std::string EncodeLink(const Document& document);

/// Bytes in the letters of links.
[[nodiscard]] std::string ToBase64Url(std::span<const std::uint8_t> bytes);
[[nodiscard]] Result<std::vector<std::uint8_t>> FromBase64Url(std::string_view text);

/// @param link a payload, or a whole address with a payload after '#'; surrounding white space is ignored
[[nodiscard]] Result<Document> DecodeLink(std::string_view link);

}  // namespace gaitsmith
