// SPDX-License-Identifier: Apache-2.0
#include "lsp/check_thread.h"

#include <utility>

namespace vug::lsp {

CheckThread::CheckThread(Done done) : done_(std::move(done)), thread_([this] { run(); }) {}

CheckThread::~CheckThread() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void CheckThread::check(language::Workspace texts, const std::set<std::filesystem::path>& files) {
  {
    const std::lock_guard lock(mutex_);
    texts_ = std::move(texts);
    waiting_.insert(files.begin(), files.end());
  }
  changed_.notify_one();
}

void CheckThread::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    const std::filesystem::path file = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    const language::Workspace texts = *texts_;
    lock.unlock();
    const language::CheckResult result = language::check_scene(texts, file);
    done_(file, result.diagnostics);
    lock.lock();
  }
}

}  // namespace vug::lsp
