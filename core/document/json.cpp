// SPDX-License-Identifier: MIT
#include "core/document/json.h"

#include "core/document/json_reader.h"
#include "core/document/json_writer.h"

namespace gaitsmith {

std::string EncodeJson(const Document& document) {
  JsonWriter writer;
  Document copy = document;
  writer.Begin();
  Describe(writer, copy);
  return writer.Finish();
}

Result<Document> DecodeJson(std::string_view text) {
  constexpr std::size_t kMaxBytes = 16u << 20;
  if (text.size() > kMaxBytes) return Fail(ErrorCode::kTooMany, "", "the text is longer than 16 MiB");
  const auto json = ParseJson(text);
  if (!json) return std::unexpected(json.error());
  if (json->kind != JsonValue::Kind::kObject) {
    return Fail(ErrorCode::kSyntax, "",
                std::string("a document must be an object, this is ") + json->KindName());
  }
  JsonReader reader(*json);
  Document document;
  Describe(reader, document);
  reader.Finish();
  if (!reader.Ok()) return std::unexpected(*reader.Fault());
  if (auto references = CheckReferences(document); !references) return std::unexpected(references.error());
  return document;
}

Result<Figure> DecodeFigureJson(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return std::unexpected(json.error());
  if (json->kind != JsonValue::Kind::kObject) {
    return Fail(ErrorCode::kSyntax, "",
                std::string("a figure must be an object, this is ") + json->KindName());
  }
  JsonReader reader(*json);
  Figure figure;
  Describe(reader, figure);
  reader.Finish();
  if (!reader.Ok()) return std::unexpected(*reader.Fault());
  if (auto valid = Validate(figure); !valid) return std::unexpected(valid.error());
  return figure;
}

}  // namespace gaitsmith
