// SPDX-License-Identifier: MIT
// A document as JSON, for files and for reading. docs/formats.md explains every field.
#pragma once

#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith {

/// @param document must be valid
/// @return indented JSON with every field, ending in a newline; reads back as exactly the same document
[[nodiscard]] std::string EncodeJson(const Document& document);

/// Fields with a standard value may be left out. Unknown or repeated fields are errors.
/// @param text at most 16 MiB
[[nodiscard]] Result<Document> DecodeJson(std::string_view text);

/// A figure alone, as in examples/figures: {"name": ..., "rods": [...]}.
[[nodiscard]] Result<Figure> DecodeFigureJson(std::string_view text);

}  // namespace gaitsmith
