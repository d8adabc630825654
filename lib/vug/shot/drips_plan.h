// SPDX-License-Identifier: Apache-2.0
// The drips of a cave and what grows from them, computed on first use.
#pragma once

#include <vug/base/kind.h>
#include <vug/field/grown_material.h>
#include <vug/shot/drip_params.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace vug::shot {

/// Keeps what plans of drips have computed, e.g. in a store. Any thread may call its functions.
class DripsCache {
 public:
  virtual ~DripsCache() = default;
  /// The known graph of these inputs, else `make()`.
  virtual drips::Graph graph(const Digest& inputs, const std::function<drips::Graph()>& make) = 0;
  /// The same for what has grown.
  virtual drips::GrownForms forms(const Digest& inputs,
                                  const std::function<drips::GrownForms()>& make) = 0;
};

/// Immutable, but for the place where it looks its results up. Throws the errors of
/// drips::build_graph.
class DripsPlan {
 public:
  /// Throws Error(bad_input) for edits that are invalid.
  explicit DripsPlan(const DripParams& params);

  const field::Field& rock() const { return rock_; }
  const drips::DripstoneOptions& options() const { return options_; }
  /// Identifies the rock and the options.
  Digest digest() const { return digest_of(rock_, options_); }
  const drips::Graph& graph() const;
  const drips::Dripstone& grown() const;
  /// Results that are computed from now on are taken from the cache or added to it. They are the
  /// same without it.
  void keep_in(std::shared_ptr<DripsCache> cache) const;

 private:
  const drips::Graph& whole_graph() const;  ///< With `computing_` locked.
  drips::GrownForms grow() const;           ///< The same.

  field::Field rock_;
  drips::DripstoneOptions options_;
  mutable std::mutex computing_;
  mutable std::optional<drips::Graph> graph_;
  mutable std::optional<drips::Dripstone> grown_;
  mutable std::shared_ptr<DripsCache> cache_;
};

using DripsPtr = std::shared_ptr<const DripsPlan>;

/// How speleothems join the rock.
struct SpeleothemJoin {
  double root = 0.3;  ///< Distance over which roots blend into it, metres.
  field::RockMaterialPtr
      material{};  ///< The material of all that has grown; null: that of the rock.

  template <class P>
  static void describe(Schema<P>& s) {
    s.param("root", &SpeleothemJoin::root,
            positive_length("distance over which roots blend into the rock"));
    field::describe_growth_material(s);
  }
};

/// Solids are all speleothems except flowstone, which is a part of the rock.
enum class SpeleothemPart { all, solids, rock };

/// The rock of the plan with its speleothems, or one part of it; computed on first use. Throws
/// Error(bad_input) if they have a material and the rock has none.
field::Field with_speleothems(const DripsPtr& drips, const SpeleothemJoin& join,
                              SpeleothemPart part = SpeleothemPart::all);

/// The kinds listed in CMakeLists.txt.
const Kinds<DripsPtr>& drips_kinds();
using DripsKind = Kind<DripsPtr>;

/// Begins the definition of the function that the source of such a kind exports.
#define VUG_DRIPS_KIND(name) VUG_EXPORT_KIND(vug::shot, DripsKind, name##_drips)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::DripsPtr> : ObjectTraits<shot::DripsPtr> {
  static constexpr const char* kWord = "drips";
};

}  // namespace vug
