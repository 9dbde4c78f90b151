// SPDX-License-Identifier: MIT
// Text in and out of files, with "-" for standard input and output, and documents and figures found by name.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

[[nodiscard]] Result<std::string> ReadText(const std::string& path);
/// Writes to a neighbouring file first and renames it, so that a failure leaves an older file as it was.
[[nodiscard]] Result<void> WriteText(const std::string& path, const std::string& text);

/// A document from a file of JSON, a link, or the name of a shipped example, problem or motion of the
/// gallery.
[[nodiscard]] Result<Document> ReadDocument(const std::string& path);

/// The controller that a document's motion begins with. @param document has one
[[nodiscard]] const Controller& FirstControllerOf(const Document& document);

/// A figure by the name of its file in examples/figures ("mr-star-man") or by path.
[[nodiscard]] Result<Figure> ReadFigure(const std::string& name_or_path);

}  // namespace gaitsmith::shell
