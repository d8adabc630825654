#include <vug/render/kind.h>

namespace vug::render {
namespace {

template <class Product>
Product make(const std::vector<const Kind<Product>*>& kinds, const std::string& name,
             const Named& parameters) {
  const auto* kind = find_kind(kinds, name);
  if (!kind) {
    std::vector<std::string> known;
    for (const auto* k : kinds) known.push_back(k->info.name);
    throw Error(ErrorCode::bad_input, "there is no kind '" + name + "'", {},
                suggestion(name, known));
  }
  Arguments arguments;
  for (const auto& [key, value] : parameters) arguments.push_back({key, value, {}});
  Diagnostics diagnostics;
  auto product = kind->make(arguments, {}, diagnostics);
  if (diagnostics.has_errors() || !product) {
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity == Severity::error)
        throw Error(ErrorCode::bad_input, d.message, d.where, d.hint);
    throw Error(ErrorCode::internal, "kind '" + name + "' made nothing");
  }
  return *product;
}

}  // namespace

#define VUG_KIND(name) &name##_camera(),
const std::vector<const Kind<CameraPtr>*>& cameras() {
  static const std::vector<const Kind<CameraPtr>*> all = {
#include <vug/render/cameras_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_sampler(),
const std::vector<const Kind<SamplerPtr>*>& samplers() {
  static const std::vector<const Kind<SamplerPtr>*> all = {
#include <vug/render/samplers_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_bsdf(),
const std::vector<const Kind<BsdfPtr>*>& bsdfs() {
  static const std::vector<const Kind<BsdfPtr>*> all = {
#include <vug/render/bsdfs_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_light(),
const std::vector<const Kind<LightPtr>*>& lights() {
  static const std::vector<const Kind<LightPtr>*> all = {
#include <vug/render/lights_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_medium(),
const std::vector<const Kind<MediumPtr>*>& media() {
  static const std::vector<const Kind<MediumPtr>*> all = {
#include <vug/render/media_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_integrator(),
const std::vector<const Kind<IntegratorPtr>*>& integrators() {
  static const std::vector<const Kind<IntegratorPtr>*> all = {
#include <vug/render/integrators_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

CameraPtr make_camera(const std::string& kind, const Named& parameters) {
  return make(cameras(), kind, parameters);
}
SamplerPtr make_sampler(const std::string& kind, const Named& parameters) {
  return make(samplers(), kind, parameters);
}
BsdfPtr make_bsdf(const std::string& kind, const Named& parameters) {
  return make(bsdfs(), kind, parameters);
}
LightPtr make_light(const std::string& kind, const Named& parameters) {
  return make(lights(), kind, parameters);
}
MediumPtr make_medium(const std::string& kind, const Named& parameters) {
  return make(media(), kind, parameters);
}
IntegratorPtr make_integrator(const std::string& kind, const Named& parameters) {
  return make(integrators(), kind, parameters);
}

}  // namespace vug::render
