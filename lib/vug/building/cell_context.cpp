// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/building/cell_context.h>
#include <vug/render/geometry/occlusion.h>
#include <vug/shot/cell_attributes.h>

namespace vug::building {
namespace {

constexpr double kNear = 0.5;

std::vector<float> curvature(const cells::Network& n) {
  std::vector<float> mean(n.size());
  parallel_for(
      n.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        float turned = 0, gone = 0;
        for (const uint32_t to : n.links.of(i)) {
          const Vec3f way = n.position[to] - n.position[i];
          turned += (n.normal[to] - n.normal[i]).dot(way);
          gone += way.length2();
        }
        mean[i] = gone > 0 ? turned / gone : 0;
      },
      4096);
  return mean;
}

}  // namespace

std::vector<float> cell_context(const cells::Network& cells, const std::string& name,
                                const std::vector<mesh::MeshPtr>& meshes, Progress& progress) {
  if (name == shot::kCurvature) return curvature(cells);
  render::OpennessOptions options;
  // Cells lie on flat facets, whose interpolated normals may point slightly into neighbouring
  // facets.
  options.offset = cells.spacing / 4;
  options.sky = name == shot::kExposure;
  if (name == shot::kOcclusion) options.max_distance = kNear;
  std::vector<float> shares =
      render::Openness(meshes).compute(cells.position, cells.normal, options, progress);
  if (name == shot::kOcclusion)
    for (float& share : shares) share = 1 - share;
  return shares;
}

}  // namespace vug::building
