// SPDX-License-Identifier: Apache-2.0
#include <vug/base/digester.h>
#include <vug/meshing/polish_passes.h>

namespace vug::meshing {

PolishPasses::PolishPasses(PolishCache* cache, double voxel, const PolygonizeOptions& options)
    : cache_(cache),
      settings_(digest_of(voxel, options.creases, options.crease_angle, options.max_move)) {}

Digest PolishPasses::key_of(const PolishPass& pass, const std::vector<uint32_t>& indices,
                            const field::Field& local) const {
  std::vector<double> inputs;
  for (const uint32_t index : indices) pass.add_inputs(index, inputs);
  return digest_of(pass.number, settings_, local, indices.size(), inputs);
}

}  // namespace vug::meshing
