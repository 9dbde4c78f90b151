// SPDX-License-Identifier: MIT
// Reads and writes text files, with "-" for standard input and output, and finds documents and figures by
// name.
#pragma once

#include <string>

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

[[nodiscard]] Result<std::string> ReadText(const std::string& path);
/// Writes to a temporary file in the same folder and renames it, so that a failure keeps the old file intact.
[[nodiscard]] Result<void> WriteText(const std::string& path, const std::string& text);

/// Reads a document from a JSON file, a link, or the name of a shipped example, problem or gallery motion.
[[nodiscard]] Result<Document> ReadDocument(const std::string& path);

/// The only document of a call.
[[nodiscard]] Result<Document> TheDocument(const Arguments& arguments);

/// The controller that a document's motion begins with. @param document has a controller
[[nodiscard]] const Controller& FirstControllerOf(const Document& document);

/// A figure by the name of its file in examples/figures ("mr-star-man") or by path.
[[nodiscard]] Result<Figure> ReadFigure(const std::string& name_or_path);

}  // namespace gaitsmith::shell
