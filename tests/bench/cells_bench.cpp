// SPDX-License-Identifier: Apache-2.0
// Cells: the speed of building a network, and the speed of rules relative to the memory bandwidth.
// The bound is the number of bytes that a step must move (links, attributes read and written) at
// the speed of a triad, a[i] = b[i] + s * c[i], which is measured in alternation with the rules.
// Prints a table. "By cpu" is the same ratio from the processor time of all threads, for machines
// with other load.
//   bench_cells [millions...]      default: 1 10
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/cells/build.h>
#include <vug/cells/frames.h>
#include <vug/cells/kind.h>
#include <vug/cells/link.h>
#include <vug/cells/rule.h>
#include <vug/cells/scatter_cells.h>
#include <vug/cells/simulation.h>
#include <vug/mesh/shapes.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace {

using namespace vug;
using namespace vug::cells;

constexpr int kRounds = 25;

/// Wall-clock seconds, and processor seconds per core; the minimum of each.
struct Time {
  double wall = 1e9, cpu = 1e9;

  template <class Work>
  void measure(const Work& work, double share = 1) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    work();
    const double spent = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
    cpu = std::min(cpu, spent / thread_count() * share);
    wall = std::min(
        wall,
        share * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
};

/// Moves bytes, 24 for each element as STREAM counts them.
class Triad {
 public:
  Triad() : a_(kCount), b_(kCount, 1), c_(kCount, 2) {}
  void measure(Time& best, double bytes) {
    const auto work = [&] {
      parallel_for(kCount / kPart, [&](size_t part) {
        for (size_t i = part * kPart; i < (part + 1) * kPart; ++i) a_[i] = b_[i] + 3 * c_[i];
      });
    };
    best.measure(work, bytes / (24.0 * kCount));
  }

 private:
  static constexpr size_t kPart = 16384, kCount = kPart * 1024;
  std::vector<double> a_, b_, c_;
};

void bench_rule(const char* name, double bytes, const NetworkPtr& network,
                const std::vector<Stage>& stages, Triad& triad) {
  Simulation simulation(network, RandomKey(1));
  simulation.run(stages, 2);
  Time ours, bound;
  const double cells = static_cast<double>(network->size());
  for (int round = 0; round < kRounds; ++round) {
    ours.measure([&] { simulation.run(stages, 1); });
    triad.measure(bound, bytes * cells);
  }
  fmt::print(
      "{:12} {:8.1e} cells {:7.2f} ms a step {:6.0f} M cells/s {:5.1f} GB/s, triad {:5.1f}: "
      "{:3.0f} % of "
      "the bound, by cpu {:3.0f} %; {:.0f} times 1.2 M/s\n",
      name, cells, ours.wall * 1e3, cells / ours.wall / 1e6, bytes * cells / ours.wall / 1e9,
      bytes * cells / bound.wall / 1e9, 100 * bound.wall / ours.wall, 100 * bound.cpu / ours.cpu,
      cells / ours.wall / 1.2e6);
}

void bench_rules(double millions, Triad& triad) {
  const auto side = static_cast<uint32_t>(std::sqrt(millions * 1e6) / 2) * 2;
  const auto network = std::make_shared<const Network>(flat_torus(side, side, 8));
  const Stage alive{make_product(rules(), "sprinkle", {{"attribute", "alive"}, {"whole", true}}),
                    "alive",
                    0,
                    1,
                    {}};
  const Stage drops{
      make_product(rules(), "sprinkle", {{"attribute", "v"}, {"share", 0.05}}), "drops", 0, 1, {}};
  bench_rule("life", 32 + 8, network, {alive, {make_product(rules(), "life"), "life"}}, triad);
  bench_rule("gray_scott", 32 + 16, network,
             {drops, {make_product(rules(), "gray_scott"), "gray_scott"}}, triad);
}

void bench_build(double millions) {
  const Surface ball({std::make_shared<const mesh::Mesh>(mesh::sphere_mesh(Vec3d(0), 1, 6))});
  for (const char* name : {"square", "triangle", "random"}) {
    const Grid grid = make_product(grids(), name);
    const double spacing = std::sqrt(estimate(ball, grid, 1) / (millions * 1e6));
    std::vector<SurfacePoint> places;
    Time strewing, relaxing, linking, orienting;
    for (int round = 0; round < 3; ++round) {
      strewing.measure([&] { places = scatter_cells(ball, grid, spacing, RandomKey(1)); });
      RelaxOptions one;
      one.steps = 1;
      relaxing.measure([&] { relax(places, ball, spacing, grid.reach * spacing, one); });
      Network network;
      linking.measure(
          [&] { network = link(places, ball, spacing, grid.reach * spacing, grid.full); });
      orienting.measure([&] { orient(network); });
    }
    const double cells = static_cast<double>(places.size()) / 1e6;
    fmt::print(
        "{:9} {:5.2f} M cells, M cells/s (by cpu): strewn {:.2f} ({:.2f}), a step of "
        "harmonising {:.2f} ({:.2f}), ordered and linked {:.2f} ({:.2f}), oriented {:.1f}\n",
        name, cells, cells / strewing.wall, cells / strewing.cpu, cells / relaxing.wall,
        cells / relaxing.cpu, cells / linking.wall, cells / linking.cpu, cells / orienting.wall);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<double> millions;
  for (int i = 1; i < argc; ++i) millions.push_back(std::atof(argv[i]));
  if (millions.empty()) millions = {1, 10};
  bench_build(1);
  Triad triad;
  for (const double each : millions) bench_rules(each, triad);
  fmt::print("resident at the end: {}\n", bytes_text(static_cast<double>(resident_memory())));
  return 0;
}
