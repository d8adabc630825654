// SPDX-License-Identifier: Apache-2.0
// Creates a sphere by name, checks its distances at three points and its level set, then writes and
// reads a picture, which requires that the installed library of picture formats is found.
#include <vug/field/registry.h>
#include <vug/image/io.h>
#include <vug/volume/voxelize.h>

#include <filesystem>
#include <iostream>

namespace {

bool picture_survives() {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "vug_consumer.exr";
  vug::image::Image picture(2, 1, {"R", "G", "B"});
  picture.pixels = {0.25F, 0.5F, 1, 2, 4, 8};
  vug::image::write_exr(file, picture);
  const bool same = vug::image::read(file) == picture;
  std::filesystem::remove(file);
  return same;
}

}  // namespace

int main() {
  const vug::field::Field sphere = vug::field::make("sphere", {{"radius", 2.0}});
  const double centre = sphere.value({0, 0, 0});
  const double surface = sphere.value({0, 2, 0});
  const double outside = sphere.gradient({3, 0, 4}).value;
  const vug::volume::LevelSet rock = vug::volume::voxelize(sphere, {.voxel = 0.25});
  const auto voxels = rock.statistics().active_voxels;
  std::cout << centre << ' ' << surface << ' ' << outside << ' ' << voxels << '\n';
  // About 4/3 pi (2.75^3 - 1.25^3) / 0.25^3 = 5052 voxels lie within three voxels of the surface.
  const bool band = voxels > 4800 && voxels < 5300;
  return centre == -2 && surface == 0 && outside == 3 && band && picture_survives() ? 0 : 1;
}
