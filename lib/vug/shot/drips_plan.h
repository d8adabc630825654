// SPDX-License-Identifier: Apache-2.0
// The drips of a cave and what grows from them, computed on first use.
#pragma once

#include <vug/base/kind.h>
#include <vug/drips/forms.h>
#include <vug/shot/drip_params.h>

#include <memory>
#include <mutex>

namespace vug::shot {

/// Immutable. Throws the errors of drips::build_graph.
class DripsPlan {
 public:
  explicit DripsPlan(DripParams params) : params_(std::move(params)) {}

  const DripParams& params() const { return params_; }
  /// The graph with all films and pools.
  const drips::Graph& graph() const;
  /// The speleothems that grow from the graph.
  std::vector<drips::Form> forms() const { return drips::forms_of(graph(), params_.forms()); }

 private:
  const DripParams params_;
  mutable std::mutex computing_;
  mutable std::unique_ptr<const drips::Graph> graph_;
};

using DripsPtr = std::shared_ptr<const DripsPlan>;

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
