// SPDX-License-Identifier: MIT
// Any text: the JSON decoder returns a document or an error, and an accepted document survives every encoding
// unchanged.
#include <cstdlib>
#include <string_view>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/document/link.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  const auto document = DecodeJson({reinterpret_cast<const char*>(data), size});
  if (!document) {
    if (document.error().what.empty()) std::abort();
    return 0;
  }
  const std::string json = EncodeJson(*document);
  const auto again = DecodeBinary(EncodeBinary(*document));
  if (!again || EncodeJson(*again) != json) std::abort();
  const auto reread = DecodeJson(json);
  if (!reread || EncodeJson(*reread) != json) std::abort();
  Document hashed = *document;
  hashed.hash = hashed.hash.value_or(1);  // links need a hash, and computing it takes a simulation
  const auto linked = DecodeLink(EncodeLink(hashed));
  if (!linked || EncodeJson(*linked) != EncodeJson(hashed)) std::abort();
  return 0;
}
