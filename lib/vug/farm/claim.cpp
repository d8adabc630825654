// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/farm/claim.h>
#include <vug/farm/job_folder.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace vug::farm {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags)
      : number_(open(file.c_str(), flags | O_CLOEXEC, 0644)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return number_; }

 private:
  int number_;
};

/// Writes the owner, for people, and sets the time.
void sign(int descriptor) {
  const std::string text = this_process() + "\n";
  [[maybe_unused]] const auto written = pwrite(descriptor, text.data(), text.size(), 0);
  [[maybe_unused]] const int cut = ftruncate(descriptor, static_cast<off_t>(text.size()));
  futimens(descriptor, nullptr);
}

/// Whether this call created the file.
bool create(const fs::path& file) {
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  const Descriptor descriptor(file, O_WRONLY | O_CREAT | O_EXCL);
  if (descriptor >= 0) {
    sign(descriptor);
    return true;
  }
  if (errno == EEXIST) return false;
  throw Error(ErrorCode::io,
              fmt::format("cannot write '{}': {}", file.string(), std::strerror(errno)), {},
              "check the free space and the permissions of the job's folder");
}

/// Whether this call took over the file of a dead process. The lock admits one at a time.
bool replace_dead(const fs::path& file) {
  const Descriptor descriptor(file, O_WRONLY);
  if (descriptor < 0 || flock(descriptor, LOCK_EX) != 0 || is_alive(file)) return false;
  sign(descriptor);
  return true;
}

}  // namespace

FileLock::FileLock(const fs::path& file)
    : descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string this_process() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return fmt::format("{}:{}", host.data(), getpid());
}

std::unique_ptr<Claim> Claim::take(const fs::path& file) {
  if (!create(file) && !replace_dead(file)) return nullptr;
  return std::unique_ptr<Claim>(new Claim(file));
}

Claim::Claim(fs::path file) : file_(std::move(file)) {
  heart_ = std::thread([this] {
    std::unique_lock lock(mutex_);
    while (!ends_.wait_for(lock, kHeartbeat, [this] { return ended_; })) {
      std::error_code ignored;
      fs::last_write_time(file_, fs::file_time_type::clock::now(), ignored);
    }
  });
}

Claim::~Claim() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ends_.notify_all();
  heart_.join();
  std::error_code ignored;
  fs::remove(file_, ignored);
}

}  // namespace vug::farm
