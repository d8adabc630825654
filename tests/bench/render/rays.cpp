// Rays per second of a render against those of a bare loop over the same rays. The linker leads the
// renderer's calls of Embree through here (--wrap), which records them in order; then the loop
// hands the recorded rays to the same tree and does nothing else. One thread.
//   bench_rays [SCENE.json] [SPP] [WIDTH]
// Skips where the reference cave, which is no part of this repository, is absent.
#include "bench_scene.h"

#include <vug/render/kinds.h>
#include <vug/render/render.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace {

struct Recorded {
  RTCRay ray;
  bool shadow;
};
std::vector<Recorded> rays;
bool recording = false;
RTCScene tree = nullptr;

void record(RTCScene scene, const RTCRay& ray, bool shadow) {
  if (tree != scene) rtcRetainScene(tree = scene);
  rays.push_back({ray, shadow});
}

double seconds(const auto& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

extern "C" {
void __real_rtcIntersect1(RTCScene, RTCIntersectContext*, RTCRayHit*);  // NOLINT
void __real_rtcOccluded1(RTCScene, RTCIntersectContext*, RTCRay*);      // NOLINT

void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* hit) {  // NOLINT
  if (recording) record(scene, hit->ray, false);
  __real_rtcIntersect1(scene, context, hit);
}
void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {  // NOLINT
  if (recording) record(scene, *ray, true);
  __real_rtcOccluded1(scene, context, ray);
}
}

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
    Progress progress([&, start = std::chrono::steady_clock::now()](const std::string& stage,
                                                                    double done) mutable {
      const auto now = std::chrono::steady_clock::now();
      // The tree is built anew for each render; only what comes after counts.
      if (stage == "rendering" && done == 0) {
        start = now;
        if (recording) rays.clear();
      }
      if (stage == "rendering") rendering = std::chrono::duration<double>(now - start).count();
    });
    render::render(scene, options, progress);
    return rendering;
  };
  recording = true;
  rendered();
  recording = false;

  // In turn, and the better of three each: other work on the machine slows both.
  double ours = 1e30, bare = 1e30;
  std::vector<Recorded> spent;
  for (int round = 0; round < 3; ++round) {
    ours = std::min(ours, rendered());
    spent = rays;
    bare = std::min(bare, seconds([&] {
                      for (Recorded& r : spent) {
                        RTCIntersectContext context;
                        rtcInitIntersectContext(&context);
                        if (r.shadow) {
                          __real_rtcOccluded1(tree, &context, &r.ray);
                          continue;
                        }
                        RTCRayHit query;
                        query.ray = r.ray;
                        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
                        __real_rtcIntersect1(tree, &context, &query);
                        r.ray.tfar = query.ray.tfar;
                      }
                    }));
  }
  const auto shadows = std::count_if(rays.begin(), rays.end(), [](auto& r) { return r.shadow; });
  const double samples = 1.0 * options.width * options.height * options.spp;
  fmt::print(
      "{} rays ({:.2f} a sample, {:.2f} of them shadow rays)\n"
      "render {:.3f} s, {:.2f} M rays/s; bare loop {:.3f} s, {:.2f} M rays/s; ratio {:.3f}\n",
      rays.size(), static_cast<double>(rays.size()) / samples,
      static_cast<double>(shadows) / samples, ours, 1e-6 * static_cast<double>(rays.size()) / ours,
      bare, 1e-6 * static_cast<double>(rays.size()) / bare, bare / ours);
  return 0;
}
