// SPDX-License-Identifier: Apache-2.0
#include <vug/meshing/blocks.h>
#include <vug/meshing/exact_distances.h>
#include <vug/meshing/nearest_polygon.h>
#include <vug/meshing/polish_passes.h>
#include <vug/meshing/project.h>
#include <vug/meshing/tangent_planes.h>
#include <vug/meshing/targets.h>
#include <vug/volume/redistance.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

// Lengths in voxels.
constexpr double kOnSurface = 2e-3;    ///< Residual at which a point is on the surface.
constexpr double kNearSurface = 0.02;  ///< The same before a last Newton step, for rough fields.
constexpr double kAtFace = 0.1;        ///< Residual at which a point is on a face, not at an edge.
constexpr double kSufficient = 0.01;   ///< Possible excess of a distance that is not improved.
constexpr double kProgress = 5e-3;     ///< Progress of a step that is worth another.
constexpr double kAside = 0.2;         ///< Distance of samples from an edge, towards its sides.
constexpr double kBeyondBand = 3;      ///< Length of the tips of edges that polygons lack.
constexpr double kMargin = 5;          ///< Beyond the band, in which searches evaluate the field.
constexpr double kSamePlane = 0.97;    ///< Cosine between planes on the same side of an edge.
constexpr size_t kMostPlanes = 4;
constexpr int kVain = 2;  ///< Steps without progress that are permitted.
constexpr int kImprovements = 9;

/// The polygons of the level set with their vertices on the surface of the field; edges are blunt.
struct SampledSurface {
  SampledSurface(const volume::LevelSet& level_set, const field::Field& exact, Progress& progress)
      : mesh(mesh_on_surface(level_set, exact, progress)), polygons(mesh) {
    const double voxel = level_set.voxel();
    samples.resize(mesh.points.size());
    for_each_block(
        exact, mesh.points, {8 * voxel, 0.01 * voxel},
        [&](const std::vector<uint32_t>& vertices, const field::Field& local) {
          const std::vector<Vec3d> points = gathered(mesh.points, vertices);
          const auto found = SurfaceProjector(local, points, kLargestError * voxel).sample(points);
          for (size_t i = 0; i < vertices.size(); ++i) samples[vertices[i]] = found[i];
        },
        progress);
  }
  SampledSurface(const SampledSurface&) = delete;
  SampledSurface& operator=(const SampledSurface&) = delete;

  static FaceMesh mesh_on_surface(const volume::LevelSet& level_set, const field::Field& exact,
                                  Progress& progress) {
    FaceMesh mesh = face_mesh(volume::polygons_of(level_set), level_set.voxel());
    progress.begin("points on the surface", 2 * mesh.points.size());
    PolygonizeOptions options;
    options.creases = false;
    const PolishPasses passes(nullptr, level_set.voxel(), options);
    const std::vector<Target> targets =
        find_targets(mesh, exact, level_set.voxel(), options, passes, progress);
    for (size_t v = 0; v < targets.size(); ++v) mesh.points[v] = targets[v].surface;
    return mesh;
  }

  const FaceMesh mesh;
  const NearestPolygon polygons;
  std::vector<SurfacePoint> samples;  ///< Per vertex.
};

/// The search for the point of the surface nearest to p.
struct Search {
  size_t number = 0;  ///< Index of the point in its block.
  Vec3d p;
  double side = 1;                ///< 1 if p is outside, -1 inside: planes have p in front of them.
  const Face* polygon = nullptr;  ///< The nearest polygon.
  std::vector<TangentPlane> planes{};  ///< Those that may touch the surface at its nearest point.
  int vain = 0;                        ///< Steps without progress.
  bool done = false;
};

/// The tangent plane of the level of the field at a sample, moved onto the surface.
TangentPlane tangent_plane(const SurfacePoint& sample, double side) {
  const Vec3d normal = sample.normal * side;
  const double height = (sample.inside ? -1 : 1) * side * sample.residual;
  return {normal, normal.dot(sample.point) - height};
}

/// The point on the surface next to a sample, by one Newton step.
Vec3d foot_of(const SurfacePoint& sample) {
  return sample.point - sample.normal * (sample.inside ? -sample.residual : sample.residual);
}

/// Appends the plane of a sample, which replaces one on the same side of an edge.
void merge(std::vector<TangentPlane>& planes, const SurfacePoint& sample, double side) {
  if (sample.normal == Vec3d(0)) return;
  const TangentPlane plane = tangent_plane(sample, side);
  const auto same = [&](const TangentPlane& each) {
    return each.normal.dot(plane.normal) > kSamePlane;
  };
  planes.erase(std::remove_if(planes.begin(), planes.end(), same), planes.end());
  if (planes.size() == kMostPlanes) planes.erase(planes.begin());
  planes.push_back(plane);
}

/// The distances of one block's points.
class BlockSearch {
 public:
  BlockSearch(const volume::BandBlock& block, const field::Field& local, double voxel,
              const SampledSurface& surface)
      : block_(block),
        surface_(surface),
        voxel_(voxel),
        is_lower_bound_(local.exactness() <= field::Exactness::eikonal),
        near_surface_((is_lower_bound_ ? kOnSurface : kNearSurface) * voxel),
        projector_(local, block.points, kLargestError * voxel) {}

  void run(double band, std::vector<double>& distances) {
    std::fill(distances.begin(), distances.end(), kInfinity);
    std::vector<Search> searches =
        start_on_polygons(find_on_field(band, distances), band + beyond_band() * voxel_, distances);
    for (int round = 0;; ++round) {
      searches.erase(
          std::remove_if(searches.begin(), searches.end(), [](const Search& s) { return s.done; }),
          searches.end());
      if (searches.empty() || round == kImprovements) break;
      improve(searches, distances);
    }
  }

 private:
  /// Where the field cannot exceed the distance, follows its gradient from each point: the field is
  /// the distance if the foot is as far away. Returns the numbers of the other points.
  std::vector<size_t> find_on_field(double band, std::vector<double>& distances) {
    std::vector<size_t> open;
    if (!is_lower_bound_) {
      for (size_t i = 0; i < distances.size(); ++i) open.push_back(i);
      return open;
    }
    const auto values = projector_.sample(block_.points);
    const auto feet = projector_.project(block_.points, {band + voxel_, kOnSurface * voxel_, 10});
    for (size_t i = 0; i < distances.size(); ++i) {
      const double bound = values[i].residual;
      if (is_on_surface(feet[i])) distances[i] = (feet[i].point - block_.points[i]).length();
      if (bound <= band && distances[i] > bound + kSufficient * voxel_) open.push_back(i);
    }
    return open;
  }

  /// Moves the nearest points of the polygons to the field. Returns the searches whose distance may
  /// still be too large by more than a tolerance.
  std::vector<Search> start_on_polygons(const std::vector<size_t>& numbers, double limit,
                                        std::vector<double>& distances) {
    std::vector<Search> searches;
    std::vector<Vec3d> starts;
    for (const size_t i : numbers) {
      const auto nearest = surface_.polygons.find(block_.points[i], limit);
      if (!nearest.face) continue;
      searches.push_back({i, block_.points[i], block_.inside[i] ? -1.0 : 1.0, nearest.face});
      starts.push_back(nearest.point);
    }
    const auto feet = projector_.project(starts, {1.5 * voxel_, near_surface_, 10});
    for (size_t i = 0; i < searches.size(); ++i) {
      Search& s = searches[i];
      double& distance = distances[s.number];
      const TangentPlane plane = tangent_plane(feet[i], s.side);
      if (feet[i].residual <= near_surface_)
        distance = std::min(distance, (foot_of(feet[i]) - s.p).length());
      // Without a foot on the field, the polygon remains.
      if (distance == kInfinity) distance = (starts[i] - s.p).length();
      s.done = feet[i].normal == Vec3d(0) || distance > limit ||
               distance - plane.height(s.p) <= kSufficient * voxel_;
      // A polygon across an edge has vertices on both sides of it.
      for (uint32_t k = 0; k < s.polygon->size; ++k)
        merge(s.planes, surface_.samples[s.polygon->corners[k]], s.side);
      merge(s.planes, feet[i], s.side);
    }
    return searches;
  }

  /// Tries two points for each search: the nearest on its last plane, which converges on smooth
  /// surfaces, and the nearest behind all its planes, as at an edge. Takes planes anew at the
  /// former if it is nearly on the surface; otherwise at the latter, and aside from it on the side
  /// of each plane, where the surface behind that plane determines the field.
  void improve(std::vector<Search>& searches, std::vector<double>& distances) {
    std::vector<Vec3d> points;
    for (const Search& s : searches) {
      const TangentPlane& last = s.planes.back();
      points.push_back(s.p - last.normal * last.height(s.p));
      if (s.planes.size() == 1) continue;
      const Vec3d edge = nearest_behind(s.planes, s.p, kOnSurface * voxel_);
      points.push_back(edge);
      for (const TangentPlane& plane : s.planes)
        points.push_back(edge + plane.normal * (kAside * voxel_));
    }
    const std::vector<SurfacePoint> samples = projector_.sample(points);
    const SurfacePoint* sample = samples.data();
    for (Search& s : searches) {
      double& distance = distances[s.number];
      const double before = distance;
      const SurfacePoint& face = *sample++;
      if (face.residual <= near_surface_)
        distance = std::min(distance, (foot_of(face) - s.p).length());
      const size_t sides = s.planes.size() > 1 ? s.planes.size() : 0;
      const SurfacePoint& edge = sides > 0 ? *sample++ : face;
      if (is_on_surface(edge)) distance = std::min(distance, (edge.point - s.p).length());
      const bool at_face = face.residual <= std::min(edge.residual, kAtFace * voxel_);
      const bool at_edge = sides > 0 && !at_face;
      for (size_t i = 0; at_edge && i < sides; ++i) merge(s.planes, sample[i], s.side);
      merge(s.planes, at_edge ? edge : face, s.side);
      sample += sides;
      if (distance > before - kProgress * voxel_) s.done = ++s.vain > kVain;
    }
  }

  /// Only distances to sharp edges, whose tips the polygons lack, are found beyond the band.
  double beyond_band() const { return is_lower_bound_ ? kBeyondBand : 1; }

  bool is_on_surface(const SurfacePoint& point) const {
    return point.residual <= kOnSurface * voxel_;
  }

  const volume::BandBlock& block_;
  const SampledSurface& surface_;
  double voxel_;
  bool is_lower_bound_;
  double near_surface_;  ///< Residual from which one Newton step suffices, metres.
  SurfaceProjector projector_;
};

}  // namespace

volume::LevelSet exact_distances(const volume::LevelSet& level_set, const field::Field& exact,
                                 Progress& progress) {
  const double voxel = level_set.voxel(), band = level_set.background();
  if (!level_set.holds_solid()) return level_set;
  const SampledSurface surface(level_set, exact, progress);
  const auto distances = [&](const volume::BandBlock& block, std::vector<double>& found) {
    Box3d box;
    for (const Vec3d& p : block.points) box.extendBy(p);
    const double radius = 0.5 * box.size().length() + band + kMargin * voxel;
    const field::Field local = exact.restricted({box.center(), radius}).field;
    BlockSearch(block, local, voxel, surface).run(band, found);
  };
  return volume::with_distances(level_set, distances, progress);
}

}  // namespace vug::meshing
