#include <vug/base/atomic_file.h>
#include <vug/base/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace vug {
namespace fs = std::filesystem;

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)) {
  std::error_code code;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  fs::create_directories(folder, code);
  if (code)
    throw Error(ErrorCode::io,
                fmt::format("cannot make folder '{}': {}", folder.string(), code.message()));
  temporary_ = folder / fmt::format(".{}.{}.part{}", target_.stem().string(), getpid(),
                                    target_.extension().string());
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    const int failed = ::fsync(file);
    ::close(file);
    if (failed)
      throw Error(ErrorCode::io,
                  fmt::format("cannot write '{}': {}", target_.string(), std::strerror(errno)));
  }
  std::error_code code;
  fs::rename(temporary_, target_, code);
  if (code)
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", target_.string(), code.message()));
  committed_ = true;
}

void write_text(const fs::path& target, std::string_view text) {
  AtomicFile file(target);
  std::ofstream out(file.path(), std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out)
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", target.string(), std::strerror(errno)));
  file.commit();
}

std::string why_no_file(const fs::path& source) {
  std::error_code code;
  switch (fs::status(source, code).type()) {
    case fs::file_type::regular:
      return {};
    case fs::file_type::none:
      return code.message();
    case fs::file_type::not_found:
      return "no such file";
    case fs::file_type::directory:
      return "it is a folder";
    case fs::file_type::fifo:
      return "it is a pipe";
    case fs::file_type::block:
    case fs::file_type::character:
      return "it is a device";
    default:
      return "it is no regular file";
  }
}

std::string read_text(const fs::path& source) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::bad_input, fmt::format("cannot read '{}': {}", source.string(), why));
  };
  if (const std::string why = why_no_file(source); !why.empty()) fail(why);
  std::ifstream in(source, std::ios::binary);
  if (!in) fail(std::strerror(errno));
  std::string text;
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0)
    text.append(block, static_cast<size_t>(in.gcount()));
  if (in.bad()) fail(std::strerror(errno));  // files of the kernel that are no files
  return text;
}

}  // namespace vug
