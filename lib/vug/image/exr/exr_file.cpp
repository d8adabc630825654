// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/exr/exr_file.h>
#include <vug/image/exr/threads.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace vug::image::exr {

ExrFile::ExrFile(const std::filesystem::path& path, const std::filesystem::path& temporary)
    : Imf::OStream(path.c_str()), path_(path), file_(nullptr, std::fclose) {
  file_.reset(std::fopen(temporary.c_str(), "wb"));
  if (!file_) fail();
}

void ExrFile::fail() const {
  throw Error(ErrorCode::io,
              fmt::format("cannot write picture '{}': {}", path_.string(), std::strerror(errno)));
}

void ExrFile::write(const char bytes[], int count) {
  if (std::fwrite(bytes, 1, static_cast<size_t>(count), file_.get()) != static_cast<size_t>(count))
    fail();
}

uint64_t ExrFile::tellp() {
  const off_t position = ftello(file_.get());
  if (position < 0) fail();
  return static_cast<uint64_t>(position);
}

void ExrFile::seekp(uint64_t position) {
  if (fseeko(file_.get(), static_cast<off_t>(position), SEEK_SET) != 0) fail();
}

void ExrFile::close() {
  // Only the error flag reports an earlier failed flush.
  const bool whole = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  if (std::fclose(file_.release()) != 0 || !whole) fail();
}

void write_file(const std::filesystem::path& path, const std::filesystem::path& temporary,
                const std::function<void(Imf::OStream&)>& write) {
  ExrFile file(path, temporary);
  start_threads();
  try {
    write(file);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& fault) {
    throw Error(ErrorCode::io,
                fmt::format("cannot write picture '{}': {}", path.string(), fault.what()));
  }
  file.close();
}

}  // namespace vug::image::exr
