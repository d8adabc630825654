// SPDX-License-Identifier: Apache-2.0
// Legs of passages as a level set, compared with a thousand spheres (union_bench.cpp) by the
// processor time for each active voxel. Each row is a process of its own: its first round pays for
// new pages of memory, the fastest of the following ones reuses them. --voxel METRES sets the
// voxels of the passages (0.5), --legs N their number (at 0.5 m ten thousand; at smaller voxels so
// many that the number of active voxels is that of the spheres), --rounds N the number of rounds
// after the first (3).
#include "arguments.h"

#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/passages/passages.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

/// Processor time for each active voxel, in nanoseconds.
struct Times {
  double first = 0, best = 0;
  uint64_t active = 0;
};

Times measure(const field::Field& field, double voxel, int rounds) {
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  Times out;
  for (int i = 0; i <= rounds; ++i) {
    const std::clock_t used = std::clock();
    out.active = volume::voxelize(field, options).statistics().active_voxels;
    const double each = 1e9 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC /
                        static_cast<double>(out.active);
    if (i == 0) out.first = each;
    out.best = i < 2 ? each : std::min(out.best, each);
  }
  return out;
}

/// Measures a field in a new process. False if that fails.
template <class MakeField>
bool measure_alone(const MakeField& make, double voxel, int rounds, Times& out) {
  void* shared =
      mmap(nullptr, sizeof(Times), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return false;
  const pid_t child = fork();
  if (child == 0) {
    *static_cast<Times*>(shared) = measure(make(), voxel, rounds);
    std::_Exit(0);
  }
  int status = 1;
  if (child > 0) waitpid(child, &status, 0);
  out = *static_cast<Times*>(shared);
  munmap(shared, sizeof(Times));
  return status == 0;
}

struct Options {
  double voxel = 0.5;
  int legs = 0;  // 0: as many as have the active voxels of the spheres.
  int rounds = 3;
};

/// False for unknown options and values out of range.
bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    const bool good =
        i + 1 < argc &&
        (name == "--voxel"    ? bench::read_number(argv[i + 1], 0.05, 1.0, options.voxel)
         : name == "--legs"   ? bench::read_number(argv[i + 1], 1, 1000000, options.legs)
         : name == "--rounds" ? bench::read_number(argv[i + 1], 1, 1000, options.rounds)
                              : false);
    if (!good) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    fmt::print(stderr,
               "usage: bench_passages [--voxel METRES (0.05 to 1)] [--legs N (1 to 1000000)] "
               "[--rounds N (1 to 1000)]\n");
    return 2;
  }
  const int legs = options.legs > 0
                       ? options.legs
                       : static_cast<int>(std::lround(40000 * options.voxel * options.voxel));
  const auto passages_of = [&](bool smooth) {
    passages::PassageOptions tubes;
    tubes.rules = {};
    tubes.smooth = smooth;
    return passages::passages(cave(legs), tubes);
  };
  Times base, row;
  if (!measure_alone(spheres, 1, options.rounds, base)) return 1;
  const auto print = [&](const std::string& name) {
    fmt::print(
        "{:22} {:11} active voxels   first {:6.1f} ns {:5.2f} spheres   best {:6.1f} ns {:5.2f} "
        "spheres\n",
        name, row.active, row.first, row.first / base.first, row.best, row.best / base.best);
    std::fflush(stdout);
  };
  row = base;
  print("1000 spheres");
  for (const bool smooth : {true, false}) {
    const auto make = [&] { return passages_of(smooth); };
    if (!measure_alone(make, options.voxel, options.rounds, row)) return 1;
    print(fmt::format("{} legs, {}", legs, smooth ? "curved" : "straight"));
  }
  return 0;
}
