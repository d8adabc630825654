// SPDX-License-Identifier: Apache-2.0
// Includes and macro for the source file of a kind: the schema, and the export of its factory.
#pragma once

#include <vug/render/kinds.h>

/// Exports a kind from its file: the factory constructs OBJECT from PARAMS, which has `static void
/// describe(Schema<PARAMS>&)`. The constructor may throw Error; see make_kind in base/kind.h.
///   VUG_RENDER_KIND(rect, light, LightPtr, RectParams, RectLight)
#define VUG_RENDER_KIND(name, category, Pointer, Params, Object)                                 \
  namespace vug::render {                                                                        \
  const Kind<Pointer>& name##_##category() {                                                     \
    static const auto kind = make_kind<Pointer, Params>(                                         \
        #name, #category,                                                                        \
        [](const Params& params) -> Pointer { return std::make_shared<const Object>(params); }); \
    return kind;                                                                                 \
  }                                                                                              \
  }

namespace vug::render {

inline Vec3f to_float(const Vec3d& v) { return Vec3f(v); }

}  // namespace vug::render
