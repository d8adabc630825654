// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/surface_aov.h>
#include <vug/render/kinds.h>

namespace vug::render {
#define VUG_KIND(name) const Kind<CameraPtr>& name##_camera();
#include <vug/render/cameras_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<SamplerPtr>& name##_sampler();
#include <vug/render/samplers_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const Kind<MaterialPtr>& name##_material();
#include <vug/render/materials_kinds.inc>
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
#define VUG_KIND(name) SurfaceAov name##_aov();
#include <vug/render/surface_aovs_kinds.inc>
#undef VUG_KIND

#define VUG_KIND(name) &name##_camera(),
const Kinds<CameraPtr>& cameras() {
  static const Kinds<CameraPtr> all = {
#include <vug/render/cameras_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_sampler(),
const Kinds<SamplerPtr>& samplers() {
  static const Kinds<SamplerPtr> all = {
#include <vug/render/samplers_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_material(),
const Kinds<MaterialPtr>& materials() {
  static const Kinds<MaterialPtr> all = {
#include <vug/render/materials_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_light(),
const Kinds<LightPtr>& lights() {
  static const Kinds<LightPtr> all = {
#include <vug/render/lights_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_medium(),
const Kinds<MediumPtr>& media() {
  static const Kinds<MediumPtr> all = {
#include <vug/render/media_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) &name##_integrator(),
const Kinds<IntegratorPtr>& integrators() {
  static const Kinds<IntegratorPtr> all = {
#include <vug/render/integrators_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

#define VUG_KIND(name) name##_aov(),
const std::vector<SurfaceAov>& surface_aovs() {
  static const std::vector<SurfaceAov> all = {
#include <vug/render/surface_aovs_kinds.inc>
  };
  return all;
}
#undef VUG_KIND

CameraPtr make_camera(const std::string& kind, const NamedValues& parameters) {
  return make_product(cameras(), kind, parameters);
}
SamplerPtr make_sampler(const std::string& kind, const NamedValues& parameters) {
  return make_product(samplers(), kind, parameters);
}
MaterialPtr make_material(const std::string& kind, const NamedValues& parameters) {
  return make_product(materials(), kind, parameters);
}
LightPtr make_light(const std::string& kind, const NamedValues& parameters) {
  return make_product(lights(), kind, parameters);
}
MediumPtr make_medium(const std::string& kind, const NamedValues& parameters) {
  return make_product(media(), kind, parameters);
}
IntegratorPtr make_integrator(const std::string& kind, const NamedValues& parameters) {
  return make_product(integrators(), kind, parameters);
}

}  // namespace vug::render
