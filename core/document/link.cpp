// SPDX-License-Identifier: MIT
#include "core/document/link.h"

#include <array>

#include "core/document/binary.h"

namespace gaitsmith {

namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

constexpr std::uint8_t kForeign = 64;
constexpr auto kValues = [] {
  std::array<std::uint8_t, 256> values{};
  values.fill(kForeign);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    values[static_cast<std::uint8_t>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  return values;
}();

}  // namespace

std::string ToBase64Url(std::span<const std::uint8_t> bytes) {
  std::string text;
  std::uint32_t held = 0;
  int bits = 0;
  for (const std::uint8_t byte : bytes) {
    held = held << 8 | byte;
    bits += 8;
    while (bits >= 6) {
      bits -= 6;
      text.push_back(kAlphabet[(held >> bits) & 63u]);
    }
  }
  if (bits > 0) text.push_back(kAlphabet[(held << (6 - bits)) & 63u]);
  return text;
}

Result<std::vector<std::uint8_t>> FromBase64Url(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t held = 0;
  int bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t value = kValues[static_cast<std::uint8_t>(text[i])];
    if (value == kForeign) {
      return Fail(ErrorCode::kSyntax, "link",
                  "character " + std::to_string(i + 1) + " of " + std::to_string(text.size()) +
                      " does not belong in a link");
    }
    held = held << 6 | value;
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(held >> bits));
    }
  }
  if (bits >= 6 || (held & ((1u << bits) - 1)) != 0) {
    return Fail(ErrorCode::kTruncated, "link", "was cut or damaged: its last character does not fit");
  }
  return bytes;
}

std::string EncodeLink(const Document& document) {
  Document hashed = document;
  if (!hashed.hash) hashed.hash = Simulate(document).Hash();
  return ToBase64Url(EncodeBinary(hashed));
}

Result<Document> DecodeLink(std::string_view link) {
  if (const auto hash = link.find('#'); hash != std::string_view::npos) link.remove_prefix(hash + 1);
  constexpr std::string_view kSpace = " \t\r\n";
  while (!link.empty() && kSpace.find(link.front()) != std::string_view::npos) link.remove_prefix(1);
  while (!link.empty() && kSpace.find(link.back()) != std::string_view::npos) link.remove_suffix(1);
  if (link.empty()) return Fail(ErrorCode::kTruncated, "link", "is empty");
  const auto bytes = FromBase64Url(link);
  if (!bytes) return std::unexpected(bytes.error());
  auto document = DecodeBinary(*bytes);
  if (!document && document.error().where.empty()) document.error().where = "link";
  return document;
}

}  // namespace gaitsmith
