#include <vug/exchange/usd_lamp.h>

#include <algorithm>

namespace vug::exchange {
namespace {

constexpr double kDegrees = 180 / kPi;

const char* type_of(Lamp::Shape shape) {
  switch (shape) {
    case Lamp::Shape::rectangle:
      return "RectLight";
    case Lamp::Shape::disk:
      return "DiskLight";
    case Lamp::Shape::sun:
      return "DistantLight";
    case Lamp::Shape::dome:
      return "DomeLight";
    default:
      return "SphereLight";
  }
}

}  // namespace

void write_usd_camera(UsdText& out, const Camera& camera, const std::string& name,
                      double metres_per_unit) {
  // Lenses and film are told in tenths of the unit.
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

void write_usd_lamp(UsdText& out, const Lamp& lamp, const std::string& name,
                    const std::string& picture) {
  using Shape = Lamp::Shape;
  const bool shaped = lamp.shape == Shape::spot || !lamp.profile.empty();
  std::vector<std::string> metadata;
  if (shaped) metadata.emplace_back("prepend apiSchemas = [\"ShapingAPI\"]");
  out.def(type_of(lamp.shape), name, metadata);
  const Vec3d light = lamp.shape == Shape::sun ? strength(lamp) : lamp.radiance;
  const double most = std::max({light.x, light.y, light.z});
  out.line("color3f inputs:color = {}", usd_tuple(most > 0 ? light / most : Vec3d(1.0)));
  out.line("float inputs:intensity = {}", most);
  out.line("bool inputs:normalize = {}", lamp.shape == Shape::sun ? 1 : 0);
  if (lamp.shape == Shape::rectangle) {
    out.line("float inputs:width = {}", lamp.width);
    out.line("float inputs:height = {}", lamp.height);
  } else if (lamp.shape == Shape::sun) {
    out.line("float inputs:angle = {}", lamp.angle * kDegrees);
  } else if (lamp.shape != Shape::dome) {
    out.line("float inputs:radius = {}", lamp.radius);
  }
  if (lamp.shape == Shape::spot) {
    out.line("float inputs:shaping:cone:angle = {}", 0.5 * lamp.angle * kDegrees);
    out.line("float inputs:shaping:cone:softness = {}", lamp.edge);
  }
  if (!lamp.profile.empty()) {
    out.line("asset inputs:shaping:ies:file = @{}@", lamp.profile.generic_string());
    out.line("bool inputs:shaping:ies:normalize = 1");
  }
  if (!picture.empty()) {
    out.line("asset inputs:texture:file = @{}@", picture);
    out.line("token inputs:texture:format = \"latlong\"");
  }
  // The middle column of such a picture lies towards +z there.
  out.place(lamp.shape == Shape::dome ? lamp.place * Transform::rotation({0, 1, 0}, kPi)
                                      : lamp.place);
  out.end();
}

}  // namespace vug::exchange
