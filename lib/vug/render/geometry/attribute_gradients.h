// How the numbers that a mesh carries change along it: what bump needs of an attribute.
#pragma once

#include <vug/mesh/mesh.h>

#include <deque>
#include <mutex>
#include <string_view>
#include <vector>

namespace vug::render {

/// Slopes of a mesh's attributes at its vertices, each computed when first asked for. For several
/// threads.
class AttributeGradients {
 public:
  /// The mesh must outlive it.
  explicit AttributeGradients(const mesh::Mesh& mesh);

  /// For each vertex the slope, a change for each metre, in the mesh's own space; of a vector that
  /// of the mean of its parts. The mean over the triangles around weighted by their areas, along
  /// each of which an attribute changes evenly. Null where the mesh has no such attribute.
  const std::vector<Vec3f>* of(std::string_view attribute) const;

 private:
  struct Slope {
    std::once_flag once;
    std::vector<Vec3f> at_vertex;
  };
  const mesh::Mesh& mesh_;
  mutable std::deque<Slope> gradients_;  ///< As many as the mesh has attributes.
};

}  // namespace vug::render
