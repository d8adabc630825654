// SPDX-License-Identifier: Apache-2.0
#include "bench_scene.h"

#include <vug/base/atomic_file.h>
#include <vug/base/rng.h>
#include <vug/render/kinds.h>

#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

namespace vug::bench {
namespace {

using nlohmann::json;

Vec3d vector(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

/// Reads the binary PLY files of the bench; the general reader is in mesh.
mesh::MeshPtr read_ply(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  const size_t body = bytes.find("end_header\n") + 11;
  const auto count = [&](const char* element) {
    return std::stoul(bytes.substr(bytes.find(element) + std::strlen(element)));
  };
  auto mesh = std::make_shared<mesh::Mesh>();
  mesh->positions.resize(count("element vertex "));
  mesh->triangles.resize(count("element face "));
  const char* from = bytes.data() + body;
  const size_t size = mesh->positions.size() * sizeof(Vec3f);
  std::memcpy(static_cast<void*>(mesh->positions.data()), from, size);
  from += size;
  for (mesh::Triangle& t : mesh->triangles) {
    std::memcpy(t.data(), from + 1, sizeof t);
    from += 1 + sizeof t;
  }
  return mesh;
}

}  // namespace

render::Scene read_scene(const std::filesystem::path& path, const std::string& mesh_file,
                         const std::string& sky, bool lamps, bool portals) {
  const json j = json::parse(read_text(path));
  render::Scene scene;
  const json& c = j["camera"];
  scene.camera = render::make_camera(
      "perspective", {{"eye", vector(c["eye"])},
                      {"target", vector(c["target"])},
                      {"up", vector(c["up"])},
                      {"fov", render::radians(c["hfov_deg"].get<double>() * kPi / 180)}});
  render::Object rock;
  rock.name = "rock";
  rock.mesh = read_ply(mesh_file.empty() ? path.parent_path() / j["mesh"].get<std::string>()
                                         : std::filesystem::path(mesh_file));
  rock.material = render::make_material("lambert", {{"albedo", vector(j["albedo"])}});
  scene.objects.push_back(rock);
  for (const json& e : j.value("emissive_meshes", json::array())) {
    render::Object crystals;
    crystals.name = "crystals";
    crystals.mesh = read_ply(path.parent_path() / e["mesh"].get<std::string>());
    crystals.material = render::make_material("lambert", {{"albedo", Vec3d(0)}});
    crystals.emission = Vec3f(vector(e["radiance"]));
    scene.objects.push_back(crystals);
  }
  const auto rectangle = [](const json& r) {
    return NamedValues{{"center", vector(r["center"])},
                       {"normal", vector(r["normal"])},
                       {"up", vector(r["up"])},
                       {"width", r["size"][0].get<double>()},
                       {"height", r["size"][1].get<double>()}};
  };
  if (lamps)
    for (const json& l : j["lights"]) {
      NamedValues p = rectangle(l);
      p.emplace_back("radiance", vector(l["radiance"]));
      scene.lights.push_back(render::make_light("rect", p));
    }
  Vec3d radiance = vector(j["sky"]);
  if (!sky.empty()) std::sscanf(sky.c_str(), "%lf,%lf,%lf", &radiance.x, &radiance.y, &radiance.z);
  scene.lights.push_back(render::make_light("sky", {{"radiance", radiance}}));
  if (portals)
    for (const json& p : j["portals"])
      scene.lights.push_back(render::make_light("portal", rectangle(p)));
  if (j.contains("volume")) {
    const json& v = j["volume"];
    scene.medium = render::make_medium(
        "cloud", {{"file", (path.parent_path() / v["vdb"].get<std::string>()).string()},
                  {"grid", v["grid"].get<std::string>()},
                  {"extinction", Number{v["scale"].get<double>(), Dimension::per_length}},
                  {"albedo", Vec3d(v["albedo"].get<double>())},
                  {"g", v["g"].get<double>()}});
  }
  return scene;
}

void add_lights(render::Scene& scene, int count) {
  const Box3d box = mesh::bounds(*scene.objects.front().mesh);
  RandomStream random{RandomKey(1)};
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(box.min.x, box.max.x), y = random.uniform(box.min.y, box.max.y);
    scene.lights.push_back(
        render::make_light("sphere", {{"center", Vec3d(x, y, random.uniform(box.min.z, box.max.z))},
                                      {"radius", 0.01},
                                      {"power", 20.0 / count}}));
  }
}

}  // namespace vug::bench
