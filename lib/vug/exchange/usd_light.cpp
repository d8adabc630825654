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

void write_usd_camera(UsdLayer& out, const Camera& camera, const std::string& name,
                      double metres_per_unit) {
  // USD measures lenses and film in tenths of the unit.
  const double millimetre = 0.01 / metres_per_unit;
  const double width = camera.orthographic ? 10 * camera.span : kFilmWidth * millimetre;
  const double focal = focal_length(camera) * millimetre;
  out.begin_prim("Camera", name);
  out.attribute({"token", "projection"},
                UsdToken{camera.orthographic ? "orthographic" : "perspective"});
  out.attribute({"float", "horizontalAperture"}, width);
  out.attribute({"float", "verticalAperture"}, width / camera.aspect);
  if (!camera.orthographic) out.attribute({"float", "focalLength"}, focal);
  out.attribute({"float", "focusDistance"}, camera.focus);
  out.attribute({"float", "fStop"}, camera.aperture > 0 ? 0.1 * focal / camera.aperture : 0.0);
  out.attribute({"float2", "clippingRange"}, UsdTuple{camera.near, camera.far});
  out.transform(camera.place);
  out.end();
}

void write_usd_light(UsdLayer& out, const Light& light, const std::string& name,
                     const std::string& picture) {
  using Shape = Light::Shape;
  const bool shaped = light.shape == Shape::spot || !light.profile.empty();
  UsdPrimMetadata metadata;
  if (shaped) metadata.push_back(usd_api_schema("ShapingAPI"));
  out.begin_prim(type_of(light.shape), name, metadata);
  const Vec3d emitted = light.shape == Shape::sun ? peak_intensity(light) : light.radiance;
  const double most = std::max({emitted.x, emitted.y, emitted.z});
  const Vec3d color = most > 0 ? emitted / most : Vec3d(1.0);
  out.attribute({"color3f", "inputs:color"}, UsdTuple{color.x, color.y, color.z});
  out.attribute({"float", "inputs:intensity"}, most);
  out.attribute({"bool", "inputs:normalize"}, light.shape == Shape::sun ? 1 : 0);
  if (light.shape == Shape::rectangle) {
    out.attribute({"float", "inputs:width"}, light.width);
    out.attribute({"float", "inputs:height"}, light.height);
  } else if (light.shape == Shape::sun) {
    out.attribute({"float", "inputs:angle"}, light.angle * kDegrees);
  } else if (light.shape != Shape::dome) {
    out.attribute({"float", "inputs:radius"}, light.radius);
  }
  if (light.shape == Shape::spot) {
    out.attribute({"float", "inputs:shaping:cone:angle"}, 0.5 * light.angle * kDegrees);
    out.attribute({"float", "inputs:shaping:cone:softness"}, light.edge);
  }
  if (!light.profile.empty()) {
    out.attribute({"asset", "inputs:shaping:ies:file"}, UsdAsset{light.profile.generic_string()});
    out.attribute({"bool", "inputs:shaping:ies:normalize"}, 1);
  }
  if (!picture.empty()) {
    out.attribute({"asset", "inputs:texture:file"}, UsdAsset{picture});
    out.attribute({"token", "inputs:texture:format"}, UsdToken{"latlong"});
  }
  // USD's environment maps have their middle column at +z.
  out.transform(light.shape == Shape::dome ? light.place * Transform::rotation({0, 1, 0}, kPi)
                                           : light.place);
  out.end();
}

}  // namespace vug::exchange
