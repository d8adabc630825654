// What the file of a kind needs: the schema, and the macro that exports its maker.
#pragma once

#include <vug/render/kinds.h>

/// Exports a kind from its file. PARAMS has `static void describe(Schema<PARAMS>&)` and may have
/// `std::string fault() const` (empty, or a sentence on parameters that do not fit together);
/// OBJECT is made from PARAMS and may throw Error, which becomes a diagnostic.
///   VUG_RENDER_KIND(rect, light, LightPtr, RectParams, RectLight)
#define VUG_RENDER_KIND(name, category, Pointer, Params, Object)                           \
  const vug::Kind<vug::render::Pointer>& vug::render::name##_##category() {                \
    static const auto kind = detail::make_kind<Pointer, Params, Object>(#name, #category); \
    return kind;                                                                           \
  }

namespace vug::render {

#define VUG_KIND(name) const Kind<CameraPtr>& name##_camera();
#include <vug/render/cameras_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<SamplerPtr>& name##_sampler();
#include <vug/render/samplers_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<BsdfPtr>& name##_bsdf();
#include <vug/render/bsdfs_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<LightPtr>& name##_light();
#include <vug/render/lights_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<MediumPtr>& name##_medium();
#include <vug/render/media_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<IntegratorPtr>& name##_integrator();
#include <vug/render/integrators_kinds.inc>
#undef VUG_KIND

inline Vec3f to_float(const Vec3d& v) { return Vec3f(v); }

namespace detail {

template <class Pointer, class Params, class Object>
Kind<Pointer> make_kind(std::string name, std::string category) {
  Schema<Params> schema;
  schema.info().name = std::move(name);
  schema.info().category = std::move(category);
  Params::describe(schema);
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema)](const Arguments& arguments, SourceLocation where,
                                       Diagnostics& diagnostics) -> std::optional<Pointer> {
            Diagnostics own;
            const Params params = schema.bind(arguments, where, own);
            std::string fault;
            if constexpr (requires { params.fault(); })
              if (!own.has_errors()) fault = params.fault();
            if (!fault.empty()) own.error(where, fault);
            if (!own.has_errors()) {
              try {
                return Pointer(std::make_shared<const Object>(params));
              } catch (const Error& error) {
                own.error(where, error.what(), error.hint());
              }
            }
            diagnostics.append(own);
            return std::nullopt;
          }};
}

}  // namespace detail
}  // namespace vug::render
