// SPDX-License-Identifier: Apache-2.0
// A folder of finished products that programs share: files named by their content, found by the
// keys of the work that made them.
#pragma once

#include <vug/store/key.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace vug::store {

class Remote;

struct StoreOptions {
  std::filesystem::path folder;
  uint64_t max_bytes = 0;  ///< 0: 20 GB or a tenth of the disk, whichever is less.
  /// Called with a sentence, at most once each, when a product cannot be stored, e.g. because the
  /// disk is full, and when the server does not answer.
  std::function<void(const std::string&)> on_warning = nullptr;
  /// Address of a server with products, http://HOST[:PORT][/PATH]; empty: none.
  std::string remote = {};
};

/// The folder of $VUG_CACHE; else "vug" in $XDG_CACHE_HOME, else ~/.cache/vug. Empty: the store is
/// off, because $VUG_CACHE is "off", or because the user has no home folder.
std::filesystem::path default_folder();
/// The address in $VUG_CACHE_REMOTE; empty without it.
std::string default_remote();
/// The limit of $VUG_CACHE_SIZE, e.g. "5G"; 0 without it. Throws Error(bad_input) for other texts.
uint64_t default_max_bytes();

/// A product that is in the store.
struct Entry {
  /// The file; its digest has been verified. Another process may remove it before it is read.
  std::filesystem::path object;
  double seconds = 0;  ///< The time that the product took to make.
};

/// Layout: objects/ab/HEX, named by the digest of the content, and actions/ab/HEX, named by the
/// digest of the key, which names the object; names/ab/HEX has the last key of each product of a
/// scene. Files are written to a temporary name and renamed, so that any number of processes may
/// read, write and trim the same folder without locks, and a killed process leaves at most a
/// temporary file. What is read is verified: damaged files are removed and the product counts as
/// absent. A folder that is not writable is only read. A server receives what is kept, and products
/// that the folder lacks are copied from it, under the same names and with the same verification.
/// No member function but the constructor, which throws Error(bad_input) for other addresses of a
/// server, throws. Thread-safe.
class Store {
 public:
  explicit Store(StoreOptions options);
  ~Store();

  /// The product of the key; nothing if it is absent or damaged. Marks it as used.
  std::optional<Entry> find(const Key& key);
  /// Whether `find` is likely to succeed; reads no object.
  bool contains(const Key& key) const;
  /// Stores what `write` writes to a file with that extension. Does nothing if `write` throws or
  /// the file cannot be stored.
  void keep(const Key& key, double seconds, const std::string& extension,
            const std::function<void(const std::filesystem::path&)>& write);

  /// The parts of the last key of that kind that was remembered for `name`; nothing: none.
  std::optional<std::vector<Key::Part>> recall(const std::string& name, const Key& key) const;
  /// Remembers the key as the last one of `name`, e.g. a product of a scene, and returns the parts
  /// of the key before it; nothing if `name` is new.
  std::optional<std::vector<Key::Part>> remember(const std::string& name, const Key& key);

  const std::filesystem::path& folder() const { return options_.folder; }
  uint64_t max_bytes() const { return options_.max_bytes; }
  bool is_writable() const { return writable_; }

 private:
  void warn(const std::string& why);
  std::optional<Entry> find_here(const Key& key);
  std::optional<Entry> fetch(const Key& key);
  void send(const std::string& key, const std::string& object);

  StoreOptions options_;
  std::unique_ptr<Remote> remote_;
  bool writable_ = false;
  std::atomic<bool> warned_ = false;
};
using StorePtr = std::shared_ptr<Store>;

}  // namespace vug::store
