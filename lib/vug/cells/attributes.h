// What cells carry: named columns of numbers, vectors or whole numbers, one value a cell.
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

/// What meshes and masks call 1 in cells that are gone from the surface (CellState::transparent),
/// else 0.
inline constexpr std::string_view kTransparent = "transparent";

/// How a cell takes part. Only receiving and active cells are rewritten; only distributing and
/// active ones are seen by their neighbours. Transparent cells sleep and are gone from the surface,
/// as when corroded.
enum class CellState : uint8_t { sleeping, receiving, distributing, active, transparent };

constexpr bool receives(CellState s) { return s == CellState::receiving || s == CellState::active; }
constexpr bool distributes(CellState s) {
  return s == CellState::distributing || s == CellState::active;
}
std::string_view name_of(CellState state);

/// Two buffers of one type: what is, and what a rule writes while it reads what is. `next` is empty
/// until a rule writes the column; from then on it equals `now` for every cell between two rules
/// that no rule will write before it is read.
template <class T>
struct Column {
  std::vector<T> now;
  std::vector<T> next;
};

/// A name and values of one of the types.
struct Attribute {
  std::string name;
  std::variant<Column<float>, Column<Vec3f>, Column<int32_t>> column;

  /// "number", "vector", "whole number".
  std::string_view type() const;
};

/// The attributes of one network's cells. References to columns stay good when others are added.
class Attributes {
 public:
  explicit Attributes(size_t cells) : cells_(cells) {}

  size_t cells() const { return cells_; }
  /// In the order in which they were added.
  const std::deque<Attribute>& all() const { return all_; }
  std::deque<Attribute>& all() { return all_; }
  const Attribute* find(std::string_view name) const;
  /// The same; Error(bad_input), with what there is, where it is not.
  const Attribute& need(const std::string& name) const;

  /// The column of that name, added with `initial` in every cell where there is none.
  /// Error(bad_input) where there is one of another type.
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
  /// The values of a column that is there; Error(bad_input), with what there is, for others.
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
