// SPDX-License-Identifier: MIT
// Texts of documents: every character is accepted as itself and as an escape, and invalid text is refused.
#include <catch_amalgamated.hpp>
#include <cstdint>
#include <cstdio>
#include <string>

#include "core/document/json.h"

namespace gaitsmith::test {

namespace {

/// Encodes a character as UTF-8 (RFC 3629) with a given number of bytes.
std::string InBytes(std::uint32_t code, int bytes) {
  if (bytes == 1) return {static_cast<char>(code)};
  std::string text;
  for (int i = bytes - 1; i > 0; --i)
    text.insert(text.begin(), static_cast<char>(0x80 | (code >> 6 * (bytes - 1 - i) & 0x3f)));
  const std::uint32_t lead = (0xf00u >> bytes & 0xff) | code >> 6 * (bytes - 1);
  text.insert(text.begin(), static_cast<char>(lead));
  return text;
}
std::string Utf8(std::uint32_t code) {
  return InBytes(code, code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4);
}

/// \\uXXXX, as one unit or as a pair.
std::string Escape(std::uint32_t code) {
  char text[16];
  if (code < 0x10000) {
    std::snprintf(text, sizeof text, "\\u%04x", code);
  } else {
    std::snprintf(text, sizeof text, "\\u%04X\\u%04x", 0xd800 + ((code - 0x10000) >> 10),
                  0xdc00 + (code & 0x3ff));
  }
  return text;
}

Result<Document> Titled(const std::string& title) {
  return DecodeJson("{\"title\": \"" + title + "\", \"figure\": {\"rods\": [{}, {\"parent\": 0}]}}");
}

/// Whether the title is refused with a reason.
bool IsRefused(const std::string& title) {
  const auto document = Titled(title);
  return !document && !document.error().Sentence().empty();
}

}  // namespace

TEST_CASE("text: every character that can be printed is itself, written or escaped", "[document]") {
  for (const std::uint32_t code :
       {0x20u,    0x41u,    0x7eu,    0x80u,    0xe9u,    0x7ffu,    0x800u,    0x3c0u,
        0xfffu,   0x1000u,  0xcfffu,  0xd7ffu,  0xe000u,  0xfffdu,   0xffffu,   0x10000u,
        0x10123u, 0x1f9b5u, 0x3ffffu, 0x40000u, 0xfffffu, 0x100000u, 0x10fedcu, 0x10ffffu}) {
    CAPTURE(code);
    const auto written = Titled("a" + Utf8(code) + "z");
    REQUIRE(written);
    CHECK(written->title == "a" + Utf8(code) + "z");
    const auto escaped = Titled("a" + Escape(code) + "z");
    REQUIRE(escaped);
    CHECK(escaped->title == written->title);
    const auto again = DecodeJson(EncodeJson(*written));
    REQUIRE(again);
    CHECK(again->title == written->title);
  }
  const auto short_ones = Titled(R"(\"\\\/)");
  REQUIRE(short_ones);
  CHECK(short_ones->title == "\"\\/");
}

TEST_CASE("text: what is no character is refused", "[document]") {
  // Control characters, including the short escapes of some.
  for (std::uint32_t code = 0; code < 0x20; ++code) {
    CAPTURE(code);
    CHECK(IsRefused(Utf8(code)));
    CHECK(IsRefused(Escape(code)));
  }
  CHECK(IsRefused(Utf8(0x7f)));
  for (const char* escape :
       {R"(\b)", R"(\f)", R"(\n)", R"(\r)", R"(\t)", R"(\x)", R"(\u12)", R"(\u12g4)", R"(\U00e9)"}) {
    CAPTURE(escape);
    CHECK(IsRefused(escape));
  }
  // Halves of surrogate pairs: as bytes, escaped, in reverse order, or followed by other text.
  for (const std::uint32_t half : {0xd800u, 0xdbffu, 0xdc00u, 0xdfffu}) {
    CAPTURE(half);
    CHECK(IsRefused(InBytes(half, 3)));
    CHECK(IsRefused(Escape(half)));
    CHECK(IsRefused(Escape(half) + "a"));
    CHECK(IsRefused(Escape(half) + Escape(0x41)));
  }
  CHECK(IsRefused(Escape(0xdc00) + Escape(0xd800)));
  CHECK(IsRefused(Escape(0xd800) + Escape(0xd800)));
  // Above the last character, with too many bytes, with too few, with none.
  CHECK(IsRefused(InBytes(0x110000, 4)));
  CHECK(IsRefused(InBytes(0x140000, 4)));
  for (const auto& [code, bytes] : {std::pair(0x2fu, 2), std::pair(0x7fu, 2), std::pair(0x2fu, 3),
                                    std::pair(0x7ffu, 3), std::pair(0x2fu, 4), std::pair(0xffffu, 4)}) {
    CAPTURE(code, bytes);
    CHECK(IsRefused(InBytes(code, bytes)));
  }
  for (const std::uint32_t code : {0xe9u, 0x3c0u, 0x20acu, 0x1f9b5u}) {
    std::string cut = Utf8(code);
    cut.pop_back();
    CAPTURE(code);
    CHECK(IsRefused(cut));
    CHECK(IsRefused(cut + "a"));
    CHECK(IsRefused(cut + Utf8(0xe9)));
  }
  for (const unsigned lead : {0x80u, 0xbfu, 0xc0u, 0xc1u, 0xf5u, 0xf8u, 0xfcu, 0xfeu, 0xffu}) {
    CAPTURE(lead);
    CHECK(IsRefused(std::string(1, static_cast<char>(lead)) + "\x80\x80\x80\x80\x80"));
  }
}

}  // namespace gaitsmith::test
