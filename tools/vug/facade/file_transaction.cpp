// SPDX-License-Identifier: Apache-2.0
#include "file_transaction.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/partial_files.h>

#include <memory>
#include <vector>

namespace vug::cli {

namespace fs = std::filesystem;

FileTransaction::FileTransaction(fs::path folder, const std::string& name)
    : folder_(folder.empty() ? "." : std::move(folder)) {
  std::error_code ignored;
  for (const fs::path& each : stale_partial_files(folder_, name))
    if (fs::is_directory(each, ignored)) fs::remove_all(each, ignored);
  staging_ = folder_ / partial_file_name(name);
  fs::remove_all(staging_, ignored);  // left by a process with the same process number
  created_folders_ = make_folders(staging_);
}

FileTransaction::~FileTransaction() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  remove_empty_folders(created_folders_);
}

void FileTransaction::commit() {
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_)) {
    files.push_back(std::make_unique<AtomicFile>(folder_ / entry.path().filename()));
    const fs::path& temporary = files.back()->path();
    std::error_code code;
    fs::rename(entry.path(), temporary, code);
    if (!code) continue;
    // A symbolic link refers to another disk.
    fs::copy_file(entry.path(), temporary, fs::copy_options::overwrite_existing, code);
    if (code)
      throw Error(ErrorCode::io,
                  fmt::format("cannot write '{}': {}", temporary.string(), code.message()));
  }
  for (const auto& file : files) file->commit();
}

}  // namespace vug::cli
