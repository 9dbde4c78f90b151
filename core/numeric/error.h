// SPDX-License-Identifier: MIT
// An error: what went wrong and where, in words. Core never throws and never prints. It returns an Error
// instead.
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
  kTrailing,        // data continues after its end
  kChecksum,        // the CRC-32 differs: the data was damaged in transfer
  kSyntax,          // not JSON, not base64url, wrong type
  kTooMany,         // over a stated limit
  kStructure,       // a figure that is not a tree, a clip without its controller...
};

struct Error {
  ErrorCode code;
  std::string where;  // path of the faulty value, e.g. "figure.rods[2].length_m"
  std::string what;   // the rest of the sentence, e.g. "must be from 0.001 to 1000, is -1"

  /// "figure.rods[2].length_m: must be from 0.001 to 1000, is -1"
  [[nodiscard]] std::string Sentence() const { return where.empty() ? what : where + ": " + what; }
};

template <class T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> Fail(ErrorCode code, std::string where, std::string what) {
  return std::unexpected(Error{code, std::move(where), std::move(what)});
}

}  // namespace gaitsmith
