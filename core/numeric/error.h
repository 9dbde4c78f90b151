// SPDX-License-Identifier: MIT
// What went wrong, where, in words. Core never throws and never prints; it returns one of these.
#pragma once

#include <expected>
#include <string>
#include <utility>

namespace gaitsmith {

enum class ErrorCode {
  kOutOfRange,      // a number outside its documented range
  kNotFinite,       // NaN or infinity
  kMissing,         // a required field is absent
  kUnknownName,     // a field, algorithm, figure... that does not exist
  kUnknownVersion,  // made by a newer Gaitsmith
  kTruncated,       // data ends too early
  kTrailing,        // data goes on after its end
  kChecksum,        // CRC-32 differs: the data was damaged on the way
  kSyntax,          // not JSON, not base64url, wrong type
  kTooMany,         // over a stated limit
  kStructure,       // a figure that is not a tree, a clip without its controller...
};

struct Error {
  ErrorCode code;
  std::string where;  // path of the culprit, e.g. "figure.rods[2].length_m"
  std::string what;   // one clear sentence part, e.g. "must be from 0.001 to 1000, is -1"

  /// "figure.rods[2].length_m: must be from 0.001 to 1000, is -1"
  [[nodiscard]] std::string Sentence() const { return where.empty() ? what : where + ": " + what; }
};

template <class T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> Fail(ErrorCode code, std::string where, std::string what) {
  return std::unexpected(Error{code, std::move(where), std::move(what)});
}

}  // namespace gaitsmith
