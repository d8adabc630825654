#include <vug/base/parallel.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/folds.h>
#include <vug/meshing/split_quads.h>

#include <cmath>

namespace vug::meshing {
namespace {

constexpr double kFlatCosine = 0.9995;  ///< About 2 degrees between the two triangles.

/// The lesser cosine between either half, when cut from corner k to k + 2, and the whole quad.
double least_facing(const Face& face, uint32_t k, const std::vector<Vec3d>& points) {
  const Vec3d a = corner_normal(face, (k + 1) % 4, points);
  const Vec3d b = corner_normal(face, (k + 3) % 4, points);
  const Vec3d whole = (a + b).normalized();
  return std::min(a.normalized().dot(whole), b.normalized().dot(whole));
}

bool is_flat(const Face& face, const std::vector<Vec3d>& points) {
  return least_facing(face, 0, points) > kFlatCosine && least_facing(face, 1, points) > kFlatCosine;
}

bool shorter_from_0(const Face& face, const std::vector<Vec3d>& points) {
  const double from_0 = (points[face.corners[2]] - points[face.corners[0]]).length2();
  const double from_1 = (points[face.corners[3]] - points[face.corners[1]]).length2();
  return from_0 <= from_1;
}

/// Whether to cut from corner 0 (else from corner 1).
bool better_from_0(const Face& face, const std::vector<Vec3d>& raw,
                   const std::vector<Vec3d>& points, const field::Field& exact, double voxel) {
  const auto good = [&](uint32_t k) {
    return !turned_over(face, k, raw, points) && !faces_backwards(face, k, points, exact, voxel);
  };
  const auto sound = [&](uint32_t k) { return good(k + 1) && good((k + 3) % 4); };
  if (sound(0) != sound(1)) return sound(0);
  const auto off = [&](uint32_t k) {
    return std::fabs(exact.value((points[face.corners[k]] + points[face.corners[k + 2]]) * 0.5));
  };
  return off(0) <= off(1);
}

}  // namespace

std::vector<mesh::Triangle> split_quads(const FaceMesh& faces, const std::vector<Vec3d>& points,
                                        const field::Field* exact, double voxel,
                                        Progress& progress) {
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
  if (exact)
    for_each_in_blocks(
        *exact, centres, {8 * voxel, 4 * voxel},
        [&](uint32_t i, const field::Field& local) {
          from_0[quads[i]] =
              better_from_0(faces.faces[quads[i]], faces.points, points, local, voxel);
        },
        progress);
  std::vector<mesh::Triangle> triangles;
  triangles.reserve(2 * count);
  for (size_t f = 0; f < count; ++f) {
    const auto& c = faces.faces[f].corners;
    if (faces.faces[f].size == 3) {
      triangles.push_back({c[0], c[1], c[2]});
    } else if (from_0[f]) {
      triangles.push_back({c[0], c[1], c[2]});
      triangles.push_back({c[0], c[2], c[3]});
    } else {
      triangles.push_back({c[1], c[2], c[3]});
      triangles.push_back({c[1], c[3], c[0]});
    }
  }
  return triangles;
}

}  // namespace vug::meshing
