// SPDX-License-Identifier: Apache-2.0
// A thousand spheres united into one level set: the field expression compared with OpenVDB's
// method, which builds the operand grids in parallel and unites them with csgUnion one after the
// other. Both run alternately in this process; the best round counts. Prints a table with the
// processor time for each active voxel (as bench_passages does), or JSON with --json.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>

namespace {

using namespace vug;

struct Ball {
  Vec3d center;
  double radius;
};

std::vector<Ball> balls(uint64_t seed, double edge) {
  RandomStream random(RandomKey(seed).at("union bench"));
  std::vector<Ball> out;
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge);
    const double z = random.uniform(0, edge);
    out.push_back({Vec3d(x, y, z), random.uniform(15, 25)});
  }
  return out;
}

field::Field union_of(const std::vector<Ball>& all) {
  std::vector<field::Field> fields;
  for (const Ball& b : all)
    fields.push_back(field::transformed(field::make("sphere", {{"radius", b.radius}}),
                                        Transform::translation(b.center)));
  return field::unite(fields);
}

constexpr double kEndless = 1e9;

/// Wall time and processor time of all threads; the minimum of each over the rounds.
struct Time {
  double wall = kEndless, cpu = kEndless;
};

template <class Work>
void measure(Time& best, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t used = std::clock();
  work();
  best.cpu = std::min(best.cpu, static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
  best.wall = std::min(
      best.wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

openvdb::FloatGrid::Ptr openvdb_union(const std::vector<Ball>& all) {
  std::vector<openvdb::FloatGrid::Ptr> grids(all.size());
  parallel_for(all.size(), [&](size_t i) {
    const Ball& b = all[i];
    grids[i] = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
        static_cast<float>(b.radius),
        openvdb::Vec3f(openvdb::Vec3d(b.center.x, b.center.y, b.center.z)), 1.0f, 3.0f);
  });
  for (size_t i = 1; i < grids.size(); ++i) openvdb::tools::csgUnion(*grids[0], *grids[i]);
  return grids[0];
}

struct Result {
  std::string name;
  Time ours, morph, raw, peer;  // raw: the morph without repair; peer: infinite if it did not run
  uint64_t active = 0, peer_active = 0;
};

Result run(const std::string& name, double edge, int rounds, bool peer) {
  const std::vector<Ball> first = balls(1, edge), second = balls(2, edge);
  volume::VoxelizeOptions options;
  options.voxel = 1;
  Result out;
  out.name = name;
  for (int round = 0; round < rounds; ++round) {
    const auto one = [&] {
      const volume::LevelSet grid = volume::voxelize(union_of(first), options);
      if (round == 0) out.active = grid.statistics().active_voxels;
    };
    const auto two = [&] {
      volume::voxelize(field::morph(union_of(first), union_of(second), 0.5), options);
    };
    if (round == 0) one();  // counts voxels and warms up the allocator
    measure(out.ours, [&] { volume::voxelize(union_of(first), options); });
    measure(out.morph, two);
    volume::VoxelizeOptions raw = options;
    raw.repair = false;
    measure(out.raw,
            [&] { volume::voxelize(field::morph(union_of(first), union_of(second), 0.5), raw); });
    if (peer && round < 2)
      measure(out.peer, [&] { out.peer_active = openvdb_union(first)->activeVoxelCount(); });
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  bool json = false, peer = true;
  for (int i = 1; i < argc; ++i) {
    json = json || !std::strcmp(argv[i], "--json");
    if (!std::strcmp(argv[i], "--no-peer")) peer = false;
  }
  openvdb::initialize();
  const Result results[] = {run("spread, 400^3", 400, 9, peer),
                            run("crowded, 200^3", 200, 9, peer)};
  if (!json)
    fmt::print("{:15} {:>8} {:>9} {:>7} {:>7} {:>7} {:>7} {:>11} {:>7} {:>11} {:>9}\n",
               "1000 spheres", "ours s", "openvdb s", "ratio", "by cpu", "morph", "by cpu",
               "unrepaired", "by cpu", "active", "ns/voxel");
  for (const Result& r : results) {
    const bool ran = r.peer.wall < kEndless;
    const double ratio = ran ? r.peer.wall / r.ours.wall : 0;
    const double ratio_cpu = ran ? r.peer.cpu / r.ours.cpu : 0;
    const double seconds = ran ? r.peer.wall : 0;
    const double morph = r.morph.wall / r.ours.wall, morph_cpu = r.morph.cpu / r.ours.cpu;
    const double each = 1e9 * r.ours.cpu / static_cast<double>(r.active);
    const double raw = r.raw.wall / r.ours.wall, raw_cpu = r.raw.cpu / r.ours.cpu;
    if (json)
      fmt::print(
          "{{\"case\": \"{}\", \"seconds\": {:.4f}, \"openvdb_seconds\": {:.4f}, \"ratio\": "
          "{:.1f}, \"ratio_cpu\": {:.1f}, \"morph_ratio\": {:.2f}, \"morph_ratio_cpu\": {:.2f}, "
          "\"raw_morph_ratio\": {:.2f}, \"raw_morph_ratio_cpu\": {:.2f}, \"active_voxels\": {}, "
          "\"openvdb_active_voxels\": {}, \"cpu_nanoseconds_per_voxel\": {:.1f}}}\n",
          r.name, r.ours.wall, seconds, ratio, ratio_cpu, morph, morph_cpu, raw, raw_cpu, r.active,
          r.peer_active, each);
    else
      fmt::print(
          "{:15} {:8.4f} {:9.4f} {:7.1f} {:7.1f} {:7.2f} {:7.2f} {:11.2f} {:7.2f} {:11} {:9.1f}\n",
          r.name, r.ours.wall, seconds, ratio, ratio_cpu, morph, morph_cpu, raw, raw_cpu, r.active,
          each);
  }
  return 0;
}
