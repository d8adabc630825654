// SPDX-License-Identifier: Apache-2.0
// Checks scenes in a thread of its own, so that requests are answered meanwhile.
#pragma once

#include <vug/language/check.h>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace vug::lsp {

class CheckThread {
 public:
  /// Receives the result of each check, in the thread of the check.
  using Done = std::function<void(const std::filesystem::path&, const Diagnostics&)>;

  explicit CheckThread(Done done);
  /// Waits for the check that is running.
  ~CheckThread();
  CheckThread(const CheckThread&) = delete;
  CheckThread& operator=(const CheckThread&) = delete;

  /// Checks the files with these texts; files that are waiting are checked with them, too.
  void check(language::Workspace texts, const std::set<std::filesystem::path>& files);

 private:
  void run();

  Done done_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<language::Workspace> texts_;
  std::set<std::filesystem::path> waiting_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace vug::lsp
