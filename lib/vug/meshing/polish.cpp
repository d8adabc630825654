#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/crease.h>
#include <vug/meshing/polish.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

constexpr double kBlock = 8;          ///< Edge of a block of points, voxels.
constexpr double kTolerance = 1e-5;   ///< Residual at which a projection is done, voxels.
constexpr double kGoodSample = 0.02;  ///< Samples further from the surface are not used, voxels.
constexpr double kBeyondCell = 0.5;   ///< How far a crease may lie outside its cell, voxels.
constexpr int kRefinements = 2;
constexpr double kShrink = 0.2;  ///< Of the samples' distances, for curved creases.
constexpr uint8_t kStay = 4;     ///< Level of a vertex that is back where it was.

/// Both places a vertex may go to: the crease if there is one, and the nearest surface.
struct Target {
  Vec3d crease;
  Vec3d surface;
  bool has_crease = false;
};

class Polisher {
 public:
  Polisher(const FaceMesh& raw, double voxel, const PolygonizeOptions& options)
      : raw_(raw),
        voxel_(voxel),
        options_(options),
        crease_cosine_(maths::cos(options.crease_angle * kPi / 180)),
        reach_{options.max_move * voxel, kTolerance * voxel, 10} {}

  void sample_faces(const field::Field& exact, Progress& progress) {
    std::vector<Vec3d> centres(raw_.faces.size());
    for (size_t f = 0; f < centres.size(); ++f) centres[f] = raw_.centre(raw_.faces[f]);
    samples_.resize(centres.size());
    for_each_in_blocks(
        exact, centres, blocks(),
        [&](uint32_t f, const field::Field& local) {
          samples_[f] = project(local, centres[f], reach_);
        },
        progress);
  }

  void find_targets(const field::Field& exact, Progress& progress) {
    targets_.resize(raw_.points.size());
    for_each_in_blocks(
        exact, raw_.points, blocks(),
        [&](uint32_t v, const field::Field& local) { targets_[v] = target(v, local); }, progress);
  }

  /// Moves all vertices, then takes back, in steps, those whose polygons fold by it.
  Polished move() const {
    std::vector<uint8_t> level(raw_.points.size());
    Polished result;
    result.points.resize(level.size());
    for (size_t v = 0; v < level.size(); ++v) level[v] = targets_[v].has_crease ? 0 : 1;
    const std::vector<uint8_t> wanted = level;
    std::vector<char> folded(raw_.faces.size());
    for (int round = 0; round < 2 * kStay; ++round) {
      for (uint32_t v = 0; v < level.size(); ++v) result.points[v] = place(v, level[v]);
      parallel_for(
          folded.size(), [&](size_t f) { folded[f] = folds(raw_.faces[f], result.points); }, 1024);
      bool changed = false;
      for (uint32_t v = 0; v < level.size(); ++v) {
        bool back = false;
        for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i)
          back = back || folded[raw_.around[i]];
        if (!back || level[v] == kStay) continue;
        ++level[v];
        changed = true;
      }
      if (!changed) break;
    }
    result.on_crease.resize(level.size());
    for (uint32_t v = 0; v < level.size(); ++v) {
      result.on_crease[v] = level[v] == 0;
      if (level[v] != wanted[v]) ++result.backed_off;
    }
    return result;
  }

 private:
  BlockOptions blocks() const { return {kBlock * voxel_, (2 * options_.max_move + 1) * voxel_}; }

  Target target(uint32_t v, const field::Field& local) const {
    Target target;
    target.surface = project(local, raw_.points[v], reach_).point;
    if (!options_.creases) return target;
    std::vector<SurfacePoint> samples;
    for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i)
      if (samples_[raw_.around[i]].residual <= kGoodSample * voxel_)
        samples.push_back(samples_[raw_.around[i]]);
    if (samples.size() < 2 || least_agreement(samples) > crease_cosine_) return target;
    Vec3d x = clamped(v, fit_planes(samples));
    for (int i = 0; i < kRefinements; ++i) {
      for (SurfacePoint& s : samples) s = project(local, x + (s.point - x) * kShrink, reach_);
      x = clamped(v, fit_planes(samples));
    }
    const ProjectOptions close{0.25 * voxel_, kTolerance * voxel_, 10};
    target.crease = clamped(v, project(local, x, close).point);
    target.has_crease = true;
    return target;
  }

  /// x kept within half a voxel of the vertex's cell and within reach of the vertex.
  Vec3d clamped(uint32_t v, Vec3d x) const {
    const Vec3d& from = raw_.points[v];
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor(from[axis] / voxel_);
      x[axis] =
          std::clamp(x[axis], (cell - kBeyondCell) * voxel_, (cell + 1 + kBeyondCell) * voxel_);
    }
    const double length = (x - from).length();
    return length > reach_.reach ? from + (x - from) * (reach_.reach / length) : x;
  }

  Vec3d place(uint32_t v, uint8_t level) const {
    if (level == 0) return targets_[v].crease;
    constexpr double kShare[] = {0, 1, 0.5, 0.25, 0};
    const Vec3d& from = raw_.points[v];
    return from + (targets_[v].surface - from) * kShare[level];
  }

  /// Whether both ways to cut the polygon give a triangle that turned over by the move.
  bool folds(const Face& face, const std::vector<Vec3d>& points) const {
    constexpr double kLeastArea = 1e-4;
    std::array<bool, 4> good{};
    for (uint32_t k = 0; k < face.size; ++k) {
      const Vec3d before = corner_normal(face, k, raw_.points);
      good[k] = corner_normal(face, k, points).dot(before) > kLeastArea * before.length2();
    }
    return face.size == 4 ? !(good[1] && good[3]) && !(good[0] && good[2]) : !good[0];
  }

  const FaceMesh& raw_;
  double voxel_;
  const PolygonizeOptions& options_;
  double crease_cosine_;
  ProjectOptions reach_;
  std::vector<SurfacePoint> samples_;  ///< By face: on the surface, near its middle.
  std::vector<Target> targets_;        ///< By vertex.
};

}  // namespace

Polished polish(const FaceMesh& raw, const field::Field& exact, double voxel,
                const PolygonizeOptions& options, Progress& progress) {
  Polisher polisher(raw, voxel, options);
  if (options.creases) polisher.sample_faces(exact, progress);
  polisher.find_targets(exact, progress);
  return polisher.move();
}

}  // namespace vug::meshing
