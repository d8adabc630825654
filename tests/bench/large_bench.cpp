// SPDX-License-Identifier: Apache-2.0
// Throughput and memory as functions of the grid size: ten thousand solids of every bounded kind,
// rotated and displaced by noise, at about 10 and 100 million active voxels. Each size runs in a
// process of its own, so that the peak memory (VmHWM) belongs to it alone.
#include "peak_memory.h"

#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace vug;

/// Kinds whose defaults yield a bounded solid, about 1 m in size.
std::vector<field::Field> samples() {
  std::vector<field::Field> out;
  for (const field::FieldKind* kind : field::primitives()) {
    Diagnostics diagnostics;
    const std::optional<field::Field> solid = kind->make({}, {}, diagnostics);
    if (!solid || !is_finite(solid->bounds())) continue;
    const double size = solid->bounds().size().length();
    out.push_back(field::transformed(*solid, Transform::scaling(Vec3d(1.7 / size))));
  }
  return out;
}

field::Field solid() {
  const std::vector<field::Field> kinds = samples();
  RandomStream random(RandomKey(3).at("large bench"));
  std::vector<field::Field> all;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(0, 20), y = random.uniform(0, 20), z = random.uniform(0, 20);
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
    const Transform turn = Transform::rotation({u, v, 0.5}, random.uniform(0, 6));
    const field::Field& kind = kinds[random.below(static_cast<uint32_t>(kinds.size()))];
    all.push_back(field::transformed(kind, Transform::translation({x, y, z}) * turn));
  }
  field::Displacement rough;
  rough.amount = 0.02;
  return field::displaced(field::unite(all), field::make_noise("fbm"), rough);
}

void run(double target, bool json) {
  const field::Field field = solid();
  const double before = peak_memory();  // libraries and the expression
  volume::VoxelizeOptions options;
  options.voxel = 0.12;  // the size of the target grid is extrapolated from a coarse one
  const auto coarse = volume::voxelize(field, options).statistics().active_voxels;
  options.voxel *= std::sqrt(static_cast<double>(coarse) / target);
  const auto start = std::chrono::steady_clock::now();
  const volume::LevelSet grid = volume::voxelize(field, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double peak = peak_memory();
  const volume::VoxelizeEstimate estimate = volume::estimate(field, options);
  const volume::Statistics s = grid.statistics();
  const auto active = static_cast<double>(s.active_voxels),
             bytes = static_cast<double>(s.memory_bytes);
  if (json)
    fmt::print(
        "{{\"active_voxels\": {}, \"leaves\": {}, \"seconds\": {:.3f}, \"voxels_per_second\": "
        "{:.4g}, \"grid_bytes\": {}, \"peak_bytes\": {:.0f}, \"peak_ratio\": {:.3f}, "
        "\"bytes_before\": {:.0f}, \"estimated_bytes\": {:.0f}}}\n",
        s.active_voxels, s.leaves, seconds, active / seconds, s.memory_bytes, peak, peak / bytes,
        before, estimate.bytes);
  else
    fmt::print(
        "{:12} active {:9} leaves {:8.2f} s {:7.2f} M voxels/s   grid {:7.1f} MB   peak {:7.1f} MB "
        "= {:.2f} grids ({:.1f} MB before)   estimated {:7.1f} MB\n",
        s.active_voxels, s.leaves, seconds, 1e-6 * active / seconds, 1e-6 * bytes, 1e-6 * peak,
        peak / bytes, 1e-6 * before, 1e-6 * estimate.bytes);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  bool json = false;
  std::vector<double> targets;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--json")
      json = true;
    else
      targets.push_back(std::strtod(argv[i], nullptr));
  if (targets.empty()) targets = {1e7, 1e8};
  for (const double target : targets) {
    const pid_t child = fork();
    if (child == 0) {
      run(target, json);
      std::_Exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) return 1;
  }
  return 0;
}
