// SPDX-License-Identifier: Apache-2.0
// A sign for other processes that one works on a task.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace vug::farm {

/// A file that exists while this object does, with a heartbeat. Claims avoid that work is done
/// twice; they are not needed for correct results.
class Claim {
 public:
  /// Null if another process that is alive holds the claim. Takes over that of a dead process.
  /// Error(io) if the file cannot be written.
  static std::unique_ptr<Claim> take(const std::filesystem::path& file);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

 private:
  explicit Claim(std::filesystem::path file);

  std::filesystem::path file_;
  std::mutex mutex_;
  std::condition_variable ends_;
  bool ended_ = false;
  std::thread heart_;
};

/// A lock on a file, which is created. It only avoids double work; on file systems without locks
/// nothing waits.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

/// The host and the process, "node3:4711".
std::string this_process();

}  // namespace vug::farm
