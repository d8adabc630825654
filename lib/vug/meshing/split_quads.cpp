// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/folds.h>
#include <vug/meshing/polish_passes.h>
#include <vug/meshing/split_quads.h>

#include <algorithm>

namespace vug::meshing {
namespace {

constexpr double kFlatCosine = 0.9995;  ///< About 2 degrees between the two triangles.

/// The smaller cosine between either half, when split from corner k to k + 2, and the whole quad.
double min_facing(const Face& face, uint32_t k, const std::vector<Vec3d>& points) {
  const Vec3d a = corner_normal(face, (k + 1) % 4, points);
  const Vec3d b = corner_normal(face, (k + 3) % 4, points);
  const Vec3d whole = (a + b).normalized();
  return std::min(a.normalized().dot(whole), b.normalized().dot(whole));
}

bool is_flat(const Face& face, const std::vector<Vec3d>& points) {
  return min_facing(face, 0, points) > kFlatCosine && min_facing(face, 1, points) > kFlatCosine;
}

/// Chooses the diagonals of bent quads.
class DiagonalChooser {
 public:
  DiagonalChooser(const FaceMesh& faces, const std::vector<Vec3d>& points, double voxel)
      : faces_(faces), points_(points), voxel_(voxel) {}

  /// Sets from_0[i] to whether quad i of the list is split from corner 0 (otherwise from corner 1).
  void cut(const std::vector<uint32_t>& quads, const field::Field& exact, char* from_0) const {
    std::vector<Vec3d> queries;  // Six per quad: the centroids of the triangles and the midpoints
                                 // of the diagonals.
    std::vector<Vec3d> centres;
    for (const uint32_t f : quads) {
      const Face& face = faces_.faces[f];
      centres.push_back(faces_.centre(face));
      for (uint32_t k = 0; k < 4; ++k) queries.push_back(corner_centroid(face, k, points_));
      for (uint32_t k = 0; k < 2; ++k)
        queries.push_back((points_[face.corners[k]] + points_[face.corners[k + 2]]) * 0.5);
    }
    const auto answers = SurfaceProjector(exact, centres, kLargestError * voxel_).sample(queries);
    for (size_t i = 0; i < quads.size(); ++i)
      from_0[i] = better_from_0(faces_.faces[quads[i]], &answers[6 * i]);
  }

 private:
  bool better_from_0(const Face& face, const SurfacePoint* at) const {
    const auto good = [&](uint32_t k) {
      return !is_flipped(face, k, faces_.points, points_) &&
             !faces_backwards(face, k, points_, at[k], voxel_);
    };
    const auto sound = [&](uint32_t k) { return good(k + 1) && good((k + 3) % 4); };
    return sound(0) != sound(1) ? sound(0) : at[4].residual <= at[5].residual;
  }

  const FaceMesh& faces_;
  const std::vector<Vec3d>& points_;
  double voxel_;
};

}  // namespace

bool shorter_from_0(const Face& face, const std::vector<Vec3d>& points) {
  const double from_0 = (points[face.corners[2]] - points[face.corners[0]]).length2();
  const double from_1 = (points[face.corners[3]] - points[face.corners[1]]).length2();
  return from_0 <= from_1;
}

std::array<mesh::Triangle, 2> halves(const Face& face, bool from_0) {
  const auto& c = face.corners;
  if (from_0) return {{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}};
  return {{{c[1], c[2], c[3]}, {c[1], c[3], c[0]}}};
}

std::vector<mesh::Triangle> split_quads(const FaceMesh& faces, const std::vector<Vec3d>& points,
                                        const field::Field* exact, double voxel,
                                        const PolishPasses& passes, Progress& progress) {
  const size_t count = faces.faces.size();
  std::vector<char> from_0(count, 1);
  std::vector<char> bent(count, 0);
  parallel_for(
      count,
      [&](size_t f) {
        const Face& face = faces.faces[f];
        if (face.size != 4) return;
        from_0[f] = shorter_from_0(face, points);
        bent[f] = exact && !is_flat(face, points);
      },
      1024);
  std::vector<uint32_t> quads;
  std::vector<Vec3d> centres;
  for (uint32_t f = 0; f < count; ++f)
    if (bent[f]) {
      quads.push_back(f);
      centres.push_back(faces.centre(faces.faces[f]));
    }
  const DiagonalChooser chooser(faces, points, voxel);
  if (exact) {
    std::vector<char> chosen(quads.size());
    const PolishPass pass{
        4, *exact, centres, {8 * voxel, 4 * voxel}, [&](uint32_t i, std::vector<double>& inputs) {
          for (const uint32_t v : faces.faces[quads[i]].corners) {
            add_numbers(faces.points[v], inputs);
            add_numbers(points[v], inputs);
          }
        }};
    passes.run(
        pass,
        [&](const std::vector<uint32_t>& indices, const field::Field& local) {
          std::vector<uint32_t> some;
          for (const uint32_t i : indices) some.push_back(quads[i]);
          std::vector<char> own(some.size());
          chooser.cut(some, local, own.data());
          for (size_t i = 0; i < indices.size(); ++i) chosen[indices[i]] = own[i];
        },
        chosen, progress);
    for (size_t i = 0; i < quads.size(); ++i) from_0[quads[i]] = chosen[i];
  }
  std::vector<mesh::Triangle> triangles;
  triangles.reserve(2 * count);
  for (size_t f = 0; f < count; ++f) {
    const Face& face = faces.faces[f];
    if (face.size == 3) {
      triangles.push_back({face.corners[0], face.corners[1], face.corners[2]});
    } else {
      const auto [a, b] = halves(face, from_0[f]);
      triangles.insert(triangles.end(), {a, b});
    }
  }
  return triangles;
}

}  // namespace vug::meshing
