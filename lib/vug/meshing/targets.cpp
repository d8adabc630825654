// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/crease.h>
#include <vug/meshing/polish_passes.h>
#include <vug/meshing/targets.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

constexpr double kBlock = 8;          ///< Edge of a block of points, voxels.
constexpr double kTolerance = 1e-4;   ///< Residual at which a vertex is on the surface, voxels.
constexpr double kSampled = 1e-3;     ///< Residual tolerance of a neighbouring sample, voxels.
constexpr double kGoodSample = 0.02;  ///< Samples further from the surface are not used, voxels.
constexpr double kBeyondCell = 0.5;   ///< Maximum distance of a crease from its cell, voxels.
constexpr int kRefinements = 2;
constexpr double kShrink = 0.2;  ///< Factor on the samples' distances, for curved creases.

class Finder {
 public:
  Finder(const FaceMesh& raw, double voxel, const PolygonizeOptions& options)
      : raw_(raw),
        voxel_(voxel),
        options_(options),
        crease_cosine_(maths::cos(options.crease_angle * kPi / 180)),
        reach_{options.max_move * voxel, kTolerance * voxel, 10},
        samples_reach_{options.max_move * voxel, kSampled * voxel, 10} {}

  BlockOptions blocks() const { return {kBlock * voxel_, (2 * options_.max_move + 1) * voxel_}; }

  /// Finds the surface near the centroid of each face, and its normal.
  void sample_faces(const field::Field& exact, const PolishPasses& passes, Progress& progress) {
    std::vector<Vec3d> centres(raw_.faces.size());
    for (size_t f = 0; f < centres.size(); ++f) centres[f] = raw_.centre(raw_.faces[f]);
    samples_.resize(centres.size());
    const PolishPass pass{
        1, exact, centres, blocks(),
        [&](uint32_t f, std::vector<double>& inputs) { add_numbers(centres[f], inputs); }};
    passes.run(
        pass,
        [&](const std::vector<uint32_t>& faces, const field::Field& local) {
          const std::vector<Vec3d> starts = gathered(centres, faces);
          const auto found = projector(local, starts).project(starts, samples_reach_);
          for (size_t i = 0; i < faces.size(); ++i) samples_[faces[i]] = found[i];
        },
        samples_, progress);
  }

  /// Adds all numbers on which the target of a vertex depends besides the field.
  void add_inputs(uint32_t v, std::vector<double>& inputs) const {
    add_numbers(raw_.points[v], inputs);
    if (!options_.creases) return;
    inputs.push_back(raw_.first[v + 1] - raw_.first[v]);
    for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i) {
      const SurfacePoint& sample = samples_[raw_.around[i]];
      add_numbers(sample.point, inputs);
      add_numbers(sample.normal, inputs);
      inputs.insert(inputs.end(), {sample.residual, sample.inside ? 1.0 : 0.0});
    }
  }

  /// Sets the targets of one block's vertices.
  void find(const std::vector<uint32_t>& vertices, const field::Field& local,
            std::vector<Target>& targets) const {
    const std::vector<Vec3d> starts = gathered(raw_.points, vertices);
    SurfaceProjector local_projector = projector(local, starts);
    const auto surface = local_projector.project(starts, reach_);
    std::vector<Crease> creases;
    for (size_t i = 0; i < vertices.size(); ++i) {
      targets[vertices[i]].surface = surface[i].point;
      if (options_.creases) add_crease(vertices[i], creases);
    }
    for (int i = 0; i < kRefinements; ++i) {
      refine(creases, local_projector);
      if (i == 0) drop_smooth(creases);
    }
    std::vector<Vec3d> places;
    for (const Crease& c : creases) {
      places.push_back(c.place);
      places.push_back(clamped(c.vertex, fit_planes(c.samples, c.middle)));
    }
    const auto found = local_projector.project(places, {0.25 * voxel_, kTolerance * voxel_, 10});
    for (size_t i = 0; i < creases.size(); ++i) {
      Target& target = targets[creases[i].vertex];
      target.crease = found[2 * i].point;
      target.alternative = found[2 * i + 1].point;
      target.has_crease = true;
    }
  }

 private:
  struct Crease {
    uint32_t vertex = 0;
    Vec3d middle;  ///< Centroid of the first samples.
    std::vector<SurfacePoint> samples;
    Vec3d place;  ///< The point that fits the samples' planes.
  };

  SurfaceProjector projector(const field::Field& local, const std::vector<Vec3d>& near) const {
    return {local, near, kLargestError * voxel_};
  }

  /// Adds a crease if the gradients at the faces around the vertex disagree.
  void add_crease(uint32_t v, std::vector<Crease>& creases) const {
    Crease crease;
    crease.vertex = v;
    for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i)
      if (samples_[raw_.around[i]].residual <= kGoodSample * voxel_)
        crease.samples.push_back(samples_[raw_.around[i]]);
    if (!disagree(crease.samples)) return;
    crease.middle = Vec3d(0);
    for (const SurfacePoint& s : crease.samples)
      crease.middle += s.point / static_cast<double>(crease.samples.size());
    crease.place = clamped(v, fit_planes(crease.samples, raw_.points[v]));
    creases.push_back(std::move(crease));
  }

  bool disagree(const std::vector<SurfacePoint>& samples) const {
    return samples.size() >= 2 && min_normal_dot(samples) <= crease_cosine_;
  }

  /// Takes new samples nearer to the crease points, and fits new points to them.
  void refine(std::vector<Crease>& creases, SurfaceProjector& local_projector) const {
    std::vector<Vec3d> starts;
    for (const Crease& c : creases)
      for (const SurfacePoint& s : c.samples)
        starts.push_back(c.place + (s.point - c.place) * kShrink);
    const auto found = local_projector.project(starts, samples_reach_);
    auto next = found.begin();
    for (Crease& c : creases) {
      for (SurfacePoint& s : c.samples) s = *next++;
      c.place = clamped(c.vertex, fit_planes(c.samples, raw_.points[c.vertex]));
    }
  }

  /// A rough but smooth surface appears creased from face to face. At a smaller distance its
  /// gradients agree; those next to a crease do not.
  void drop_smooth(std::vector<Crease>& creases) const {
    creases.erase(std::remove_if(creases.begin(), creases.end(),
                                 [&](const Crease& c) { return !disagree(c.samples); }),
                  creases.end());
  }

  /// Clamps x to within half a voxel of the vertex's cell and the reach of the vertex.
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

  const FaceMesh& raw_;
  double voxel_;
  const PolygonizeOptions& options_;
  double crease_cosine_;
  ProjectOptions reach_;
  ProjectOptions samples_reach_;
  std::vector<SurfacePoint> samples_;  ///< Per face.
};

}  // namespace

std::vector<Target> find_targets(const FaceMesh& raw, const field::Field& exact, double voxel,
                                 const PolygonizeOptions& options, const PolishPasses& passes,
                                 Progress& progress) {
  Finder finder(raw, voxel, options);
  if (options.creases) finder.sample_faces(exact, passes, progress);
  std::vector<Target> targets(raw.points.size());
  const PolishPass pass{
      2, exact, raw.points, finder.blocks(),
      [&](uint32_t v, std::vector<double>& inputs) { finder.add_inputs(v, inputs); }};
  passes.run(
      pass,
      [&](const std::vector<uint32_t>& vertices, const field::Field& local) {
        finder.find(vertices, local, targets);
      },
      targets, progress);
  return targets;
}

}  // namespace vug::meshing
