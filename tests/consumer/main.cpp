// A sphere, made by name, measured at three points whose distances are known, and as a level set.
#include <vug/field/registry.h>
#include <vug/volume/voxelize.h>

#include <iostream>

int main() {
  const vug::field::Field sphere = vug::field::make("sphere", {{"radius", 2.0}});
  const double centre = sphere.value({0, 0, 0});
  const double surface = sphere.value({0, 2, 0});
  const double outside = sphere.gradient({3, 0, 4}).value;
  const vug::volume::LevelSet rock = vug::volume::voxelize(sphere, {.voxel = 0.25});
  const auto voxels = rock.statistics().active_voxels;
  std::cout << centre << ' ' << surface << ' ' << outside << ' ' << voxels << '\n';
  // Within three voxels of the surface lie about 4/3 pi (2.75^3 - 1.25^3) / 0.25^3 = 5052.
  const bool band = voxels > 4800 && voxels < 5300;
  return centre == -2 && surface == 0 && outside == 3 && band ? 0 : 1;
}
