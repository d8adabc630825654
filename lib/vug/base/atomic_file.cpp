// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/partial_files.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

namespace vug {
namespace fs = std::filesystem;

namespace {

constexpr int kMaxLinks = 40;  // as in Linux

/// The path with symbolic links resolved, even if the target does not exist yet.
fs::path followed(fs::path path) {
  std::error_code code;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, code); ++i) {
    const fs::path next = fs::read_symlink(path, code);
    if (code) break;
    path = path.parent_path() / next;  // an absolute path replaces the parent
  }
  return path;
}

/// The same text for all names of a file, which need not exist.
std::string identity(const fs::path& path) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(fs::absolute(followed(path), code), code);
  return (code ? path : whole).string();
}

/// Read, write and execute bits of a file; nothing if it does not exist.
std::optional<mode_t> mode_of(const fs::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status.st_mode & 0777;
}

/// True if no process holds a lock on the file. On a shared folder or inside a container, the lock
/// is the only evidence that the writing process still runs.
bool is_free(const fs::path& temporary) {
  const int file = ::open(temporary.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return false;
  const bool free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return free;
}

void remove_stale(const fs::path& target) {
  std::error_code ignored;
  for (const fs::path& each : stale_partial_files(target.parent_path(), target.stem().string(),
                                                  target.extension().string()))
    if (is_free(each)) fs::remove(each, ignored);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : target_(followed(target)) {
  std::error_code code;
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  made_folders_ = make_folders(folder);
  if (fs::is_directory(target_, code)) {
    discard();
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot write '{}': it is a folder", target_.string()), {},
                "give the name of a file, such as one in that folder");
  }
  if (fs::exists(target_, code))
    if (const std::string why = unreadable_reason(target_); !why.empty()) fail(why);
  const fs::path temporary =
      folder / partial_file_name(target_.stem().string(), target_.extension().string());
  const mode_t mode = mode_of(target_).value_or(0666) | 0600;  // private files stay private
  lock_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode & 0666);
  if (lock_ < 0) fail(std::strerror(errno));
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) errno = 0;  // not all file systems have locks
  temporary_ = temporary;
}

AtomicFile::~AtomicFile() {
  if (!committed_) discard();
  if (lock_ >= 0) ::close(lock_);
}

void AtomicFile::discard() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
  remove_empty_folders(made_folders_);
}

void AtomicFile::fail(const std::string& why) {
  discard();
  throw Error(ErrorCode::io, fmt::format("cannot write '{}': {}", target_.string(), why));
}

void AtomicFile::commit() {
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    // Not all file systems have permissions; only the content matters.
    if (const auto mode = mode_of(target_); mode && ::fchmod(file, *mode) != 0) errno = 0;
    const int failed = ::fsync(file) ? errno : 0;
    ::close(file);
    if (failed) fail(std::strerror(failed));
  }
  std::error_code code;
  fs::rename(temporary_, target_, code);
  if (code) fail(code.message());
  committed_ = true;
}

void require_writable(const fs::path& target) {
  const AtomicFile probe(target);
  remove_stale(followed(target));
}

void require_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::set<std::string> read, written;
  for (const fs::path& input : inputs) read.insert(identity(input));
  for (const fs::path& output : outputs) {
    const std::string id = identity(output);
    if (read.count(id))
      throw Error(ErrorCode::bad_input,
                  fmt::format("output '{}' would overwrite an input file", output.string()), {},
                  "choose another name for the output");
    if (!written.insert(id).second)
      throw Error(ErrorCode::bad_input, fmt::format("'{}' would be written twice", output.string()),
                  {}, "give each output its own name");
  }
  for (const fs::path& output : outputs) require_writable(output);
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

std::string unreadable_reason(const fs::path& source) {
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
      return "it is not a regular file";
  }
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

std::string read_text(const fs::path& source) {
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::bad_input, fmt::format("cannot read '{}': {}", source.string(), why));
  };
  if (const std::string why = unreadable_reason(source); !why.empty()) fail(why);
  std::ifstream in(source, std::ios::binary);
  if (!in) fail(std::strerror(errno));
  std::string text;
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0)
    text.append(block, static_cast<size_t>(in.gcount()));
  if (in.bad()) fail(std::strerror(errno));  // e.g. pseudo files of the kernel
  return text;
}

}  // namespace vug
