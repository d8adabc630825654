// SPDX-License-Identifier: Apache-2.0
// Rays per second of a render compared with those of a bare loop over the same rays. The linker
// redirects the renderer's rays to this file (--wrap), which records them in order. The loop then
// traces them one after the other with Embree's BVH of the same triangles. One thread.
//   bench_rays [SCENE.json] [SPP] [WIDTH]
// Skips if the reference cave, which the build generates (tests/bench/reference_caves), is missing.
#include "bench_scene.h"

#include <vug/raytree/bvh_traversal.h>
#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

struct Recorded {
  vug::render::Ray ray;
  float distance;
  bool shadow;
};
std::vector<Recorded> rays;
bool recording = false;

/// Processor time in seconds, which other processes hardly affect.
double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double seconds(const auto& work) {
  const double start = processor();
  work();
  return processor() - start;
}

}  // namespace

using Search = vug::raytree::BvhTraversal;
#define SEARCH _ZN3vug7raytree12BvhTraversalC1ERKNS0_7WideBvhERKNS0_3RayEfNS1_5QueryE
#define JOINED(a, b) a##b
#define NAMED(a, b) JOINED(a, b)
extern "C" {
void NAMED(__real_, SEARCH)(Search*, const vug::raytree::WideBvh&, const vug::render::Ray&, float,
                            Search::Query);
void NAMED(__wrap_, SEARCH)(Search* search, const vug::raytree::WideBvh& tree,
                            const vug::render::Ray& ray, float distance, Search::Query aim) {
  if (recording) rays.push_back({ray, distance, aim == Search::Query::any});
  NAMED(__real_, SEARCH)(search, tree, ray, distance, aim);
}
}

namespace {

/// Embree's BVH as a plain renderer would use it.
RTCScene embree_of(const vug::render::Scene& scene, RTCDevice device) {
  RTCScene tree = rtcNewScene(device);
  rtcSetSceneFlags(tree, RTC_SCENE_FLAG_ROBUST);
  for (const vug::render::Object& object : scene.objects) {
    const vug::mesh::Mesh& mesh = *object.mesh;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto give = [&](RTCBufferType type, RTCFormat format, const auto& from) {
      const size_t size = sizeof(from[0]);
      std::memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, size, from.size()),
                  static_cast<const void*>(from.data()), size * from.size());
    };
    give(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    give(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(tree);
  return tree;
}

/// Number of recorded rays that hit something.
size_t traced(RTCScene tree) {
  size_t met = 0;
  for (const Recorded& r : rays) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    const vug::Vec3f &o = r.ray.origin, &d = r.ray.direction;
    query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, r.distance, ~0u, 0, 0};
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    if (r.shadow)
      rtcOccluded1(tree, &context, &query.ray);
    else
      rtcIntersect1(tree, &context, &query);
    met += r.shadow ? query.ray.tfar < 0 : query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }
  return met;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vug;  // NOLINT
  const std::string file = argc > 1 ? argv[1] : VUG_BENCH_DATA "/cave_scene.json";
  if (!std::filesystem::exists(std::filesystem::path(file).parent_path() / "cave.ply")) {
    fmt::print("skipped: the bench needs '{}' and its mesh\n", file);
    return 0;
  }
  render::Options options;
  options.spp = argc > 2 ? std::stoi(argv[2]) : 8;
  options.width = argc > 3 ? std::stoi(argv[3]) : 320;
  options.height = options.width * 9 / 16;
  options.threads = 1;
  options.max_bounces = 8;
  const render::Scene scene = bench::read_scene(file);

  const auto rendered = [&] {
    double rendering = 0;
    Progress progress([&, start = processor()](const std::string& stage, double done) mutable {
      const double now = processor();
      // The tree is rebuilt for each render; only the time after that counts.
      if (stage == "rendering" && done == 0) {
        start = now;
        if (recording) rays.clear();
      }
      if (stage == "rendering") rendering = now - start;
    });
    render::render(scene, options, progress);
    return rendering;
  };
  recording = true;
  rendered();
  recording = false;

  // Alternating, best of three each, since other processes slow both down.
  RTCDevice device = rtcNewDevice("isa=avx2");
  RTCScene tree = embree_of(scene, device);
  double ours = 1e30, bare = 1e30;
  size_t met = 0;
  for (int round = 0; round < 3; ++round) {
    ours = std::min(ours, rendered());
    bare = std::min(bare, seconds([&] { met = traced(tree); }));
  }
  rtcReleaseScene(tree);
  rtcReleaseDevice(device);
  const auto shadows = std::count_if(rays.begin(), rays.end(), [](auto& r) { return r.shadow; });
  const double samples = 1.0 * options.width * options.height * options.spp;
  fmt::print(
      "{} rays ({:.2f} a sample, {:.2f} of them shadow rays), {} hit something\n"
      "render {:.3f} s, {:.2f} M rays/s; bare loop {:.3f} s, {:.2f} M rays/s; ratio {:.3f}\n",
      rays.size(), static_cast<double>(rays.size()) / samples,
      static_cast<double>(shadows) / samples, met, ours,
      1e-6 * static_cast<double>(rays.size()) / ours, bare,
      1e-6 * static_cast<double>(rays.size()) / bare, bare / ours);
  return 0;
}
