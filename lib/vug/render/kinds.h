// The catalogue: every kind of camera, sampler, material, light, medium and integrator with its
// schema. The lists stand in this module's CMakeLists.txt.
#pragma once

#include <vug/base/schema.h>
#include <vug/render/bsdf.h>
#include <vug/render/camera.h>
#include <vug/render/integrator.h>
#include <vug/render/light.h>
#include <vug/render/medium.h>
#include <vug/render/sampler.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::render {

const std::vector<const Kind<CameraPtr>*>& cameras();
const std::vector<const Kind<SamplerPtr>*>& samplers();
const std::vector<const Kind<BsdfPtr>*>& bsdfs();
const std::vector<const Kind<LightPtr>*>& lights();
const std::vector<const Kind<MediumPtr>*>& media();
const std::vector<const Kind<IntegratorPtr>*>& integrators();

/// Parameters by name, for callers in C++.
using Named = std::vector<std::pair<std::string, Value>>;
/// An angle as a parameter's value.
inline Value radians(double angle) { return Number{angle, Dimension::angle}; }

/// One product of a kind from named parameters; Error(bad_input) with the first diagnostic when
/// the kind is unknown or a parameter does not fit.
CameraPtr make_camera(const std::string& kind, const Named& parameters = {});
SamplerPtr make_sampler(const std::string& kind, const Named& parameters = {});
BsdfPtr make_bsdf(const std::string& kind, const Named& parameters = {});
LightPtr make_light(const std::string& kind, const Named& parameters = {});
MediumPtr make_medium(const std::string& kind, const Named& parameters = {});
IntegratorPtr make_integrator(const std::string& kind, const Named& parameters = {});

}  // namespace vug::render
