// The kinds of blends: what the `blend` parameter of an operator takes.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/kind.h>

/// Opens the one definition that a file in blends/ exports; see VUG_FIELD_KIND.
#define VUG_BLEND_KIND(name)                               \
  static vug::field::BlendKind make_##name##_kind();       \
  const vug::field::BlendKind& vug::field::name##_kind() { \
    static const BlendKind kind = make_##name##_kind();    \
    return kind;                                           \
  }                                                        \
  static vug::field::BlendKind make_##name##_kind()

namespace vug::field {

using BlendKind = Kind<Blend>;

#define VUG_KIND(name) const BlendKind& name##_kind();
#include <vug/field/blends_kinds.inc>
#undef VUG_KIND

}  // namespace vug::field
