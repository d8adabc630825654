// SPDX-License-Identifier: Apache-2.0
// Cells from end to end: scattered, relaxed, linked, rewritten and written as points, with the
// memory used; then read back and compared. Prints a table.
//   bench_cells_whole [millions]      default: 10
#include "peak_memory.h"

#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/cells/build.h>
#include <vug/cells/kind.h>
#include <vug/cells/rule.h>
#include <vug/cells/to_points.h>
#include <vug/mesh/shapes.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace {

using namespace vug;
using namespace vug::cells;

constexpr int kSteps = 100;
constexpr int kRelax = 10;

template <class Work>
void stage(const char* name, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t used = std::clock();
  work();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  fmt::print("{:28} {:7.1f} s, {:6.1f} s of processor time; holds {}, peak so far {}\n", name,
             wall.count(), static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC,
             bytes_text(static_cast<double>(resident_memory())), bytes_text(peak_memory()));
  std::fflush(stdout);
}

Stage rule(const std::string& name, const NamedValues& parameters = {}, int steps = -1,
           int begin = 0) {
  return {make_product(rules(), name, parameters), name, begin, steps, {}};
}

/// Prints the largest errors of a position and of a normal.
void compare(const volume::Points& is, const volume::Points& was, double voxel) {
  const auto& id = is.values<int32_t>("id");
  const auto &n = is.values<Vec3f>("N"), &m = was.values<Vec3f>("N");
  double off = 0, turn = 0;
  for (size_t k = 0; k < id.size(); ++k) {
    const auto i = static_cast<size_t>(id[k]);
    const Vec3d d = Vec3d(is.position[k]) - Vec3d(was.position[i]);
    off = std::max({off, std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    turn = std::max(turn, Vec3d(n[k]).cross(Vec3d(m[i])).length() / Vec3d(n[k]).length());
  }
  fmt::print(
      "read back: places off by at most {:.2f} of half a voxel / 65535 and 2^-23 m, normals by "
      "{:.4f} degrees\n",
      off / (voxel * 0.5 / 65535 + 0x1p-23), turn * 180 / kPi);
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 10;
  const ScratchFolder scratch("vug_bench");
  const std::filesystem::path file = scratch.file("cells.vdb");
  BuildOptions options;
  options.grid = make_product(grids(), "random");
  options.relax = kRelax;
  NetworkPtr network;
  stage("scattered, relaxed, linked", [&] {
    const Surface ball({std::make_shared<const mesh::Mesh>(mesh::sphere_mesh(Vec3d(0), 1, 7))});
    options.spacing = std::sqrt(estimate(ball, options.grid, 1) / (millions * 1e6));
    network = std::make_shared<const Network>(build(ball, options).network);
  });
  fmt::print("{} cells\n", network->size());
  Simulation simulation(network, RandomKey(1));
  stage("100 steps", [&] {
    simulation.run(
        {rule("random_color", {{"share", 0.001}}, 1), rule("voronoi"), rule("crack", {}, -1, 40),
         rule("sprinkle", {{"attribute", "v"}, {"share", 0.02}}, 1), rule("gray_scott")},
        kSteps);
  });
  const double voxel = voxel_of_points(*network);
  stage("written with all attributes", [&] {
    volume::write(file, {volume::point_grid(to_points(simulation), voxel).named("cells")});
  });
  const auto each = [&] {
    return static_cast<double>(std::filesystem::file_size(file)) /
           static_cast<double>(network->size());
  };
  fmt::print("peak of scatter to file: {}; {:.1f} bytes a point\n", bytes_text(peak_memory()),
             each());
  volume::Points points = to_points(simulation);
  std::erase_if(points.attributes, [](const volume::PointAttribute& a) {
    return a.name != "N" && a.name != "Cd" && a.name != "pscale" && a.name != "id";
  });
  volume::write(file, {volume::point_grid(points, voxel).named("cells")});
  fmt::print("with P, N, Cd, pscale and id alone: {:.1f} bytes a point\n", each());
  stage("read back", [&] { compare(volume::read_points(file), points, voxel); });
  return 0;
}
