// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/exact_file.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/io.h>
#include <vug/volume/openvdb_values.h>

namespace vug::volume {

void write_exact(const std::filesystem::path& target, const LevelSet& level_set) {
  write(target, {level_set.named("level_set").stored_as_half(false)});
}

LevelSet read_exact(const std::filesystem::path& source) {
  const Grid read = read_grid(source, "level_set", {.delayed = false, .verify = false});
  const openvdb::FloatGrid& of_file = floats(LevelSet(read));
  const auto grid =
      openvdb::FloatGrid::create(openvdb::ConstPtrCast<openvdb::FloatTree>(of_file.constTreePtr()));
  grid->setTransform(of_file.transform().copy());
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
