// SPDX-License-Identifier: Apache-2.0
// Ten thousand legs of passages as a level set, compared with a thousand spheres (union_bench.cpp)
// by the time for each active voxel. Prints a table; --rounds N sets the number of rounds, of which
// the fastest counts, and --voxel METRES the voxels of the passages.
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/passages/passages.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

using namespace vug;

field::Field spheres() {
  RandomStream random(RandomKey(1).at("union bench"));
  std::vector<field::Field> fields;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(0, 400), y = random.uniform(0, 400), z = random.uniform(0, 400);
    fields.push_back(field::transformed(field::make("sphere", {{"radius", random.uniform(15, 25)}}),
                                        Transform::translation(Vec3d(x, y, z))));
  }
  return field::unite(fields);
}

/// Branching walks of 10 m legs in a box that holds them loosely.
network::Network cave(int legs) {
  RandomStream random(RandomKey(2).at("passages bench"));
  network::Network out;
  out.stations.emplace_back();
  double heading = 0;
  for (int i = 0; i < legs; ++i) {
    const bool branch = i > 0 && random.uniform() < 0.1;
    const size_t from = branch ? random.below(static_cast<uint32_t>(i)) : out.stations.size() - 1;
    heading += random.uniform(-0.5, 0.5) * (branch ? 6 : 1);
    const double dip = random.uniform(-0.3, 0.3);
    network::Station station;
    station.position =
        out.stations[from].position +
        Vec3d(std::cos(heading) * std::cos(dip), std::sin(dip), std::sin(heading) * std::cos(dip)) *
            10.0;
    network::CrossSection walls;
    walls.left = walls.right = 1 + random.uniform();
    walls.up = walls.down = 1 + random.uniform();
    station.section = walls;
    network::Leg leg;
    leg.from = static_cast<int>(from);
    leg.to = static_cast<int>(out.stations.size());
    out.stations.push_back(station);
    out.legs.push_back(leg);
  }
  return out;
}

void report(const std::string& name, const field::Field& field, double voxel, int rounds) {
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  double best = 1e9, best_cpu = 1e9;
  uint64_t active = 0;
  for (int i = 0; i < rounds; ++i) {
    const std::clock_t used = std::clock();
    const auto start = std::chrono::steady_clock::now();
    active = volume::voxelize(field, options).statistics().active_voxels;
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    best_cpu = std::min(best_cpu, static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
  }
  const auto voxels = static_cast<double>(active);
  fmt::print("{:24} {:9.3f} s {:9.3f} s cpu {:11} active voxels {:8.1f} ns cpu per voxel\n", name,
             best, best_cpu, active, 1e9 * best_cpu / voxels);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 3;
  double voxel = 0.5;
  for (int i = 1; i + 1 < argc; ++i) {
    if (!std::strcmp(argv[i], "--rounds")) rounds = std::max(1, std::atoi(argv[i + 1]));
    if (!std::strcmp(argv[i], "--voxel")) voxel = std::max(0.05, std::atof(argv[i + 1]));
  }
  report("1000 spheres", spheres(), 1, rounds);
  const network::Network network = cave(10000);
  passages::PassageOptions tubes;
  tubes.rules = {};
  report("10000 legs, tubes", passages::passages(network, tubes), voxel, rounds);
  passages::PassageOptions straight = tubes;
  straight.smooth = false;
  report("10000 legs, not smooth", passages::passages(network, straight), voxel, rounds);
  return 0;
}
