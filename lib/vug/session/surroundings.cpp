#include <vug/render/occlusion.h>
#include <vug/session/surroundings.h>

namespace vug::session {
namespace {

const std::string kExposure = "exposure", kOcclusion = "occlusion";
constexpr double kNear = 0.5;

}  // namespace

const std::vector<std::string>& surroundings() {
  static const std::vector<std::string> names = {kExposure, kOcclusion};
  return names;
}

std::vector<float> surroundings_of(const cells::Network& cells, const std::string& name,
                                   const std::vector<mesh::MeshPtr>& meshes, Progress& progress) {
  render::OpennessOptions options;
  // Cells lie on the facets of a mesh, whose smooth normals see a little way into their neighbours.
  options.lift = cells.spacing / 4;
  options.sky = name == kExposure;
  if (name == kOcclusion) options.reach = kNear;
  std::vector<float> shares =
      render::Openness(meshes).of(cells.position, cells.normal, options, progress);
  if (name == kOcclusion)
    for (float& share : shares) share = 1 - share;
  return shares;
}

}  // namespace vug::session
