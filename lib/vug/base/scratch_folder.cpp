// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace vug {

ScratchFolder::ScratchFolder(const std::string& name) {
  std::error_code none;
  std::filesystem::path where = std::filesystem::temp_directory_path(none);
  if (none) where = "/tmp";
  std::string made = (where / (name + "_XXXXXX")).string();
  if (!mkdtemp(made.data()))
    throw Error(ErrorCode::io, fmt::format("cannot create a temporary folder in '{}': {}",
                                           where.string(), std::strerror(errno)));
  path_ = made;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace vug
