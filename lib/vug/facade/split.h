// SPDX-License-Identifier: Apache-2.0
// Interface of splits, which divide a rectangle into parts.
#pragma once

#include <vug/base/kind.h>
#include <vug/facade/free_numbers.h>
#include <vug/facade/rect.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vug::facade {

/// Ordered named numbers of a model, e.g. {"columns", 3}. Lengths are in metres.
using Numbers = std::vector<std::pair<std::string, double>>;

/// A rectangle that a split assigns to one of its parts.
struct Cell {
  int part = 0;  ///< Index of the split's part.
  Rect rect;     ///< In the frame of the scope: (0, 0) is its lower left corner.
  /// Placements of copies; the part is derived once for all of them.
  std::vector<Placement> copies = {};
  Numbers given = {};  ///< Numbers stored for the cell itself, such as a row's height.
  double depth = 0;    ///< Distance of its plane in front of the scope's, metres; negative: behind.
  int64_t index = 0;   ///< 0-based index among the `total` cells of its part.
  int64_t total = 1;
  /// 0-based column and row among the cells of its part; they do not change when counts change.
  /// Both are 0 for cells with copies.
  int column = 0, row = 0;
  bool mirrored = false;  ///< The content is mirrored about the cell's vertical centre line.
};

struct Layout {
  std::vector<Cell> cells;
  Numbers numbers = {};  ///< Numbers stored for the split, such as counts of a grid.
};

/// A method of subdivision. Shared and immutable.
class Split {
 public:
  virtual ~Split() = default;
  /// The cells in a scope of that size in metres; `free` provides the numbers that the text does
  /// not specify. Throws Error(bad_input) if the sizes do not fit.
  virtual Layout layout(double width, double height, FreeNumbers& free) const = 0;
};
using SplitPtr = std::shared_ptr<const Split>;

/// A part as an argument of a split: its index and its name for messages.
struct PartRef {
  int part = 0;
  std::string name;
};

/// A length, a percentage of the whole or, as a plain number, a proportion of the rest. As a number
/// in a schema has a single dimension, sizes are passed to schemas as objects.
struct Size {
  Number number;
};
/// The value with each number converted to a Size.
Value as_sizes(const Value& value);

/// An element of sequences such as `4m, Base, 1, Upper`.
struct SizeOrPart {
  bool is_part = false;
  Number size;
  PartRef part;
};

using SplitKind = Kind<SplitPtr>;
/// All kinds of splits, from the list in CMakeLists.txt.
const Kinds<SplitPtr>& splits();

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and
/// `Layout layout(double, double, FreeNumbers&) const`.
template <class P>
SplitKind split_kind(const std::string& name) {
  struct ParametricSplit final : Split {
    explicit ParametricSplit(const P& p) : params(p) {}
    Layout layout(double width, double height, FreeNumbers& free) const override {
      return params.layout(width, height, free);
    }
    P params;
  };
  return make_kind<SplitPtr, P>(name, "split", [](const P& params) -> SplitPtr {
    return std::make_shared<const ParametricSplit>(params);
  });
}

}  // namespace vug::facade

/// Opens the only definition that the file of a split exports; see VUG_EXPORT_KIND.
#define VUG_SPLIT_KIND(name) VUG_EXPORT_KIND(vug::facade, SplitKind, name##_split)

namespace vug {

template <>
struct ValueTraits<facade::PartRef> : ObjectTraits<facade::PartRef> {
  static constexpr const char* kWord = "part";
};
template <>
struct ValueTraits<facade::Size> : ObjectTraits<facade::Size> {
  static constexpr const char* kWord = "size";
};
template <>
struct ValueTraits<facade::SizeOrPart> {
  static std::string type() { return "size or part"; }
  static std::optional<facade::SizeOrPart> read(const Value& value) {
    if (const auto* size = value.object<facade::Size>())
      return facade::SizeOrPart{false, size->number, {}};
    const auto* part = value.object<facade::PartRef>();
    return part ? std::optional(facade::SizeOrPart{true, {}, *part}) : std::nullopt;
  }
  static Value write(const facade::SizeOrPart& step) {
    return step.is_part ? ValueTraits<facade::PartRef>::write(step.part)
                        : ValueTraits<facade::Size>::write({step.size});
  }
};

}  // namespace vug
