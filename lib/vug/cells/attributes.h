// SPDX-License-Identifier: Apache-2.0
// The attributes of cells: named columns of numbers, vectors or integers, with one value per cell.
#pragma once

#include <vug/base/error.h>
#include <vug/base/vec.h>

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vug::cells {

/// Attribute of meshes and masks that is 1 in cells removed from the surface
/// (CellState::transparent), otherwise 0.
inline constexpr std::string_view kTransparent = "transparent";

/// How a cell participates. Only receiving and active cells are updated; only distributing and
/// active cells are visible to their neighbours. Transparent cells are inactive and removed from
/// the surface, for example by corrosion.
enum class CellState : uint8_t { sleeping, receiving, distributing, active, transparent };

constexpr bool receives(CellState s) { return s == CellState::receiving || s == CellState::active; }
constexpr bool distributes(CellState s) {
  return s == CellState::distributing || s == CellState::active;
}
std::string_view name_of(CellState state);

/// A double buffer: the current values, and the values that a rule writes while it reads the
/// current ones. `next` is empty until a rule writes the column. From then on, between two rules,
/// it equals `now` for every cell that no rule will write before it is read.
template <class T>
struct Column {
  std::vector<T> now;
  std::vector<T> next;
};

/// A name with values of one of the types.
struct Attribute {
  std::string name;
  std::variant<Column<float>, Column<Vec3f>, Column<int32_t>> column;

  /// "number", "vector", "whole number".
  std::string_view type() const;
};

/// The attributes of one network's cells. References to columns remain valid when others are added.
class Attributes {
 public:
  explicit Attributes(size_t cells) : cells_(cells) {}

  size_t cells() const { return cells_; }
  /// In the order of their addition.
  const std::deque<Attribute>& all() const { return all_; }
  std::deque<Attribute>& all() { return all_; }
  const Attribute* find(std::string_view name) const;
  /// Like `find`, but throws Error(bad_input), listing the existing attributes, for an unknown
  /// name.
  const Attribute& need(const std::string& name) const;

  /// The column of this name; a new one starts with `initial` in every cell. Throws
  /// Error(bad_input) if a column of another type exists.
  template <class T>
  Column<T>& column(const std::string& name, const T& initial = T(0)) {
    if (const Attribute* known = find(name)) {
      auto* same = std::get_if<Column<T>>(&const_cast<Attribute*>(known)->column);
      if (!same) refuse_type(*known, Attribute{{}, Column<T>{}}.type());
      return *same;
    }
    all_.push_back({name, Column<T>{std::vector<T>(cells_, initial), {}}});
    return std::get<Column<T>>(all_.back().column);
  }
  /// The values of an existing column; throws Error(bad_input), listing the existing ones, for
  /// others.
  template <class T>
  const std::vector<T>& values(const std::string& name) const {
    const Attribute& known = need(name);
    const auto* same = std::get_if<Column<T>>(&known.column);
    if (!same) refuse_type(known, Attribute{{}, Column<T>{}}.type());
    return same->now;
  }

 private:
  [[noreturn]] static void refuse_type(const Attribute& known, std::string_view wanted);

  size_t cells_;
  std::deque<Attribute> all_;
};

}  // namespace vug::cells
