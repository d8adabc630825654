// SPDX-License-Identifier: Apache-2.0
// Writing of .vdb files with identifiers that depend only on their content.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/io.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/vdb_header.h>

#include <fmt/format.h>
#include <openvdb/io/Compression.h>
#include <openvdb/points/PointDataGrid.h>
#include <openvdb/tools/ChangeBackground.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

namespace vug::volume {
namespace {

Metadata standard_metadata() {
  return {{"vug:version", std::string(VUG_VERSION)},
          {"vug:metersPerUnit", 1.0},
          {"vug:upAxis", std::string("y")}};
}

/// A copy whose background is representable in 16 bits, rounded up: inactive values then read back
/// equal to it, as required for a level set.
void widen_band_to_half(openvdb::FloatGrid& grid) {
  using openvdb::math::half;
  const float background = grid.background();
  half rounded(background);
  if (static_cast<float>(rounded) < background)
    rounded.setBits(static_cast<uint16_t>(rounded.bits() + 1));
  if (!rounded.isFinite() || !rounded.isNormalized())
    throw Error(ErrorCode::bad_input,
                fmt::format("16 bits cannot represent the distances of grid '{}'", grid.getName()),
                {}, "write it without the half option");
  if (static_cast<float>(rounded) == background) return;
  grid.setTree(grid.tree().copy());
  openvdb::tools::changeLevelSetBackground(grid.tree(), static_cast<float>(rounded));
}

void load_attributes(const openvdb::points::PointDataGrid& points) {
  for (auto leaf = points.tree().cbeginLeaf(); leaf; ++leaf)
    for (size_t i = 0; i < leaf->attributeSet().size(); ++i)
      leaf->constAttributeArray(i).loadData();
}

openvdb::GridBase::Ptr prepared(const Grid& grid, const WriteOptions& options) {
  const auto copy = openvdb::ConstPtrCast<openvdb::GridBase>(grid.data().grid->copyGrid());
  // The statistics written by OpenVDB depend on the voxels in memory.
  copy->baseTree().readNonresidentBuffers();
  if (copy->isType<openvdb::points::PointDataGrid>())
    load_attributes(static_cast<openvdb::points::PointDataGrid&>(*copy));
  for (const Metadata& metadata : {standard_metadata(), options.metadata})
    write_metadata(*copy, metadata);
  const bool half = options.half || grid.saved_as_half();
  copy->setSaveFloatAsHalf(half);
  if (half && copy->isType<openvdb::FloatGrid>() && copy->getGridClass() == openvdb::GRID_LEVEL_SET)
    widen_band_to_half(static_cast<openvdb::FloatGrid&>(*copy));
  return copy;
}

/// openvdb::io::File hides its stream and never checks it for failure, so a full disk would leave
/// an incomplete file without an error.
struct Archive : openvdb::io::Archive {
  using openvdb::io::Archive::write;
};

void check_grids(const std::vector<Grid>& grids) {
  std::set<std::string> names;
  for (const Grid& grid : grids) {
    if (grid.name().empty()) throw Error(ErrorCode::bad_input, "a grid needs a name to be written");
    if (!names.insert(grid.name()).second)
      throw Error(ErrorCode::bad_input,
                  fmt::format("two grids of one file have the name '{}'", grid.name()));
    if (is_points(grid) != is_points(grids.front()))
      throw Error(
          ErrorCode::bad_input, "points and other grids are in one file", {},
          "many programs cannot read a file that contains points: write them to a separate file");
  }
}

void set_identifier(const std::filesystem::path& file) {
  const std::string identifier = content_identifier(file);
  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
  out.seekp(VdbHeader::kIdentifierAt);
  out.write(identifier.data(), VdbHeader::kIdentifierSize);
  out.close();
  if (!out) throw Error(ErrorCode::io, fmt::format("cannot write '{}'", file.string()));
}

}  // namespace

void write(const std::filesystem::path& target, const std::vector<Grid>& grids,
           const WriteOptions& options) {
  initialise_openvdb();
  check_grids(grids);
  AtomicFile file(target);
  openvdb::GridCPtrVec ready;
  for (const Grid& grid : grids) ready.push_back(prepared(grid, options));
  openvdb::MetaMap metadata;
  for (const Metadata& part : {standard_metadata(), options.metadata})
    write_metadata(metadata, part);
  try {
    Archive archive;
    archive.setCompression(
        openvdb::io::COMPRESS_ACTIVE_MASK |
        (Archive::hasBloscCompression() ? openvdb::io::COMPRESS_BLOSC : openvdb::io::COMPRESS_ZIP));
    std::ofstream out(file.path(), std::ios::binary);
    archive.write(out, ready, true, metadata);
    out.close();
    if (!out)
      throw Error(ErrorCode::io,
                  fmt::format("cannot write '{}': {}", target.string(), std::strerror(errno)));
  } catch (const openvdb::Exception& fault) {
    throw Error(ErrorCode::io, fmt::format("cannot write '{}': {}", target.string(), fault.what()));
  }
  set_identifier(file.path());
  file.commit();
}

}  // namespace vug::volume
