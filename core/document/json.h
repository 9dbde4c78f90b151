// SPDX-License-Identifier: MIT
// A document as JSON, for files and for people. docs/formats.md explains every field.
#pragma once

#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith {

/// @param document valid
/// @return indented JSON with every field, ending in a newline; reads back as exactly the same document
[[nodiscard]] std::string EncodeJson(const Document& document);

/// Fields may be left out when they have a standard value; unknown or repeated fields are errors.
/// @param text at most 16 MiB
[[nodiscard]] Result<Document> DecodeJson(std::string_view text);

/// A figure alone, as in examples/figures: {"name": ..., "rods": [...]}.
[[nodiscard]] Result<Figure> DecodeFigureJson(std::string_view text);

}  // namespace gaitsmith
