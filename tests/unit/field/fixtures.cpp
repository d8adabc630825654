// SPDX-License-Identifier: Apache-2.0
#include "fixtures.h"

#include <vug/base/maths.h>
#include <vug/base/scratch_folder.h>
#include <vug/field/sampled.h>
#include <vug/image/io.h>
#include <vug/mesh/format.h>
#include <vug/mesh/shapes.h>

#include <filesystem>

namespace vug::field {
namespace {

/// A ball of radius 1 as a level set without a lattice: clamped at the band.
class BallGrid final : public SampledGrid {
 public:
  Gradient sample(const Vec3d& p) const override {
    const double value = p.length() - 1;
    if (std::fabs(value) >= band()) return {value < 0 ? -band() : band(), Vec3d(0)};
    return {value, p.normalized()};
  }
  Box3d bounds() const override { return {Vec3d(-1 - band()), Vec3d(1 + band())}; }
  double band() const override { return 0.3; }
  double lipschitz() const override { return 1; }
  Digest digest() const override { return digest_of(std::string("ball")); }
};

}  // namespace

const std::string& fixture_folder() {
  static const ScratchFolder folder("vug_fixtures");
  static const std::string text = folder.path().string();
  return text;
}

std::string fixture_file(const std::string& kind) {
  if (kind == "mesh") {
    const std::string file = fixture_folder() + "/solid.ply";
    const mesh::Mesh two = mesh::joined(mesh::torus_mesh(1, 0.4, 24, 12),
                                        mesh::box_mesh({Vec3d(-0.3, 1, -0.3), Vec3d(0.3, 2, 0.4)}));
    if (!std::filesystem::exists(file)) mesh::write_mesh(two, file);
    return file;
  }
  if (kind == "heightfield") {
    const std::string file = fixture_folder() + "/hills.exr";
    image::Image hills(9, 7, {"Y"});
    for (int y = 0; y < hills.height; ++y)
      for (int x = 0; x < hills.width; ++x)
        hills.at(x, y) = static_cast<float>(0.5 + 0.5 * maths::sin(x) * maths::cos(0.7 * y));
    if (!std::filesystem::exists(file)) image::write_exr(file, hills);
    return file;
  }
  if (kind == "grid") {
    set_grid_loader(
        [](const std::string&, const std::string&) { return std::make_shared<const BallGrid>(); });
    return "ball.vdb";
  }
  return {};
}

}  // namespace vug::field
