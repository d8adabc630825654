// SPDX-License-Identifier: Apache-2.0
// Openness of surface points: the share of unoccluded directions above them.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/vec.h>
#include <vug/mesh/mesh.h>

#include <memory>
#include <vector>

namespace vug::render {

struct OpennessOptions {
  int rays = 64;  ///< Per point; the error falls with their square root or faster.
  double max_distance = kInfinity;  ///< Metres: occluders beyond this are ignored.
  double offset = 1e-3;  ///< Metres from the point to the rays' origin, along the normal.
  bool sky = false;      ///< Directions below the horizon (y up) count as occluded.
};

/// The occluders, prepared for ray tracing.
class Openness {
 public:
  explicit Openness(const std::vector<mesh::MeshPtr>& meshes);
  ~Openness();

  /// For each point, the cosine-weighted share of unoccluded directions in the hemisphere around
  /// its normal: 1 - ambient occlusion, or with `sky` the irradiance from a uniform sky relative to
  /// that of open, level ground (1; 1/2 on a wall, 0 on a ceiling). Normals must have unit length.
  /// Results are the same for any number of threads, whatever the other points are.
  std::vector<float> compute(const std::vector<Vec3f>& points, const std::vector<Vec3f>& normals,
                             const OpennessOptions& options,
                             Progress& progress = Progress::none()) const;

 private:
  struct Surroundings;
  std::unique_ptr<const Surroundings> surroundings_;
};

}  // namespace vug::render
