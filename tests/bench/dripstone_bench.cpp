// SPDX-License-Identifier: Apache-2.0
// A chamber of 24 m with thousands of speleothems as a level set, compared with the bare chamber by
// the processor time for each active voxel, and the time of its drip graph. The least of the rounds
// counts. --voxel METRES sets the voxels (0.1), --rounds N the number of rounds (3), --only NAME
// restricts the rows to the bare chamber and this one.
#include "arguments.h"

#include <vug/field/deferred.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/shot/drips_plan.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>

namespace {

using namespace vug;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A hall with walls of 1 m, roughened by 25 cm.
field::Field chamber() {
  const field::Field walls = field::make(
      "difference", {{"base", field::as_value(field::make("box", {{"size", Vec3d(26, 8, 26)}}))},
                     {"cuts", List{field::as_value(field::make(
                                  "box", {{"size", Vec3d(24, 5, 24)}, {"rounding", 1.0}}))}}});
  return field::make(
      "displace",
      {{"field", field::as_value(walls)},
       {"noise", field::as_value(field::make_noise("fbm", {{"scale", 1.2}, {"octaves", 5}}))},
       {"amount", 0.25}});
}

shot::DripParams drips_in(const field::Field& rock) {
  shot::DripParams p;
  p.field = rock;
  p.from = Vec3d(-12, -3.5, -12), p.to = Vec3d(12, 3.5, 12);
  p.spacing = 0.39, p.density = 1, p.age = 8000, p.tip = 0.022;
  return p;
}

field::Field with_forms(const shot::DripParams& params) {
  return shot::with_speleothems(std::make_shared<const shot::DripsPlan>(params), {.root = 0.15});
}

struct Options {
  double voxel = 0.1;
  int rounds = 3;
  std::string only;
};

struct Row {
  double nanoseconds = 0;  ///< Processor time for each active voxel.
  uint64_t active = 0;
};

Row measure(const field::Field& field, const Options& o) {
  volume::VoxelizeOptions options;
  options.voxel = o.voxel;
  Row out{kInfinity, 0};
  for (int i = 0; i < o.rounds; ++i) {
    const double start = processor_seconds();
    out.active = volume::voxelize(field, options).statistics().active_voxels;
    out.nanoseconds = std::min(
        out.nanoseconds, 1e9 * (processor_seconds() - start) / static_cast<double>(out.active));
  }
  return out;
}

/// False for unknown options and values out of range.
bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) return false;
    if (name == "--only")
      options.only = argv[i + 1];
    else if (!(name == "--voxel"    ? bench::read_number(argv[i + 1], 0.02, 1.0, options.voxel)
               : name == "--rounds" ? bench::read_number(argv[i + 1], 1, 1000, options.rounds)
                                    : false))
      return false;
  }
  return true;
}

void print_graph(const shot::DripParams& params) {
  const double used = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  const shot::DripsPlan plan(params);
  const size_t nodes = plan.graph().nodes.size();
  const double graph = processor_seconds() - used;
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const size_t forms = plan.grown().forms.size();
  fmt::print("{} nodes, {} forms: graph {:.2f} s ({:.2f} s of processor time), forms {:.2f} s\n",
             nodes, forms, wall, graph, processor_seconds() - used - graph);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    fmt::print(stderr,
               "usage: bench_dripstone [--voxel METRES (0.02 to 1)] [--rounds N (1 to 1000)] "
               "[--only ROW]\n");
    return 2;
  }
  const field::Field rock = chamber();
  const shot::DripParams params = drips_in(rock);
  if (options.only.empty()) print_graph(params);
  const Row bare = measure(rock, options);
  const auto print = [](const std::string& name, const Row& row, const Row& base) {
    fmt::print("{:24} {:10} active voxels {:9.1f} ns {:6.2f} bare\n", name, row.active,
               row.nanoseconds, row.nanoseconds / base.nanoseconds);
    std::fflush(stdout);
  };
  print("bare", bare, bare);
  const std::pair<const char*, std::function<field::Field()>> rows[] = {
      {"popcorn",
       [&] {
         return field::make("popcorn", {{"field", field::as_value(rock)},
                                        {"from", Vec3d(-12.5, -1.5, -12.5)},
                                        {"to", Vec3d(12.5, 0, -10)},
                                        {"diameter", 0.05},
                                        {"stalk", 0.025},
                                        {"spacing", 0.08}});
       }},
      {"without flowstone",
       [&] {
         shot::DripParams p = params;
         p.flowstone = 0;
         return with_forms(p);
       }},
      {"decorated", [&] { return with_forms(params); }}};
  for (const auto& [name, make] : rows)
    if (options.only.empty() || options.only == name) {
      const field::Field field = make();
      Progress silent;
      field::compute_deferred(field, silent);
      print(name, measure(field, options), bare);
    }
  return 0;
}
