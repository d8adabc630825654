// SPDX-License-Identifier: Apache-2.0
// Reading of grids and of their headers from .vdb files, which another process may replace
// meanwhile.
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/io.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/vdb_header.h>

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <tuple>

namespace vug::volume {
namespace {

constexpr int kLooks = 10;  // Attempts for a file that is replaced repeatedly.

/// Distinguishes a file from another one that replaces it.
using Identity = std::tuple<dev_t, ino_t, off_t, time_t, long>;

std::optional<Identity> identity(const std::filesystem::path& source) {
  struct stat about {};
  if (::stat(source.c_str(), &about) != 0) return std::nullopt;
  return Identity{about.st_dev, about.st_ino, about.st_size, about.st_mtim.tv_sec,
                  about.st_mtim.tv_nsec};
}

/// Opens a file whose header has been checked; OpenVDB's exceptions become our errors.
template <class Work>
auto with_one_file(const std::filesystem::path& source, const ReadOptions& options,
                   const Work& work) {
  const VdbHeader header = read_vdb_header(source);
  const auto fail = [&](const std::string& why) {
    return Error(ErrorCode::bad_input, fmt::format("cannot read '{}': {}", source.string(), why));
  };
  if (options.verify && header.has_content_hash() &&
      content_identifier(source) != header.identifier)
    throw fail("it is damaged: its bytes do not match its hash");
  try {
    openvdb::io::File file(source.string());
    file.setCopyMaxBytes(0);  // Our files are replaced, never rewritten in place.
    file.open(options.delayed);
    return work(file, header);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& fault) {  // OpenVDB's, and consequences of damaged lengths.
    throw fail(fault.what());
  }
}

/// A file is opened several times. If another one replaces it in between, such as the next
/// checkpoint, the whole operation starts again.
template <class Work>
auto with_file(const std::filesystem::path& source, const ReadOptions& options, const Work& work) {
  initialise_openvdb();
  for (int looks_left = kLooks; looks_left > 1; --looks_left) {
    const std::optional<Identity> before = identity(source);
    try {
      auto out = with_one_file(source, options, work);
      if (identity(source) == before) return out;
    } catch (const Error&) {
      if (identity(source) == before) throw;
    }
  }
  return with_one_file(source, options, work);
}

/// In file order; OpenVDB returns them by name.
std::vector<Grid> all_grids(openvdb::io::File& file, const VdbHeader& header) {
  const openvdb::GridPtrVecPtr grids = file.getGrids();
  const auto place = [&](const openvdb::GridBase::Ptr& grid) {
    return std::find(header.grids.begin(), header.grids.end(), grid->getName());
  };
  std::stable_sort(grids->begin(), grids->end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  std::vector<Grid> out;
  for (const openvdb::GridBase::Ptr& grid : *grids) out.push_back(wrap(grid));
  return out;
}

}  // namespace

std::vector<Grid> read(const std::filesystem::path& source, const ReadOptions& options) {
  return with_file(source, options, [](openvdb::io::File& file, const VdbHeader& header) {
    return all_grids(file, header);
  });
}

Grid read_grid(const std::filesystem::path& source, const std::string& name,
               const ReadOptions& options) {
  return with_file(source, options, [&](openvdb::io::File& file, const VdbHeader& header) {
    if (!name.empty() && file.hasGrid(name)) return wrap(file.readGrid(name));
    std::vector<std::string> names;
    for (const Grid& grid : all_grids(file, header)) {
      if (name.empty() && grid.grid_class() == GridClass::level_set) return grid;
      names.push_back(grid.name());
    }
    if (name.empty() && !names.empty()) return all_grids(file, header).front();
    throw Error(ErrorCode::bad_input,
                name.empty()
                    ? fmt::format("'{}' does not contain a grid", source.string())
                    : fmt::format("'{}' does not contain a grid named '{}'", source.string(), name),
                {}, name.empty() ? "" : suggestion(name, names));
  });
}

FileInfo info(const std::filesystem::path& source) {
  return with_file(source, {}, [&](openvdb::io::File& file, const VdbHeader& header) {
    FileInfo out;
    out.bytes = std::filesystem::file_size(source);
    out.format_version = header.format_version;
    out.identifier = header.identifier;
    if (const auto metadata = file.getMetadata()) out.metadata = read_metadata(*metadata);
    for (const Grid& grid : all_grids(file, header)) {
      out.grids.push_back({grid.name(),
                           grid.grid_class(),
                           grid.value_type(),
                           grid.voxel_size(),
                           grid.saved_as_half(),
                           grid.statistics(),
                           grid.metadata(),
                           {}});
      if (is_points(grid)) out.grids.back().points = points_info(grid);
    }
    return out;
  });
}

}  // namespace vug::volume
