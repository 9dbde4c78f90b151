// SPDX-License-Identifier: MIT
#include "core/document/binary.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/document/archive.h"
#include "core/document/schema.h"
#include "core/numeric/bit_stream.h"

namespace gaitsmith {

namespace {

constexpr std::size_t kHeaderBytes = 4;
constexpr std::size_t kChecksumBytes = 4;
constexpr int kModelBits = 5;
// Bits of a choice's index. Names can be added without a new version: the 16th and later ones take 8 more
// bits.
constexpr int kChoiceBits = 4;
static_assert(kMaxChoices == LongestTable(kChoiceBits));

class BinaryWriter : public Archive {
 public:
  /// @param version fields of later versions are left out
  explicit BinaryWriter(int version) : version_(version) {}
  /// The oldest version that can hold every written field with a non-standard value.
  [[nodiscard]] int Needed() const { return needed_; }

  void Real(std::string_view, float& value, float, float, float standard) override {
    if (Standard(value == standard)) return;
    bits_.Put(std::bit_cast<std::uint32_t>(value), 32);
  }
  void Integer(std::string_view, int& value, int low, int high, int standard) override {
    if (Standard(value == standard)) return;
    bits_.Put(static_cast<std::uint64_t>(std::int64_t{value} - low), IntegerBits(low, high));
  }
  void Model(std::string_view, int& model) override {
    bits_.Put(static_cast<std::uint64_t>(model), kModelBits);
  }
  void Natural(std::string_view, std::uint32_t& value, std::uint32_t standard) override {
    if (Standard(value == standard)) return;
    bits_.Put(value, 32);
  }
  void Flag(std::string_view, bool& value, bool standard) override { Standard(value == standard, value); }
  void Text(std::string_view, std::string& text) override {
    bits_.Put(text.size(), 7);
    for (const char c : text) bits_.Put(static_cast<unsigned char>(c), 8);
  }
  void Hash(std::string_view, std::optional<std::uint64_t>& hash) override {
    if (!Standard(!hash)) bits_.Put(*hash, 64);
  }
  void Genes(Controller& controller, const PortCount& ports) override {
    bits_.Put(static_cast<std::uint64_t>(controller.rules - 1), BitsFor(kMaxRules));
    const ControllerShape shape = controller.Shape(ports);
    for (int component = 0; component < shape.Components(); ++component) {
      for (const GeneGroup& group : shape.GroupsOf(component)) {
        const std::span<const Gene> genes = group.Of(controller.genes);
        if (group.role != GeneRole::kIntervals) {
          for (const Gene gene : genes) bits_.Put(gene, 16);
          continue;
        }
        for (std::size_t i = 0; i < genes.size(); i += 2) {
          if (Standard(!Cares(genes[i], genes[i + 1]))) continue;
          bits_.Put(genes[i], 16);
          bits_.Put(genes[i + 1], 16);
        }
      }
    }
  }
  [[nodiscard]] const std::vector<std::uint8_t>& Body() const { return bits_.Bytes(); }

 private:
  void Index(std::string_view, int& index, std::span<const std::string_view>, int standard) override {
    if (!Standard(index == standard)) bits_.PutIndex(static_cast<std::size_t>(index), kChoiceBits);
  }
  bool BeginSince(int version) override {
    if (version > version_) return false;
    since_.push_back(version);
    return true;
  }
  void EndSince() override { since_.pop_back(); }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    if (Standard(size == 0)) return false;
    bits_.Put(size, BitsFor(static_cast<std::uint64_t>(most) + 1));
    return Archive::BeginList(name, size, most);
  }
  static int IntegerBits(int low, int high) {
    return BitsFor(static_cast<std::uint64_t>(std::int64_t{high} - low) + 1);
  }
  bool Standard(bool is_standard) { return Standard(is_standard, !is_standard); }
  bool Standard(bool is_standard, bool bit) {
    bits_.Put(bit ? 1 : 0, 1);
    if (!is_standard) needed_ = std::max(needed_, since_.back());
    return is_standard;
  }
  BitWriter bits_;
  int version_;
  std::vector<int> since_ = {1};  // last: version that added the present field
  int needed_ = 1;
};

class BinaryReader : public Archive {
 public:
  BinaryReader(std::span<const std::uint8_t> body, int version) : bits_(body), version_(version) {}

  void Real(std::string_view name, float& value, float low, float high, float standard) override {
    value = standard;
    if (!Given(name)) return;
    value = std::bit_cast<float>(static_cast<std::uint32_t>(bits_.Take(32)));
    CheckReal(name, value, low, high);
  }
  void Integer(std::string_view name, int& value, int low, int high, int standard) override {
    value = standard;
    if (!Given(name)) return;
    const auto above = bits_.Take(BitsFor(static_cast<std::uint64_t>(std::int64_t{high} - low) + 1));
    const std::int64_t wide = low + static_cast<std::int64_t>(above);
    CheckInteger(name, wide, low, high);
    if (Ok()) value = static_cast<int>(wide);
  }
  void Model(std::string_view name, int& model) override {
    model = static_cast<int>(bits_.Take(kModelBits));
    CheckLeft(name);
    CheckModel(name, model);
  }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) override {
    value = Given(name) ? static_cast<std::uint32_t>(bits_.Take(32)) : standard;
  }
  void Flag(std::string_view name, bool& value, bool) override { value = Given(name); }
  void Refuse(std::string_view name, const char* why) override { FailAt(name, ErrorCode::kStructure, why); }
  void Text(std::string_view name, std::string& text) override {
    const auto size = static_cast<std::size_t>(bits_.Take(7));
    text.clear();
    for (std::size_t i = 0; i < size; ++i) text.push_back(static_cast<char>(bits_.Take(8)));
    CheckLeft(name);
    CheckText(name, text);
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) override {
    hash.reset();
    if (Given(name)) hash = bits_.Take(64);
    CheckLeft(name);
  }
  void Genes(Controller& controller, const PortCount& ports) override {
    controller.rules = static_cast<int>(bits_.Take(BitsFor(kMaxRules))) + 1;
    if (!Ok() || ports.actuators < 0) return FailAt("rules", ErrorCode::kStructure, "the figure has no rods");
    const ControllerShape shape = controller.Shape(ports);
    const std::string_view list = RowOf(controller.kind).components;
    controller.genes.assign(shape.Genes(), 0);
    for (int component = 0; component < shape.Components(); ++component) {
      for (const GeneGroup& group : shape.GroupsOf(component)) {
        const std::span<Gene> genes = group.Of(controller.genes);
        if (group.role != GeneRole::kIntervals) {
          for (Gene& gene : genes) gene = static_cast<Gene>(bits_.Take(16));
          continue;
        }
        for (std::size_t i = 0; i < genes.size(); i += 2) {
          const bool cares = bits_.Take(1) != 0;
          genes[i] = cares ? static_cast<Gene>(bits_.Take(16)) : Gene{0};
          genes[i + 1] = cares ? static_cast<Gene>(bits_.Take(16)) : kGeneMax;
          if (genes[i] > genes[i + 1])
            return FailAt(list, ErrorCode::kOutOfRange, "an interval ends before it begins");
        }
      }
    }
    CheckLeft(list);
  }
  [[nodiscard]] bool AtEnd() { return bits_.AtEnd(); }

 private:
  void Index(std::string_view name, int& index, std::span<const std::string_view> names,
             int standard) override {
    index = standard;
    if (!Given(name)) return;
    const auto given = static_cast<std::int64_t>(bits_.TakeIndex(kChoiceBits));
    CheckInteger(name, given, 0, static_cast<std::int64_t>(names.size()) - 1);
    CheckLeft(name);
    if (Ok()) index = static_cast<int>(given);
  }
  /// An older version does not have these fields, so they keep their standard values.
  bool BeginSince(int version) override { return version <= version_; }
  [[nodiscard]] bool Reads() const override { return true; }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    if (Given(name)) {
      size = static_cast<std::size_t>(bits_.Take(BitsFor(static_cast<std::uint64_t>(most) + 1)));
      CheckCount(name, size, static_cast<std::size_t>(most));
      CheckLeft(name);
    }
    return Archive::BeginList(name, size, most);
  }
  bool Given(std::string_view name) {
    if (!Ok()) return false;
    const bool given = bits_.Take(1) != 0;
    CheckLeft(name);
    return given && Ok();
  }
  void CheckLeft(std::string_view name) {
    if (bits_.Overrun()) FailAt(name, ErrorCode::kTruncated, "the data ends here, too early");
  }
  BitReader bits_;
  int version_;
};

// Finds the newest version in the schema. Every list gets an item, so that its fields are seen.
class VersionFinder : public Archive {
 public:
  [[nodiscard]] int Latest() const { return latest_; }

 private:
  bool BeginSince(int version) override {
    latest_ = std::max(latest_, version);
    return true;
  }
  [[nodiscard]] bool Reads() const override { return true; }
  bool BeginList(std::string_view name, std::size_t& size, int most) override {
    size = 1;
    return Archive::BeginList(name, size, most);
  }
  int latest_ = 1;
};

void PutLittleEndian(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

std::uint32_t TakeLittleEndian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

}  // namespace

int LatestBinaryVersion() {
  static const int kLatest = [] {
    VersionFinder finder;
    Document document;
    Describe(finder, document);
    return finder.Latest();
  }();
  return kLatest;
}

std::uint32_t Crc32(std::span<const std::uint8_t> bytes) {
  static constexpr auto kOfByte = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
      std::uint32_t crc = byte;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
      table[byte] = crc;
    }
    return table;
  }();
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) crc = (crc >> 8) ^ kOfByte[(crc ^ byte) & 0xffu];
  return ~crc;
}

std::vector<std::uint8_t> EncodeBinary(const Document& document) {
  Document copy = document;
  BinaryWriter writer(LatestBinaryVersion());
  Describe(writer, copy);
  if (const int needed = writer.Needed(); needed < LatestBinaryVersion()) {
    writer = BinaryWriter(needed);
    Describe(writer, copy);
  }
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(writer.Needed())};
  PutLittleEndian(bytes, static_cast<std::uint32_t>(writer.Body().size()), 3);
  bytes.insert(bytes.end(), writer.Body().begin(), writer.Body().end());
  PutLittleEndian(bytes, Crc32(bytes), 4);
  return bytes;
}

Result<Document> DecodeBinary(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Fail(ErrorCode::kTruncated, "", "there is no data");
  if (bytes[0] < 1 || bytes[0] > LatestBinaryVersion()) {
    return Fail(ErrorCode::kUnknownVersion, "",
                "has format version " + std::to_string(bytes[0]) +
                    ", but this Gaitsmith reads versions up to " + std::to_string(LatestBinaryVersion()) +
                    ": it was made by a newer one, or the data is damaged");
  }
  const std::size_t whole =
      bytes.size() < kHeaderBytes ? 0 : TakeLittleEndian(bytes.subspan(1, 3)) + kHeaderBytes + kChecksumBytes;
  if (whole == 0 || bytes.size() < whole) {
    return Fail(ErrorCode::kTruncated, "",
                "was cut: " + std::to_string(bytes.size()) + " bytes arrived" +
                    (whole == 0 ? "" : " of " + std::to_string(whole)));
  }
  if (bytes.size() > whole) {
    return Fail(
        ErrorCode::kTrailing, "",
        "is too long: " + std::to_string(bytes.size()) + " bytes arrived of " + std::to_string(whole));
  }
  if (Crc32(bytes.first(whole - kChecksumBytes)) != TakeLittleEndian(bytes.last(kChecksumBytes))) {
    return Fail(ErrorCode::kChecksum, "", "was damaged on the way: its checksum does not match");
  }

  BinaryReader reader(bytes.subspan(kHeaderBytes, whole - kHeaderBytes - kChecksumBytes), bytes[0]);
  Document document;
  Describe(reader, document);
  if (!reader.Ok()) return std::unexpected(*reader.Fault());
  if (!reader.AtEnd()) return Fail(ErrorCode::kTrailing, "", "has more fields than this version knows");
  if (auto references = CheckReferences(document); !references) return std::unexpected(references.error());
  // A document has exactly one encoding. Other bytes that decode to the same values did not come from an
  // encoder.
  const auto again = EncodeBinary(document);
  if (again.size() != bytes.size() || !std::equal(again.begin(), again.end(), bytes.begin())) {
    return Fail(ErrorCode::kSyntax, "", "is not in its canonical encoding");
  }
  return document;
}

}  // namespace gaitsmith
