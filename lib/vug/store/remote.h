// SPDX-License-Identifier: Apache-2.0
// Internal to store/: a store on a web server, which answers GET, HEAD and PUT for the files of
// kObjects and kActions.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace httplib {
class Client;
}

namespace vug::store {

/// After the first request that the server does not answer, or answers with an error of its own
/// (5xx), all others fail at once. Thread-safe.
class Remote {
 public:
  /// `url` is http://HOST[:PORT][/PATH], or https://. Throws Error(bad_input) for others.
  /// `on_warning` is called once, with a sentence, if the server does not answer.
  Remote(const std::string& url, std::function<void(const std::string&)> on_warning);

  bool has(const std::string& name);
  /// Writes a file of the server to `target`; false if there is none.
  bool get(const std::string& name, const std::filesystem::path& target);
  /// Sends a file. A server that refuses files is only read.
  void put(const std::string& name, const std::filesystem::path& source);

 private:
  std::unique_ptr<httplib::Client> connect() const;
  bool fails(const std::string& reason);

  std::string host_;  ///< With scheme and port.
  std::string path_;  ///< Ends with "/".
  std::function<void(const std::string&)> on_warning_;
  std::atomic<bool> reachable_ = true;
  std::atomic<bool> writable_ = true;
};

}  // namespace vug::store
