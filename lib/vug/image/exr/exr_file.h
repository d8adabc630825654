// SPDX-License-Identifier: Apache-2.0
// Internal to image/: the file that OpenEXR writes. Includes OpenEXR.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>

namespace vug::image::exr {

/// A file that is written under a temporary name. Its functions throw Error(io) with the reason
/// that the system gives, such as a full disk; messages refer to `path`.
class ExrFile : public Imf::OStream {
 public:
  ExrFile(const std::filesystem::path& path, const std::filesystem::path& temporary);
  void write(const char bytes[], int count) override;
  uint64_t tellp() override;
  void seekp(uint64_t position) override;
  /// Throws Error(io) unless all bytes are in the file.
  void close();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// Writes a file by `write`, with OpenEXR's threads. Exceptions of OpenEXR become Error(io), except
/// those of the file itself.
void write_file(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::function<void(Imf::OStream&)>& write);

}  // namespace vug::image::exr
