// SPDX-License-Identifier: Apache-2.0
// Catalogue of all kinds of cameras, samplers, materials, lights, media and integrators with their
// schemas. The lists are in this module's CMakeLists.txt.
#pragma once

#include <vug/base/kind.h>
#include <vug/render/camera.h>
#include <vug/render/integrator.h>
#include <vug/render/light.h>
#include <vug/render/material.h>
#include <vug/render/media/medium.h>
#include <vug/render/sampler.h>

#include <string>

namespace vug::render {

const Kinds<CameraPtr>& cameras();
const Kinds<SamplerPtr>& samplers();
const Kinds<MaterialPtr>& materials();
const Kinds<LightPtr>& lights();
const Kinds<MediumPtr>& media();
const Kinds<IntegratorPtr>& integrators();

/// An angle as a parameter's value.
inline Value radians(double angle) { return Number{angle, Dimension::angle}; }

/// Creates an object of a kind from named parameters; see make_product.
CameraPtr make_camera(const std::string& kind, const NamedValues& parameters = {});
SamplerPtr make_sampler(const std::string& kind, const NamedValues& parameters = {});
MaterialPtr make_material(const std::string& kind, const NamedValues& parameters = {});
LightPtr make_light(const std::string& kind, const NamedValues& parameters = {});
MediumPtr make_medium(const std::string& kind, const NamedValues& parameters = {});
IntegratorPtr make_integrator(const std::string& kind, const NamedValues& parameters = {});

}  // namespace vug::render

namespace vug {

template <>
struct ValueTraits<render::CameraPtr> : ObjectTraits<render::CameraPtr> {
  static constexpr const char* kWord = "camera";
};
template <>
struct ValueTraits<render::SamplerPtr> : ObjectTraits<render::SamplerPtr> {
  static constexpr const char* kWord = "sampler";
};
template <>
struct ValueTraits<render::MaterialPtr> : ObjectTraits<render::MaterialPtr> {
  static constexpr const char* kWord = "material";
};
template <>
struct ValueTraits<render::LightPtr> : ObjectTraits<render::LightPtr> {
  static constexpr const char* kWord = "light";
};
template <>
struct ValueTraits<render::MediumPtr> : ObjectTraits<render::MediumPtr> {
  static constexpr const char* kWord = "medium";
};
template <>
struct ValueTraits<render::IntegratorPtr> : ObjectTraits<render::IntegratorPtr> {
  static constexpr const char* kWord = "integrator";
};

}  // namespace vug
