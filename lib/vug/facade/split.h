// Splits: how a rectangle is given to parts.
#pragma once

#include <vug/base/kind.h>
#include <vug/facade/free_numbers.h>
#include <vug/facade/rect.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vug::facade {

/// Numbers that a model has beside its symbols, in order: {"columns", 3}. Lengths are metres.
using Numbers = std::vector<std::pair<std::string, double>>;

/// A place that a split gives to one of its parts.
struct Cell {
  int part = 0;  ///< Which of the split's parts, from 0.
  Rect rect;     ///< In the frame of the scope: (0, 0) is its lower left corner.
  /// Where it is stamped again; the part is derived once for all of them.
  std::vector<Placement> copies = {};
  Numbers given = {};  ///< What the model stores of the place itself, such as a row's height.
  double depth = 0;    ///< How far its plane lies before that of the scope; below 0: behind.
  int64_t index = 0;   ///< Which of `total` places of one part, from 0.
  int64_t total = 1;
  /// Which of its part's places it is as columns and rows count, from 0; it stays the same when
  /// counts change. What is stamped again has both 0.
  int column = 0, row = 0;
  bool mirrored = false;  ///< What stands there is turned about its upright middle.
};

struct Layout {
  std::vector<Cell> cells;
  Numbers numbers = {};  ///< What the model stores of the split, such as counts of a grid.
};

/// A way to divide. Shared and immutable.
class Split {
 public:
  virtual ~Split() = default;
  /// The places in a scope of that size in metres; `free` answers for what the text leaves open.
  /// Error(bad_input) where the sizes do not fit.
  virtual Layout layout(double width, double height, FreeNumbers& free) const = 0;
};
using SplitPtr = std::shared_ptr<const Split>;

/// A part as an argument of a split: which one, and its name for messages.
struct PartRef {
  int part = 0;
  std::string name;
};

/// A length, a share of the whole in per cent or, as a plain number, of what is left. As numbers of
/// a scene measure one thing where a schema takes them, sizes go to schemas as objects.
struct Size {
  Number number;
};
/// The value with each number in it as a Size.
Value as_sizes(const Value& value);

/// A size or a part: what sequences like `4m, Base, 1, Upper` are made of.
struct SizeOrPart {
  bool is_part = false;
  Number size;
  PartRef part;
};

using SplitKind = Kind<SplitPtr>;
/// ParametricSplit from the list in CMakeLists.txt.
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

/// Opens the one definition that the file of a split exports; see VUG_EXPORT_KIND.
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
