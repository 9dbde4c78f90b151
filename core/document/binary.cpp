// SPDX-License-Identifier: MIT
#include "core/document/binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

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

class BinaryWriter : public Archive {
 public:
  /// @param version fields of later versions are left out
  explicit BinaryWriter(int version) : version_(version) {}
  /// The oldest version that can hold every written field with a non-standard value.
  [[nodiscard]] int Needed() const { return needed_; }

  void Real(std::string_view, float& value, float, float, float standard) {
    if (Standard(value == standard)) return;
    bits_.Put(std::bit_cast<std::uint32_t>(value), 32);
  }
  void Integer(std::string_view, int& value, int low, int high, int standard) {
    if (Standard(value == standard)) return;
    bits_.Put(static_cast<std::uint64_t>(std::int64_t{value} - low), IntegerBits(low, high));
  }
  void Model(std::string_view, int& model) { bits_.Put(static_cast<std::uint64_t>(model), kModelBits); }
  void Natural(std::string_view, std::uint32_t& value, std::uint32_t standard) {
    if (Standard(value == standard)) return;
    bits_.Put(value, 32);
  }
  void Flag(std::string_view, bool& value, bool standard) { Standard(value == standard, value); }
  template <class Fields>
  void Since(int version, Fields fields) {
    if (version > version_) return;
    const int outside = since_;
    since_ = version;
    fields();
    since_ = outside;
  }
  template <class Enum, class Names>
  void Choice(std::string_view, Enum& value, const Names& names, Enum standard) {
    static_assert(std::tuple_size_v<Names> <= LongestTable(kChoiceBits));
    static_cast<void>(names);
    if (!Standard(value == standard)) bits_.PutIndex(static_cast<std::size_t>(value), kChoiceBits);
  }
  void Text(std::string_view, std::string& text) {
    bits_.Put(text.size(), 7);
    for (const char c : text) bits_.Put(static_cast<unsigned char>(c), 8);
  }
  template <class Fields>
  void Group(std::string_view, Fields fields) {
    fields();
  }
  template <class Item, class Fields>
  void List(std::string_view, std::vector<Item>& list, int most, Fields fields) {
    if (Standard(list.empty())) return;
    bits_.Put(list.size(), BitsFor(static_cast<std::uint64_t>(most) + 1));
    for (Item& item : list) fields(item);
  }
  void Hash(std::string_view, std::optional<std::uint64_t>& hash) {
    if (!Standard(!hash)) bits_.Put(*hash, 64);
  }
  void Genes(Controller& controller, const PortCount& ports) {
    bits_.Put(static_cast<std::uint64_t>(controller.rules - 1), BitsFor(kMaxRules));
    if (controller.kind == ControllerKind::kNetwork) {
      for (const Gene gene : controller.genes) bits_.Put(gene, 16);
      return;
    }
    const BankShape shape(controller.rules, controller.senses.kind, ports);
    for (int rule = 0; rule < shape.rules; ++rule) {
      for (int sense = 0; sense < shape.senses; ++sense) {
        if (Standard(!shape.Cares(controller.genes, rule, sense))) continue;
        bits_.Put(controller.genes[shape.Low(rule, sense)], 16);
        bits_.Put(controller.genes[shape.High(rule, sense)], 16);
      }
      for (int joint = 0; joint < shape.joints; ++joint)
        bits_.Put(controller.genes[shape.Target(rule, joint)], 16);
      bits_.Put(controller.genes[shape.Tau(rule)], 16);
    }
  }
  [[nodiscard]] const std::vector<std::uint8_t>& Body() const { return bits_.Bytes(); }

 private:
  static int IntegerBits(int low, int high) {
    return BitsFor(static_cast<std::uint64_t>(std::int64_t{high} - low) + 1);
  }
  bool Standard(bool is_standard) { return Standard(is_standard, !is_standard); }
  bool Standard(bool is_standard, bool bit) {
    bits_.Put(bit ? 1 : 0, 1);
    if (!is_standard) needed_ = std::max(needed_, since_);
    return is_standard;
  }
  BitWriter bits_;
  int version_;
  int since_ = 1;  // version that added the present field
  int needed_ = 1;
};

class BinaryReader : public Archive {
 public:
  BinaryReader(std::span<const std::uint8_t> body, int version) : bits_(body), version_(version) {}

  void Real(std::string_view name, float& value, float low, float high, float standard) {
    value = standard;
    if (!Given(name)) return;
    value = std::bit_cast<float>(static_cast<std::uint32_t>(bits_.Take(32)));
    CheckReal(name, value, low, high);
  }
  void Integer(std::string_view name, int& value, int low, int high, int standard) {
    value = standard;
    if (!Given(name)) return;
    const auto above = bits_.Take(BitsFor(static_cast<std::uint64_t>(std::int64_t{high} - low) + 1));
    const std::int64_t wide = low + static_cast<std::int64_t>(above);
    CheckInteger(name, wide, low, high);
    if (Ok()) value = static_cast<int>(wide);
  }
  void Model(std::string_view name, int& model) {
    model = static_cast<int>(bits_.Take(kModelBits));
    CheckLeft(name);
    CheckModel(name, model);
  }
  void Natural(std::string_view name, std::uint32_t& value, std::uint32_t standard) {
    value = Given(name) ? static_cast<std::uint32_t>(bits_.Take(32)) : standard;
  }
  void Flag(std::string_view name, bool& value, bool) { value = Given(name); }
  template <class Enum, class Names>
  void Choice(std::string_view name, Enum& value, const Names& names, Enum standard) {
    value = standard;
    if (!Given(name)) return;
    const auto index = static_cast<std::int64_t>(bits_.TakeIndex(kChoiceBits));
    CheckInteger(name, index, 0, static_cast<std::int64_t>(names.size()) - 1);
    CheckLeft(name);
    if (Ok()) value = static_cast<Enum>(index);
  }
  void Text(std::string_view name, std::string& text) {
    const auto size = static_cast<std::size_t>(bits_.Take(7));
    text.clear();
    for (std::size_t i = 0; i < size; ++i) text.push_back(static_cast<char>(bits_.Take(8)));
    CheckLeft(name);
    CheckText(name, text);
  }
  template <class Fields>
  void Group(std::string_view name, Fields fields) {
    if (!Ok()) return;
    Enter(name);
    fields();
    Leave();
  }
  template <class Item, class Fields>
  void List(std::string_view name, std::vector<Item>& list, int most, Fields fields) {
    list.clear();
    if (!Given(name)) return;
    const auto count = static_cast<std::size_t>(bits_.Take(BitsFor(static_cast<std::uint64_t>(most) + 1)));
    CheckCount(name, count, static_cast<std::size_t>(most));
    CheckLeft(name);
    Enter(name);
    for (std::size_t i = 0; i < count && Ok(); ++i) {
      EnterElement(i);
      fields(list.emplace_back());
      Leave();
    }
    Leave();
  }
  void Hash(std::string_view name, std::optional<std::uint64_t>& hash) {
    hash.reset();
    if (Given(name)) hash = bits_.Take(64);
    CheckLeft(name);
  }
  void Genes(Controller& controller, const PortCount& ports) {
    controller.rules = static_cast<int>(bits_.Take(BitsFor(kMaxRules))) + 1;
    if (!Ok() || ports.actuators < 0) return FailAt("rules", ErrorCode::kStructure, "the figure has no rods");
    const BankShape shape(controller.rules, controller.senses.kind, ports);
    controller.genes.assign(controller.Shape(ports).Genes(), 0);
    if (controller.kind == ControllerKind::kNetwork) {
      for (Gene& gene : controller.genes) gene = static_cast<Gene>(bits_.Take(16));
      return CheckLeft("nodes");
    }
    for (int rule = 0; rule < shape.rules; ++rule) {
      for (int sense = 0; sense < shape.senses; ++sense) {
        Gene& low = controller.genes[shape.Low(rule, sense)];
        Gene& high = controller.genes[shape.High(rule, sense)];
        const bool cares = bits_.Take(1) != 0;
        low = cares ? static_cast<Gene>(bits_.Take(16)) : Gene{0};
        high = cares ? static_cast<Gene>(bits_.Take(16)) : kGeneMax;
        if (low > high) return FailAt("rules", ErrorCode::kOutOfRange, "an interval ends before it begins");
      }
      for (int joint = 0; joint < shape.joints; ++joint) {
        controller.genes[shape.Target(rule, joint)] = static_cast<Gene>(bits_.Take(16));
      }
      controller.genes[shape.Tau(rule)] = static_cast<Gene>(bits_.Take(16));
    }
    CheckLeft("rules");
  }
  /// An older version does not have these fields, so they keep their standard values.
  template <class Fields>
  void Since(int version, Fields fields) {
    if (version <= version_) fields();
  }
  [[nodiscard]] bool AtEnd() { return bits_.AtEnd(); }

 private:
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

void PutLittleEndian(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

std::uint32_t TakeLittleEndian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

}  // namespace

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
  BinaryWriter writer(kBinaryVersion);
  Describe(writer, copy);
  if (const int needed = writer.Needed(); needed < kBinaryVersion) {
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
  if (bytes[0] < 1 || bytes[0] > kBinaryVersion) {
    return Fail(ErrorCode::kUnknownVersion, "",
                "has format version " + std::to_string(bytes[0]) + ", this Gaitsmith reads versions up to " +
                    std::to_string(kBinaryVersion) + "; it was made by a newer one, or the data is damaged");
  }
  const std::size_t whole =
      bytes.size() < kHeaderBytes ? 0 : TakeLittleEndian(bytes.subspan(1, 3)) + kHeaderBytes + kChecksumBytes;
  if (whole == 0 || bytes.size() < whole) {
    return Fail(ErrorCode::kTruncated, "",
                "was cut: " + std::to_string(bytes.size()) + " bytes arrived of " +
                    (whole == 0 ? "more" : std::to_string(whole)));
  }
  if (bytes.size() > whole) {
    return Fail(ErrorCode::kTrailing, "",
                "goes on after its end: " + std::to_string(bytes.size()) + " bytes arrived of " +
                    std::to_string(whole));
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
