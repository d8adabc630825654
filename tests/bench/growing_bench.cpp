// SPDX-License-Identifier: Apache-2.0
// The steps of the surface of data/scenes/gallery/chamber_growing.vug from frame to frame: the
// Hausdorff distance between the meshes of two consecutive frames, which no vertex step of either
// onto the other exceeds, for pairs that are spread over its 240 frames. A pair in which a
// stalactite breaks, which is an event of its own, gives way to the next one.
//   bench_growing [PAIRS]      default: 24
#include "arguments.h"

#include <vug/base/error.h>
#include <vug/building/builder.h>
#include <vug/drips/growth_report.h>
#include <vug/exchange/levels.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace {

using namespace vug;

constexpr int kFrames = 240;

loading::Loaded load(int frame) {
  loading::LoadOptions options;
  options.include_folders = {std::filesystem::path(VUG_DATA)};
  options.frame = frame;
  loading::Loaded loaded = loading::load(
      std::filesystem::path(VUG_DATA) / "scenes/gallery/chamber_growing.vug", options);
  if (!loaded.usable()) throw Error(ErrorCode::bad_input, loaded.report());
  return loaded;
}

bool breaks_between(int a, int b) {
  drips::GrowthCheck check;
  for (const int frame : {a, b}) {
    const loading::Loaded loaded = load(frame);
    const shot::DripsPlan& plan = *shot::find_drips(loaded.shot, "").drips;
    check.add(frame, plan.grown(), plan.options().forms);
  }
  return !check.report().broken.empty();
}

/// The mesh of a frame with all its components.
mesh::MeshPtr mesh_of(int frame, double& voxel) {
  const loading::Loaded loaded = load(frame);
  shot::MeshPlan plan = *loaded.shot.meshes.front();
  plan.smallest_piece = 0;
  voxel = plan.volume->voxel;
  building::Builder builder(loaded.shot);
  return builder.mesh(std::make_shared<const shot::MeshPlan>(plan));
}

/// The boxes of all components but the largest one.
std::vector<Box3d> small_components(const mesh::Mesh& mesh) {
  const std::vector<uint32_t> component = mesh::face_components(mesh, mesh::find_edges(mesh));
  std::vector<Box3d> boxes;
  for (size_t i = 0; i < component.size(); ++i) {
    if (component[i] >= boxes.size()) boxes.resize(component[i] + 1);
    for (const Vec3d& p : mesh::corners(mesh, i)) boxes[component[i]].extendBy(p);
  }
  const auto largest = std::max_element(
      boxes.begin(), boxes.end(),
      [](const auto& a, const auto& b) { return a.size().length() < b.size().length(); });
  if (largest != boxes.end()) boxes.erase(largest);
  return boxes;
}

/// The greatest extent of a component that touches the box of none before.
double first_extent(const mesh::Mesh& before, const mesh::Mesh& now, double voxel) {
  const std::vector<Box3d> old = small_components(before);
  double most = 0;
  for (const Box3d& box : small_components(now)) {
    const bool known = std::any_of(old.begin(), old.end(), [&](const Box3d& other) {
      return other.intersects(grown(box, voxel));
    });
    if (!known) most = std::max(most, box.size().length());
  }
  return most;
}

int run(int pairs) {
  double greatest = 0, first = 0, voxel = 0;
  for (int i = 0; i < pairs; ++i) {
    int frame = 1 + i * (kFrames - 2) / std::max(1, pairs - 1);
    while (frame + 2 < kFrames && breaks_between(frame, frame + 1)) ++frame;
    const mesh::MeshPtr before = mesh_of(frame, voxel), now = mesh_of(frame + 1, voxel);
    const double step = exchange::hausdorff_distance(*before, *now);
    const double extent = first_extent(*before, *now, voxel);
    greatest = std::max(greatest, step), first = std::max(first, extent);
    fmt::print(
        "frames {:3} and {:3}: step {:5.2f} cm, {} other components, new ones up to {:.2f} cm\n",
        frame, frame + 1, 100 * step, small_components(*now).size(), 100 * extent);
    std::fflush(stdout);
  }
  fmt::print("greatest step {:.2f} cm, greatest new component {:.2f} cm, voxels {:.2f} cm\n",
             100 * greatest, 100 * first, 100 * voxel);
  return first <= voxel ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  int pairs = 24;
  if (argc > 2 || (argc == 2 && !bench::read_number(argv[1], 1, kFrames - 1, pairs))) {
    fmt::print(stderr, "usage: bench_growing [PAIRS (1 to 239)]\n");
    return 2;
  }
  try {
    return run(pairs);
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
