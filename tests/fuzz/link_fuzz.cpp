// SPDX-License-Identifier: MIT
// Any bytes as a link, and as a body with a valid checksum (which a fuzzer would hardly guess): an error, or
// a document whose encoding has exactly these bytes.
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/document/binary.h"
#include "core/document/link.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  static_cast<void>(DecodeLink({reinterpret_cast<const char*>(data), size}));

  for (std::uint8_t version = 1; version <= LatestBinaryVersion(); ++version) {
    std::vector<std::uint8_t> bytes = {version, static_cast<std::uint8_t>(size),
                                       static_cast<std::uint8_t>(size >> 8),
                                       static_cast<std::uint8_t>(size >> 16)};
    bytes.insert(bytes.end(), data, data + size);
    const std::uint32_t crc = Crc32(bytes);
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(crc >> (8 * i)));
    const auto document = DecodeBinary(bytes);
    if (!document) continue;
    if (!Validate(*document)) std::abort();
    if (EncodeBinary(*document) != bytes) std::abort();
  }
  return 0;
}
