// SPDX-License-Identifier: Apache-2.0
#include <vug/watch/file_watcher.h>

#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>

namespace vug::watch {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Files are looked at after this time if no event is reported, and if the system reports none.
constexpr milliseconds kLook{1000}, kPoll{100};

}  // namespace

FileWatcher::FileWatcher(Method method)
    : events_(method == Method::events ? inotify_init1(IN_NONBLOCK | IN_CLOEXEC) : -1) {}

FileWatcher::~FileWatcher() {
  if (events_ >= 0) close(events_);
}

FileWatcher::Stamp FileWatcher::stamp_of(const std::filesystem::path& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) return {};
  return {static_cast<uint64_t>(found.st_size), static_cast<uint64_t>(found.st_ino),
          int64_t{found.st_mtim.tv_sec} * 1000000000 + found.st_mtim.tv_nsec};
}

void FileWatcher::watch(const std::vector<std::filesystem::path>& files) {
  std::map<std::filesystem::path, Stamp> known;
  std::map<std::filesystem::path, int> folders;
  for (const std::filesystem::path& file : files) {
    const auto before = known_.find(file);
    known[file] = before == known_.end() ? stamp_of(file) : before->second;
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    if (events_ < 0 || folders.count(folder)) continue;
    const auto watched = folders_.find(folder);
    folders[folder] = watched != folders_.end()
                          ? watched->second
                          : inotify_add_watch(events_, folder.c_str(),
                                              IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM |
                                                  IN_CREATE | IN_DELETE | IN_ATTRIB);
  }
  // Two names of one folder have the same number.
  std::set<int> needed;
  for (const auto& [folder, number] : folders) needed.insert(number);
  for (const auto& [folder, number] : folders_)
    if (number >= 0 && !needed.count(number)) inotify_rm_watch(events_, number);
  known_ = std::move(known), folders_ = std::move(folders);
}

bool FileWatcher::has_events_of_all() const {
  return events_ >= 0 && std::none_of(folders_.begin(), folders_.end(),
                                      [](const auto& each) { return each.second < 0; });
}

bool FileWatcher::is_due() const {
  return has_event_ || Clock::now() - looked_ >= (has_events_of_all() ? kLook : kPoll);
}

bool FileWatcher::look() {
  has_event_ = false;
  looked_ = Clock::now();
  bool changed = false;
  for (auto& [file, stamp] : known_) {
    const Stamp now = stamp_of(file);
    changed = changed || !(now == stamp);
    stamp = now;
  }
  return changed;
}

void FileWatcher::wait_for_event(milliseconds time) {
  if (!has_events_of_all()) return std::this_thread::sleep_for(std::min(time, kPoll));
  pollfd waiting{events_, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(std::min(time, kLook).count())) <= 0) return;
  has_event_ = true;
  std::array<char, 4096> ignored{};
  while (read(events_, ignored.data(), ignored.size()) > 0) {
  }
}

bool FileWatcher::wait(milliseconds time, milliseconds quiet) {
  const Clock::time_point end = Clock::now() + time;
  while (!is_due() || !look()) {
    const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    wait_for_event(left);
  }
  do std::this_thread::sleep_for(quiet);
  while (look());
  return true;
}

}  // namespace vug::watch
