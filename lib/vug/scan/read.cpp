// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/scan/read.h>

namespace vug::scan {

PointCloud parse_cloud(std::string_view bytes, const std::string& file,
                       const ReadOptions& options) {
  const bool ply = bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
  PointCloud cloud = ply ? parse_ply(bytes, file, options) : parse_xyz(bytes, file, options);
  if (cloud.size() == 0)
    throw Error(
        ErrorCode::bad_input,
        cloud.dropped > 0 ? "none of the points has a finite position" : "the cloud is empty",
        {file, 1, 1}, "use a PLY file with vertices, or lines of x y z");
  return cloud;
}

PointCloud read_clouds(const std::vector<std::filesystem::path>& files,
                       const ReadOptions& options) {
  if (files.empty()) throw Error(ErrorCode::bad_input, "no file to read a cloud from");
  PointCloud all;
  for (const auto& file : files) {
    if (extension_of(file) == ".exr") {
      all = concatenated(std::move(all), read_picture(file, options));
      continue;
    }
    std::error_code unreadable;
    const uintmax_t bytes = std::filesystem::file_size(file, unreadable);
    // read_text reports the reason if a file cannot be read.
    if (!unreadable)
      require_memory(static_cast<double>(bytes), options.memory, "the file " + file.string(),
                     "reduce the number of points");
    all = concatenated(std::move(all), parse_cloud(read_text(file), file.string(), options));
  }
  return all;
}

}  // namespace vug::scan
