// SPDX-License-Identifier: Apache-2.0
// The drips of a cave and what grows from them, computed on first use.
#pragma once

#include <vug/base/kind.h>
#include <vug/shot/drip_params.h>

#include <memory>
#include <mutex>
#include <optional>

namespace vug::shot {

/// Immutable. Throws the errors of drips::build_graph.
class DripsPlan {
 public:
  /// Throws Error(bad_input) for edits that are invalid.
  explicit DripsPlan(const DripParams& params);

  const field::Field& rock() const { return rock_; }
  const drips::DripstoneOptions& options() const { return options_; }
  const drips::Graph& graph() const;
  const drips::Dripstone& grown() const;

 private:
  field::Field rock_;
  drips::DripstoneOptions options_;
  mutable std::mutex computing_;
  mutable std::optional<drips::Graph> graph_;
  mutable std::optional<drips::Dripstone> grown_;
};

using DripsPtr = std::shared_ptr<const DripsPlan>;

/// The rock of the plan with its speleothems, whose roots blend into it over a distance in metres.
/// They are computed on first use.
field::Field with_speleothems(const DripsPtr& drips, double root);

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
