// SPDX-License-Identifier: Apache-2.0
// The kinds of blends, which are values of the `blend` parameter of operators.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/kind.h>

/// Opens the one definition exported by a file in blends/; see VUG_FIELD_KIND.
#define VUG_BLEND_KIND(name) VUG_EXPORT_KIND(vug::field, BlendKind, name##_kind)

namespace vug::field {

using BlendKind = Kind<Blend>;

template <class P, class Build>
BlendKind blend_kind(std::string name, Build build) {
  return make_kind<Blend, P>(std::move(name), "blend", std::move(build));
}

}  // namespace vug::field
