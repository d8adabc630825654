// Renders a bench scene (JSON beside a binary PLY) and prints samples per second: the same
// scenes are rendered by Cycles for comparison, see docs/performance.md.
//   bench_cave [SCENE.json OUT.exr] [--size WxH] [--spp N] [--threads N] [--seed N] [--portal]
//              [--mesh FILE.ply] [--sky R,G,B] [--no-lamps] [--lamps N] [--bounces N]
// Without a scene it takes the reference cave of the bench data, which is no part of this
// repository (-DVUG_BENCH_DATA=FOLDER), and skips where there is none.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/image/io.h>
#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace {
using namespace vug;  // NOLINT
using nlohmann::json;

Vec3d vector(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

/// Positions and triangles of the plain binary PLY the bench makes; other readers live in mesh.
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
    return Named{{"center", vector(r["center"])},
                 {"normal", vector(r["normal"])},
                 {"up", vector(r["up"])},
                 {"width", r["size"][0].get<double>()},
                 {"height", r["size"][1].get<double>()}};
  };
  if (lamps)
    for (const json& l : j["lights"]) {
      Named p = rectangle(l);
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

void add_lamps(render::Scene& scene, int count) {
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

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Renders a bench scene");
  std::string file = VUG_BENCH_DATA "/cave_scene.json", out, size = "320x180", mesh_file, sky,
              guide = "auto";
  render::Options options;
  bool portal = false, no_lamps = false;
  double haze = 0;
  int lamps = 0;
  app.add_option("scene", file);
  app.add_option("out", out, "EXR; default: the picture is not kept");
  app.add_option("--size", size);
  app.add_option("--spp", options.spp);
  app.add_option("--threads", options.threads);
  app.add_option("--seed", options.seed);
  app.add_option("--bounces", options.max_bounces);
  app.add_option("--mesh", mesh_file);
  app.add_option("--sky", sky);
  app.add_option("--haze", haze);
  app.add_option("--lamps", lamps, "so many small balls of together 20 W, anywhere in the box");
  app.add_flag("--portal", portal);
  app.add_flag("!--no-openings", options.openings, "leave the sky to chance where no portal is");
  app.add_option("--guide", guide, "auto, on or off");
  app.add_flag("--no-lamps", no_lamps);
  CLI11_PARSE(app, argc, argv);
  options.integrator = render::make_integrator(
      "path", {{"max_bounces", options.max_bounces}, {"guide", Value::Name{guide}}});
  const std::filesystem::path mesh = mesh_file.empty()
                                         ? std::filesystem::path(file).parent_path() / "cave.ply"
                                         : std::filesystem::path(mesh_file);
  if (out.empty() && !(std::filesystem::exists(file) && std::filesystem::exists(mesh))) {
    fmt::print("skipped: the bench needs '{}' and '{}'\n", file, mesh.string());
    return 0;
  }
  try {
    std::sscanf(size.c_str(), "%dx%d", &options.width, &options.height);
    render::Scene scene = read_scene(file, mesh_file, sky, !no_lamps, portal);
    add_lamps(scene, lamps);
    if (haze > 0) scene.medium = render::make_medium("haze", {{"extinction", haze}});
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
    double preparing = 0;
    Progress progress([&](const std::string& stage, double fraction) {
      if (stage == "rendering" && fraction == 0)
        preparing = std::chrono::duration<double>(Clock::now() - start).count();
    });
    const image::Image picture = render::render(scene, options, progress);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count() - preparing;
    if (!out.empty()) image::write_exr(out, picture);
    fmt::print("{{\"prepare_s\": {:.3f}, \"render_s\": {:.3f}, \"msamples_per_s\": {:.4f}}}\n",
               preparing, seconds, 1e-6 * options.width * options.height * options.spp / seconds);
  } catch (const Error& error) {
    fmt::print(stderr, "bench_cave: {}\n", error.what());
    return 2;
  }
  return 0;
}
