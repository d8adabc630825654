// SPDX-License-Identifier: Apache-2.0
// Growth of calcite under films of water: 200 steps on a slope of a million cells with hollows.
// Prints wall-clock and processor seconds.
//   bench_film [millions] [steps]      default: 1 200
#include <vug/cells/build.h>
#include <vug/cells/kind.h>
#include <vug/cells/rule.h>
#include <vug/cells/simulation.h>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace {

using namespace vug;
using namespace vug::cells;

/// A slope of 1 m by 1 m that falls by 15 degrees, with hollows of 2 cm.
NetworkPtr slope(double millions) {
  mesh::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, -0.27f, 1}, {1, -0.27f, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  BuildOptions options;
  options.grid = make_product(grids(), "triangle");
  options.spacing = 1e-3 * std::sqrt(1.2 / millions);
  const Surface surface({std::make_shared<const mesh::Mesh>(mesh)});
  return std::make_shared<const Network>(build(surface, options).network);
}

void roughen(Simulation& simulation) {
  auto& height = simulation.attributes().column<float>("height").now;
  for (size_t i = 0; i < height.size(); ++i) {
    const Vec3f& p = simulation.network().position[i];
    height[i] = 1.5e-3f * (std::sin(310 * p.x) * std::sin(290 * p.z + 40 * p.x) +
                           std::sin(170 * p.x + 50 * p.z));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 1;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 200;
  Simulation simulation(slope(millions), RandomKey(1));
  roughen(simulation);
  const Stage stage{make_product(rules(), "calcite", {{"years", 0.002}}), "calcite"};
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t used = std::clock();
  simulation.run({stage}, steps);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{} cells, {} steps: {:.1f} s by the clock, {:.1f} s of processor time\n",
             simulation.network().size(), steps, wall,
             static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
  return 0;
}
