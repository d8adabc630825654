// SPDX-License-Identifier: Apache-2.0
#include <vug/base/xml.h>
#include <vug/scan/quality_warnings.h>
#include <vug/scan/report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::scan {
namespace {

using Json = nlohmann::ordered_json;

/// Rounded to tenths of millimetres; null for non-finite numbers.
Json metres(double value) {
  return std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json(nullptr);
}

Json vector(const Vec3d& v) { return {v.x, v.y, v.z}; }

const char* color_of(OpeningKind kind) { return kind == OpeningKind::door ? "#d9822b" : "#2b6cb0"; }

/// The mean distance of each wall in front of the plane, the area of its pixels, and its
/// roughness.
Json walls_json(const RangeImage& range, const SurfaceMap& map) {
  Json out = Json::array();
  for (const Wall& wall : map.walls) {
    double pixels = 0, depth = 0;
    for (int y = 0; y < range.height; ++y)
      for (int x = 0; x < range.width; ++x) {
        const size_t p = range.index(x, y);
        if (&map.wall(p) != &wall || map.surface[p] == Surface::outside) continue;
        ++pixels, depth += wall.at(range.pixel_center(x, y));
      }
    out.push_back({{"depth", metres(depth / pixels)},
                   {"area", metres(pixels * range.pixel * range.pixel)},
                   {"rms", metres(wall.rms)}});
  }
  return out;
}

}  // namespace

std::string report_json(const PointCloud& cloud, const PlaneFit& plane, const RangeImage& range,
                        const SurfaceMap& map, const std::vector<Opening>& openings) {
  Json out;
  out["points"] = cloud.size();
  out["dropped"] = cloud.dropped;
  const double wide = range.metres_wide(), high = range.metres_high();
  out["plane"] = {{"inliers", plane.inliers},
                  {"tolerance", plane.tolerance},
                  {"rms", metres(plane.rms)},
                  {"lean_degrees", metres(plane.lean * 180 / kPi)},
                  {"origin", vector(range.frame.origin)},
                  {"x", vector(range.frame.x)},
                  {"y", vector(range.frame.y)},
                  {"z", vector(range.frame.z)}};
  out["doubts"] = Json::array();
  for (const QualityWarning& warning : quality_warnings(cloud, plane, range))
    out["doubts"].push_back(warning.message);
  size_t inside = 0, seen = 0, full = 0;
  for (size_t p = 0; p < range.pixel_count(); ++p) {
    inside += range.count[p];
    seen += !std::isnan(range.depth[p]);
    full += map.surface[p] != Surface::outside;
  }
  const double area = range.pixel * range.pixel;
  const auto share = [](size_t part, size_t of) {
    return of > 0 ? metres(static_cast<double>(part) / static_cast<double>(of)) : Json(nullptr);
  };
  out["range"] = {
      {"width", metres(wide)},
      {"height", metres(high)},
      {"pixel", range.pixel},
      {"pixels", {range.width, range.height}},
      {"points", inside},
      {"area", metres(static_cast<double>(full) * area)},
      {"points_per_square_metre", seen > 0 ? Json(std::llround(static_cast<double>(inside) /
                                                               (static_cast<double>(seen) * area)))
                                           : Json(nullptr)},
      {"holes", full > 0 ? share(full - std::min(seen, full), full) : Json(nullptr)}};
  out["wall"] = {{"rms", metres(map.walls[0].rms)}, {"set_back", metres(map.set_back)}};
  out["walls"] = walls_json(range, map);
  out["openings"] = Json::array();
  for (const Opening& o : openings)
    out["openings"].push_back({{"kind", to_string(o.kind)},
                               {"rect",
                                {metres(o.box.min.x), metres(o.box.min.y), metres(o.box.size().x),
                                 metres(o.box.size().y)}},
                               {"empty", metres(o.empty)},
                               {"set_back", metres(o.set_back)}});
  return out.dump(2) + "\n";
}

std::string openings_svg(const RangeImage& range, const std::vector<Opening>& openings,
                         const std::string& picture, double pixels) {
  const double scale = pixels / range.metres_wide();
  const double high = range.metres_high();
  const auto number = [&](double length) { return fmt::format("{:.2f}", length * scale); };
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\">\n",
      number(range.metres_wide()), number(high));
  if (!picture.empty())
    out += fmt::format("<image href=\"{}\" width=\"{}\" height=\"{}\"/>\n", xml_text(picture),
                       number(range.metres_wide()), number(high));
  for (const Opening& o : openings)
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" fill-opacity=\"0.25\" "
        "stroke=\"{}\" stroke-width=\"2\"><title>{} {:.2f} x {:.2f} m</title></rect>\n",
        number(o.box.min.x), number(high - o.box.max.y), number(o.box.size().x),
        number(o.box.size().y), color_of(o.kind), color_of(o.kind), to_string(o.kind),
        o.box.size().x, o.box.size().y);
  return out + "</svg>\n";
}

image::Image picture_of(const RangeImage& range, const SurfaceMap& map) {
  constexpr double kDeep = 0.5;  // Metres behind the wall beyond which everything is equally dark.
  image::Image out(range.width, range.height, {"R", "G", "B"});
  for (int y = 0; y < range.height; ++y)
    for (int x = 0; x < range.width; ++x) {
      const size_t p = range.index(x, y);
      const double before = range.depth[p] - map.wall(p).at(range.pixel_center(x, y));
      const double near = std::clamp(before / kDeep, -1.0, 0.2);
      std::array<double, 3> color{0, 0, 0};
      if (map.surface[p] == Surface::wall) color = {0.55 + near, 0.55 + near, 0.52 + near};
      if (map.surface[p] == Surface::behind) color = {0.1, 0.35 + 0.3 * near, 0.9 + 0.6 * near};
      if (map.surface[p] == Surface::nothing) color = {0.5, 0.08, 0.08};
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = static_cast<float>(color[c]);
    }
  return out;
}

}  // namespace vug::scan
