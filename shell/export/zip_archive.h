// SPDX-License-Identifier: MIT
// Several files as one ZIP archive, as they are: pictures are compressed already.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

struct ArchivedFile {
  std::string_view name;
  std::string content;
};

/// @param files at most 100, with less than 2 GB in all. Their date is the format's first, 1 January 1980, so
/// that equal files give equal archives.
[[nodiscard]] std::string ZipOf(std::span<const ArchivedFile> files);

}  // namespace gaitsmith::shell
