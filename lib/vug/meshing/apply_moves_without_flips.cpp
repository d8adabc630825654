// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/meshing/apply_moves_without_flips.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/folds.h>
#include <vug/meshing/polish_passes.h>

#include <algorithm>
#include <tuple>

namespace vug::meshing {
namespace {

constexpr uint8_t kSurface = 2;  ///< Levels 0 and 1 are the two crease targets,
constexpr uint8_t kStay = 5;     ///< the last is the original position.
constexpr int kRounds = 10;

using Corners = std::array<bool, 4>;  ///< Whether the triangle at the corner is valid.

bool can_be_cut(const Face& face, const Corners& good) {
  return face.size == 3 ? good[0] : (good[1] && good[3]) || (good[0] && good[2]);
}

class MoveSolver {
 public:
  MoveSolver(const FaceMesh& raw, const std::vector<Target>& targets, double voxel)
      : raw_(raw), targets_(targets), voxel_(voxel), level_(targets.size()) {
    points_.resize(targets.size());
    for (uint32_t v = 0; v < targets.size(); ++v)
      set_level(v, targets[v].has_crease ? uint8_t{0} : kSurface);
  }

  /// The currently folded polygons, ascending.
  std::vector<uint32_t> all_folded(const field::Field& exact, const PolishPasses& passes) const {
    std::vector<char> folded(raw_.faces.size());
    std::vector<Vec3d> centres(raw_.faces.size());
    for (size_t f = 0; f < centres.size(); ++f) centres[f] = raw_.centre(raw_.faces[f]);
    const PolishPass pass{
        3,
        exact,
        centres,
        {8 * voxel_, kSight * voxel_},
        [&](uint32_t f, std::vector<double>& inputs) { add_inputs(raw_.faces[f], inputs); }};
    passes.run(
        pass,
        [&](const std::vector<uint32_t>& faces, const field::Field& local) {
          SurfaceProjector projector(local, gathered(centres, faces), kLargestError * voxel_);
          const std::vector<char> found = are_folded(faces, projector);
          for (size_t i = 0; i < faces.size(); ++i) folded[faces[i]] = found[i];
        },
        folded, Progress::none());
    std::vector<uint32_t> list;
    for (uint32_t f = 0; f < folded.size(); ++f)
      if (folded[f]) list.push_back(f);
    return list;
  }

  /// Repairs the polygon if it is folded, and adds polygons that may fold as a result to `next`.
  void repair(uint32_t f, const field::Field& exact, std::vector<uint32_t>& next) {
    const Face& face = raw_.faces[f];
    const field::Field local = exact.restricted({raw_.centre(face), 2 * kSight * voxel_}).field;
    SurfaceProjector projector(local, {raw_.centre(face)}, kLargestError * voxel_);
    if (!is_folded(f, projector)) return;
    // The smallest step of one vertex that repairs it; among equals the one that folds the fewest
    // neighbours.
    using Choice = std::tuple<int, size_t, uint32_t>;  // Steps, folded neighbours, corner.
    Choice best{INT32_MAX, 0, 0};
    for (uint32_t k = 0; k < face.size; ++k) {
      const uint32_t v = face.corners[k];
      const uint8_t level = level_[v];
      for (int to = level + 1; to <= kStay; ++to) {
        set_level(v, static_cast<uint8_t>(to));
        if (is_folded(f, projector)) continue;
        best = std::min(best, Choice{to - level, folds_around(v, projector), k});
        break;
      }
      set_level(v, level);
    }
    const auto [steps, unused, corner] = best;
    for (uint32_t k = 0; k < face.size; ++k) {
      const uint32_t v = face.corners[k];
      const bool alone = steps != INT32_MAX;
      if ((alone && k != corner) || level_[v] == kStay) continue;
      set_level(v, static_cast<uint8_t>(level_[v] + (alone ? steps : 1)));
      next.insert(next.end(), raw_.around.begin() + raw_.first[v],
                  raw_.around.begin() + raw_.first[v + 1]);
    }
  }

  MoveResult result() && {
    MoveResult settled;
    settled.on_crease.resize(level_.size());
    for (uint32_t v = 0; v < level_.size(); ++v) {
      settled.on_crease[v] = level_[v] < kSurface;
      if (level_[v] != (targets_[v].has_crease ? 0 : kSurface)) ++settled.shortened_moves;
    }
    settled.points = std::move(points_);
    return settled;
  }

 private:
  /// Adds all numbers on which a fold of the face depends besides the field.
  void add_inputs(const Face& face, std::vector<double>& inputs) const {
    inputs.push_back(face.size);
    for (uint32_t k = 0; k < face.size; ++k) {
      const uint32_t v = face.corners[k];
      add_numbers(raw_.points[v], inputs);
      add_numbers(points_[v], inputs);
      inputs.push_back(targets_[v].has_crease ? 1 : 0);
    }
  }

  static constexpr double kSight =
      4;  ///< Distance from a polygon within which the field is evaluated, voxels.

  void set_level(uint32_t v, uint8_t level) {
    constexpr double kShare[] = {0, 0, 1, 0.5, 0.25, 0};
    level_[v] = level;
    const Vec3d& from = raw_.points[v];
    points_[v] = level == 0   ? targets_[v].crease
                 : level == 1 ? targets_[v].alternative
                              : from + (targets_[v].surface - from) * kShare[level];
  }

  /// Per face: whether every triangulation of the polygon contains a triangle that flipped or, at a
  /// crease, faces backwards.
  std::vector<char> are_folded(const std::vector<uint32_t>& faces,
                               SurfaceProjector& projector) const {
    std::vector<Vec3d> centroids;
    std::vector<Corners> good(faces.size());
    for (size_t i = 0; i < faces.size(); ++i) {
      const Face& face = raw_.faces[faces[i]];
      for (uint32_t k = 0; k < face.size; ++k)
        good[i][k] = !is_flipped(face, k, raw_.points, points_);
      if (needs_field(face, good[i]))
        for (uint32_t k = 0; k < face.size; ++k)
          if (good[i][k]) centroids.push_back(corner_centroid(face, k, points_));
    }
    const std::vector<SurfacePoint> answers = projector.sample(centroids);
    std::vector<char> folded(faces.size());
    auto answer = answers.begin();
    for (size_t i = 0; i < faces.size(); ++i) {
      const Face& face = raw_.faces[faces[i]];
      if (needs_field(face, good[i]))
        for (uint32_t k = 0; k < face.size; ++k)
          if (good[i][k]) good[i][k] = !faces_backwards(face, k, points_, *answer++, voxel_);
      folded[i] = !can_be_cut(face, good[i]);
    }
    return folded;
  }

  bool needs_field(const Face& face, const Corners& good) const {
    if (!can_be_cut(face, good)) return false;
    for (uint32_t k = 0; k < face.size; ++k)
      if (targets_[face.corners[k]].has_crease) return true;
    return false;
  }

  bool is_folded(uint32_t f, SurfaceProjector& projector) const {
    return are_folded({f}, projector)[0];
  }

  size_t folds_around(uint32_t v, SurfaceProjector& projector) const {
    const std::vector<char> folded = are_folded(
        {raw_.around.begin() + raw_.first[v], raw_.around.begin() + raw_.first[v + 1]}, projector);
    return static_cast<size_t>(std::count(folded.begin(), folded.end(), 1));
  }

  const FaceMesh& raw_;
  const std::vector<Target>& targets_;
  double voxel_;
  std::vector<uint8_t> level_;
  std::vector<Vec3d> points_;
};

}  // namespace

MoveResult apply_moves_without_flips(const FaceMesh& raw, const std::vector<Target>& targets,
                                     const field::Field& exact, double voxel,
                                     const PolishPasses& passes, const Progress& progress) {
  MoveSolver solver(raw, targets, voxel);
  std::vector<uint32_t> folded = solver.all_folded(exact, passes);
  for (int round = 0; round < kRounds && !folded.empty(); ++round) {
    std::vector<uint32_t> next;
    for (const uint32_t f : folded) {
      progress.check();  // A round can take seconds, because each repair restricts the field.
      solver.repair(f, exact, next);
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    folded = std::move(next);
  }
  return std::move(solver).result();
}

}  // namespace vug::meshing
