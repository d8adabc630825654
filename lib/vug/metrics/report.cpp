// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/folds.h>
#include <vug/metrics/report.h>
#include <vug/metrics/surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace vug::metrics {
namespace {

/// Calls row(key, value, unit) for every member, in the order of the struct.
template <class Row>
void for_each(const Report& r, const Row& row) {
  row("area", r.area, "m2");
  row("volume", r.volume, "m3");
  row("volume_cells", r.volume_cells, "m3");
  row("cf", r.cf, "%");
  row("cf_area", r.cf_area, "%");
  row("vertices", r.vertices, "");
  row("triangles", r.triangles, "");
  row("productions", r.productions, "");
  row("build_seconds", r.build_seconds, "s");
  row("components", r.components, "");
  row("genus", r.genus, "");
  row("boundary_edges", r.boundary_edges, "");
  row("nonmanifold_edges", r.nonmanifold_edges, "");
  row("misoriented_edges", r.misoriented_edges, "");
  row("zero_area_triangles", r.zero_area_triangles, "");
  row("folded_triangles", r.folded_triangles, "");
  row("self_intersections", r.self_intersections, "");
  row("invalid_places", r.invalid_places, "");
  row("small_features", r.small_features, "");
  row("bounds", r.bounds, "m");
}

std::string text(double value) { return fmt::format("{:.6g}", value); }
std::string text(size_t value) { return fmt::format("{}", value); }
std::string text(const Box3d& box) {
  if (box.isEmpty()) return "-";
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) .. ({:.6g}, {:.6g}, {:.6g})", box.min.x, box.min.y,
                     box.min.z, box.max.x, box.max.y, box.max.z);
}
std::string text(const Vec3d& p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }
std::string text(const std::vector<SmallFeaturePlace>& features) {
  constexpr size_t kMost = 5;
  std::string list;
  for (size_t i = 0; i < std::min(kMost, features.size()); ++i)
    list += fmt::format("{}{} at {}{}", i ? "; " : "", features[i].kind, text(features[i].centre),
                        features[i].removed ? ", removed" : "");
  if (features.size() > kMost) list += fmt::format("; and {} others", features.size() - kMost);
  return list.empty() ? "-" : list;
}
/// The places with the most pairs.
std::string text(const std::vector<InvalidPlace>& places) {
  constexpr size_t kMost = 5;
  std::string list;
  for (size_t i = 0; i < std::min(kMost, places.size()); ++i)
    list += fmt::format("{}{} within {:.2g} m at ({:.6g}, {:.6g}, {:.6g})", i ? "; " : "",
                        places[i].count, places[i].size, places[i].centre.x, places[i].centre.y,
                        places[i].centre.z);
  if (places.size() > kMost) list += fmt::format("; and {} others", places.size() - kMost);
  return list.empty() ? "-" : list;
}
template <class T>
std::string text(const std::optional<T>& value) {
  return value ? text(*value) : "-";
}

nlohmann::ordered_json json(double value) { return value; }
nlohmann::ordered_json json(size_t value) { return value; }
nlohmann::ordered_json json(const Box3d& box) {
  if (box.isEmpty()) return nullptr;
  return {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
}
nlohmann::ordered_json json(const std::vector<InvalidPlace>& places) {
  auto list = nlohmann::ordered_json::array();
  for (const InvalidPlace& place : places)
    list.push_back({{"center", {place.centre.x, place.centre.y, place.centre.z}},
                    {"size", place.size},
                    {"count", place.count}});
  return list;
}
nlohmann::ordered_json json(const std::vector<SmallFeaturePlace>& features) {
  auto list = nlohmann::ordered_json::array();
  for (const SmallFeaturePlace& each : features)
    list.push_back({{"kind", each.kind},
                    {"center", {each.centre.x, each.centre.y, each.centre.z}},
                    {"removed", each.removed}});
  return list;
}
template <class T>
nlohmann::ordered_json json(const std::optional<T>& value) {
  return value ? json(*value) : nlohmann::ordered_json(nullptr);
}

/// The triangles that are folded or have no area, each as a pair with itself.
std::vector<mesh::FacePair> invalid_alone(const mesh::Mesh& mesh) {
  std::vector<mesh::FacePair> list;
  for (const uint32_t face : mesh::folded_triangles(mesh)) list.emplace_back(face, face);
  for (uint32_t face = 0; face < mesh.triangles.size(); ++face)
    if (mesh::double_area_vector(mesh, face) == Vec3d(0)) list.emplace_back(face, face);
  return list;
}

}  // namespace

Report measure(const mesh::Mesh& mesh, const MeasureOptions& options) {
  const mesh::Edges edges = mesh::find_edges(mesh);
  const mesh::Topology topology = mesh::inspect(mesh, edges);
  const Convexity bends = convexity(mesh, edges);
  Report report;
  report.area = area(mesh);
  report.volume = volume(mesh);
  report.cf = bends.cf();
  report.cf_area = bends.cf_area();
  report.vertices = mesh.positions.size();
  report.triangles = mesh.triangles.size();
  report.components = topology.components;
  report.genus = topology.genus;
  report.boundary_edges = topology.boundary_edges;
  report.nonmanifold_edges = topology.nonmanifold_edges;
  report.misoriented_edges = topology.misoriented_edges;
  report.zero_area_triangles = topology.degenerate_triangles;
  std::vector<mesh::FacePair> invalid = invalid_alone(mesh);
  report.folded_triangles = invalid.size() - report.zero_area_triangles;
  if (options.self_intersections) {
    const std::vector<mesh::FacePair> pairs =
        options.overlapping_components
            ? mesh::self_intersections(mesh, mesh::face_components(mesh, edges))
            : mesh::self_intersections(mesh);
    report.self_intersections = pairs.size();
    invalid.insert(invalid.end(), pairs.begin(), pairs.end());
  }
  report.invalid_triangles = invalid_triangles(invalid);
  report.invalid_places = invalid_places(mesh, invalid);
  report.bounds = mesh::bounds(mesh);
  return report;
}

std::string to_table(const Report& report) {
  std::string table;
  for_each(report, [&](const char* key, const auto& value, const char* unit) {
    const std::string shown = text(value);
    table += fmt::format("{:<18}  {}", key, shown);
    if (*unit && shown != "-") table += fmt::format(" {}", unit);
    table += '\n';
  });
  return table;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json object;
  for_each(report,
           [&](const char* key, const auto& value, const char*) { object[key] = json(value); });
  return object.dump(2) + "\n";
}

}  // namespace vug::metrics
