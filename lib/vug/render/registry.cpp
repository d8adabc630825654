// SPDX-License-Identifier: Apache-2.0
// Creation of cameras, samplers, materials, lights, media and integrators by name.
#include <vug/render/kinds.h>

namespace vug::render {

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
