// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_light.h>

#include <algorithm>

namespace vug::exchange {
namespace {

constexpr double kDegrees = 180 / kPi;

const char* type_of(Light::Shape shape) {
  switch (shape) {
    case Light::Shape::rectangle:
      return "RectLight";
    case Light::Shape::disk:
      return "DiskLight";
    case Light::Shape::sun:
      return "DistantLight";
    case Light::Shape::dome:
      return "DomeLight";
    default:
      return "SphereLight";
  }
}

}  // namespace

void write_usd_camera(UsdText& out, const Camera& camera, const std::string& name,
                      double metres_per_unit) {
  // USD measures lenses and film in tenths of the unit.
  const double millimetre = 0.01 / metres_per_unit;
  const double width = camera.orthographic ? 10 * camera.span : kFilmWidth * millimetre;
  const double focal = focal_length(camera) * millimetre;
  out.def("Camera", name);
  out.line("token projection = \"{}\"", camera.orthographic ? "orthographic" : "perspective");
  out.line("float horizontalAperture = {}", width);
  out.line("float verticalAperture = {}", width / camera.aspect);
  if (!camera.orthographic) out.line("float focalLength = {}", focal);
  out.line("float focusDistance = {}", camera.focus);
  out.line("float fStop = {}", camera.aperture > 0 ? 0.1 * focal / camera.aperture : 0);
  out.line("float2 clippingRange = ({}, {})", camera.near, camera.far);
  out.place(camera.place).end();
}

void write_usd_light(UsdText& out, const Light& light, const std::string& name,
                     const std::string& picture) {
  using Shape = Light::Shape;
  const bool shaped = light.shape == Shape::spot || !light.profile.empty();
  std::vector<std::string> metadata;
  if (shaped) metadata.emplace_back("prepend apiSchemas = [\"ShapingAPI\"]");
  out.def(type_of(light.shape), name, metadata);
  const Vec3d emitted = light.shape == Shape::sun ? peak_intensity(light) : light.radiance;
  const double most = std::max({emitted.x, emitted.y, emitted.z});
  out.line("color3f inputs:color = {}", usd_tuple(most > 0 ? emitted / most : Vec3d(1.0)));
  out.line("float inputs:intensity = {}", most);
  out.line("bool inputs:normalize = {}", light.shape == Shape::sun ? 1 : 0);
  if (light.shape == Shape::rectangle) {
    out.line("float inputs:width = {}", light.width);
    out.line("float inputs:height = {}", light.height);
  } else if (light.shape == Shape::sun) {
    out.line("float inputs:angle = {}", light.angle * kDegrees);
  } else if (light.shape != Shape::dome) {
    out.line("float inputs:radius = {}", light.radius);
  }
  if (light.shape == Shape::spot) {
    out.line("float inputs:shaping:cone:angle = {}", 0.5 * light.angle * kDegrees);
    out.line("float inputs:shaping:cone:softness = {}", light.edge);
  }
  if (!light.profile.empty()) {
    out.line("asset inputs:shaping:ies:file = @{}@", light.profile.generic_string());
    out.line("bool inputs:shaping:ies:normalize = 1");
  }
  if (!picture.empty()) {
    out.line("asset inputs:texture:file = @{}@", picture);
    out.line("token inputs:texture:format = \"latlong\"");
  }
  // USD's environment maps have their middle column at +z.
  out.place(light.shape == Shape::dome ? light.place * Transform::rotation({0, 1, 0}, kPi)
                                       : light.place);
  out.end();
}

}  // namespace vug::exchange
