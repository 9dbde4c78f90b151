// SPDX-License-Identifier: MIT
// What walks a document: one class that reads JSON, another that writes a link, and so on. Describe()
// (schema.h) names every field to it in turn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"

namespace gaitsmith {

/// The most names that a choice may have: a link has this much room for their index (binary.cpp).
inline constexpr std::size_t kMaxChoices = 271;

/// An archive overrides what it looks at and ignores the rest. Every virtual function is defined here,
/// because core is compiled without RTTI and derived classes elsewhere need not be. In JSON a field with its
/// standard value may be left out. In a link it costs one bit.
class Archive {
 public:
  Archive() = default;
  Archive(const Archive&) = default;
  Archive& operator=(const Archive&) = default;
  virtual ~Archive() = default;

  virtual void Real(std::string_view /*name*/, float&, float /*low*/, float /*high*/, float /*standard*/) {}
  virtual void Integer(std::string_view /*name*/, int&, int /*low*/, int /*high*/, int /*standard*/) {}
  virtual void Natural(std::string_view /*name*/, std::uint32_t&, std::uint32_t /*standard*/) {}
  virtual void Flag(std::string_view /*name*/, bool&, bool /*standard*/) {}
  virtual void Text(std::string_view /*name*/, std::string&) {}
  /// The number of the physical model.
  virtual void Model(std::string_view /*name*/, int&) {}
  virtual void Hash(std::string_view /*name*/, std::optional<std::uint64_t>&) {}
  /// The number of a controller's components, and their genes.
  virtual void Genes(Controller&, const PortCount&) {}

  template <class Enum, std::size_t N>
  void Choice(std::string_view name, Enum& value, const std::array<std::string_view, N>& names,
              Enum standard) {
    static_assert(N <= kMaxChoices);
    int index = static_cast<int>(value);
    Index(name, index, names, static_cast<int>(standard));
    value = static_cast<Enum>(index);
  }
  /// Refuses what was read so far, if it cannot go together. For what later fields depend on.
  virtual void Refuse(std::string_view /*name*/, const char* /*why*/) {}
  /// Fields that belong together.
  template <class Fields>
  void Group(std::string_view name, Fields fields) {
    if (!BeginGroup(name)) return;
    fields();
    EndGroup();
  }
  /// Fields that a later version of the binary format added. If all of them have standard values, a link is
  /// written in the older version with exactly the same bytes as before, and JSON leaves them out.
  template <class Fields>
  void Since(int version, Fields fields) {
    if (!BeginSince(version)) return;
    fields();
    EndSince();
  }
  /// @param most items
  template <class Item, class Fields>
  void List(std::string_view name, std::vector<Item>& list, int most, Fields fields) {
    std::size_t size = Reads() ? 0 : list.size();
    if (!BeginList(name, size, most)) return;
    if (Reads()) list.clear();
    if (Ok()) list.resize(size);
    for (std::size_t i = 0; i < size && Ok(); ++i) {
      if (!BeginItem(i)) continue;
      fields(list[i]);
      EndItem();
    }
    EndList();
  }

  [[nodiscard]] bool Ok() const { return !error_; }
  [[nodiscard]] const std::optional<Error>& Fault() const { return error_; }

 protected:
  /// A choice, as an index into its names.
  virtual void Index(std::string_view /*name*/, int& /*index*/, std::span<const std::string_view> /*names*/,
                     int /*standard*/) {}
  // By default, groups, lists and items become part of the path that a fault names. An archive that overrides
  // a beginning without this one overrides the end, too.

  /// False leaves out what is inside, and the end.
  virtual bool BeginGroup(std::string_view name) {
    Enter(name);
    return true;
  }
  virtual void EndGroup() { Leave(); }
  virtual bool BeginSince(int /*version*/) { return true; }
  virtual void EndSince() {}
  /// @param size of the list, 0 for an archive that reads; an archive that reads sets it to the new size
  /// @return false to leave the list as it is
  virtual bool BeginList(std::string_view name, std::size_t& /*size*/, int /*most*/) {
    Enter(name);
    return true;
  }
  virtual bool BeginItem(std::size_t index) {
    EnterElement(index);
    return true;
  }
  virtual void EndItem() { Leave(); }
  virtual void EndList() { Leave(); }
  /// Whether the archive fills the document. Lists are emptied first.
  [[nodiscard]] virtual bool Reads() const { return false; }

  /// Records a fault at a field. Only the first fault is kept.
  void FailAt(std::string_view name, ErrorCode code, std::string what);

  void Enter(std::string_view name);
  void EnterElement(std::size_t index);
  void Leave() { path_.pop_back(); }

  /// Checks of single values, shared by all archives.
  void CheckReal(std::string_view name, float& value, float low, float high);
  void CheckInteger(std::string_view name, std::int64_t value, std::int64_t low, std::int64_t high);
  void CheckModel(std::string_view name, std::int64_t model);
  void CheckText(std::string_view name, const std::string& text);
  void CheckCount(std::string_view name, std::size_t count, std::size_t most);

 private:
  [[nodiscard]] std::string PathOf(std::string_view name) const;

  std::vector<std::string> path_;
  std::optional<Error> error_;
};

/// The shortest text that reads back as the same float.
[[nodiscard]] std::string RealText(float value);

/// Checks everything that concerns more than one field: the figure is a tree, and the controllers of clips
/// and the endpoints of pushes exist.
[[nodiscard]] Result<void> CheckReferences(const Document&);

/// Why a figure cannot have this model; null: it can.
[[nodiscard]] const char* WhyNotModel(int model, const Figure& figure);

}  // namespace gaitsmith
