// SPDX-License-Identifier: MIT
// A document in few bytes: version (1 byte), length of the body (3, little-endian), body of packed bits,
// CRC-32 (4). docs/formats.md lists every field. The encoding is canonical: a document has exactly one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith {

/// The newest version: that of the schema's newest field. A document is written in the oldest version that
/// has all its fields.
[[nodiscard]] int LatestBinaryVersion();

/// @param document must be valid
[[nodiscard]] std::vector<std::uint8_t> EncodeBinary(const Document& document);

/// Reports every fault: a newer version, truncation, trailing bytes, a wrong checksum, a value out of range.
[[nodiscard]] Result<Document> DecodeBinary(std::span<const std::uint8_t> bytes);

/// CRC-32 of ISO-HDLC, as in zip and PNG.
[[nodiscard]] std::uint32_t Crc32(std::span<const std::uint8_t> bytes);

}  // namespace gaitsmith
