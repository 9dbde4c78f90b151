// SPDX-License-Identifier: MIT
// ZIP archives of stored files.
#include "shell/export/zip_archive.h"

#include <cstdint>
#include <vector>

#include "core/document/binary.h"

namespace gaitsmith::shell {

namespace {

/// A number with its lowest byte first.
std::string Little(std::size_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255u);
  return text;
}

/// What both headers of a file have in common, from the version that a reader needs to the length of the
/// name.
std::string Description(const ArchivedFile& file) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(file.content.data()), file.content.size());
  constexpr std::size_t kVersion = 10, kNamesAreUtf8 = 0x0800, kStored = 0, kTime = 0, kDate = 0x0021;
  std::string text = Little(kVersion, 2);
  for (const std::size_t value : {kNamesAreUtf8, kStored, kTime, kDate}) text += Little(value, 2);
  for (const std::size_t value : {std::size_t{Crc32(bytes)}, file.content.size(), file.content.size()})
    text += Little(value, 4);
  text += Little(file.name.size(), 2);
  return text;
}

}  // namespace

std::string ZipOf(std::span<const ArchivedFile> files) {
  std::string archive, directory;
  for (const ArchivedFile& file : files) {
    const std::string description = Description(file);
    directory.append("PK\x01\x02").append(Little(20, 2)).append(description);
    // Neither extra fields, comment, disk nor attributes; the offset of the file.
    directory.append(Little(0, 2))
        .append(Little(0, 2))
        .append(Little(0, 2))
        .append(Little(0, 2))
        .append(Little(0, 4));
    directory.append(Little(archive.size(), 4)).append(file.name);
    archive.append("PK\x03\x04")
        .append(description)
        .append(Little(0, 2))
        .append(file.name)
        .append(file.content);
  }
  const std::size_t start = archive.size();
  archive.append(directory).append("PK\x05\x06").append(Little(0, 4));
  archive.append(Little(files.size(), 2)).append(Little(files.size(), 2));
  archive.append(Little(directory.size(), 4)).append(Little(start, 4)).append(Little(0, 2));
  return archive;
}

}  // namespace gaitsmith::shell
