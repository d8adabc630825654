// How open places on surfaces are: the share of the directions above them in which nothing stands.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/vec.h>
#include <vug/mesh/mesh.h>

#include <memory>
#include <vector>

namespace vug::render {

struct OpennessOptions {
  int rays = 64;             ///< From each place; the error falls with their square root or faster.
  double reach = kInfinity;  ///< Metres: what is further away does not count.
  double lift = 1e-3;        ///< Metres along the normal from the place to where rays start.
  bool sky = false;          ///< Directions below the horizon (y up) count as closed.
};

/// What stands around, ready for rays.
class Openness {
 public:
  explicit Openness(const std::vector<mesh::MeshPtr>& meshes);
  ~Openness();

  /// Of each place, the open share of the directions within 90 degrees of its normal, each weighted
  /// with the cosine of its angle to it: 1 - ambient occlusion, or with `sky` the light of an even
  /// sky as a share of what falls on open level ground (1; 1/2 on a wall, 0 on a ceiling). Normals
  /// are unit. The same bytes for any number of threads, and for the same places among others.
  std::vector<float> of(const std::vector<Vec3f>& places, const std::vector<Vec3f>& normals,
                        const OpennessOptions& options,
                        Progress& progress = Progress::none()) const;

 private:
  struct Around;
  std::unique_ptr<const Around> around_;
};

}  // namespace vug::render
