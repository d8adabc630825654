// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/store/remote.h>

#include <fmt/format.h>
#include <httplib.h>

#include <fstream>
#include <regex>
#include <vector>

namespace vug::store {

namespace fs = std::filesystem;

namespace {

constexpr int kConnectSeconds = 3, kTransferSeconds = 60;
constexpr int kFound = 200, kRefused = 400, kBroken = 500;

std::string answer_of(int status) { return fmt::format("its answer is HTTP {}", status); }

}  // namespace

Remote::Remote(const std::string& url, std::function<void(const std::string&)> on_warning)
    : on_warning_(std::move(on_warning)) {
  static const std::regex form(
      R"((https?://(?:\[[0-9a-fA-F:]+\]|[^/?#@:\s]+)(?::\d{1,5})?)(/[^?#\s]*)?)");
  std::smatch parts;
  if (!std::regex_match(url, parts, form))
    throw Error(
        ErrorCode::bad_input, fmt::format("'{}' is not the address of a store", url), {},
        "set VUG_CACHE_REMOTE to http://HOST, http://HOST:PORT/PATH, or the same with https");
  host_ = parts[1];
  path_ = parts[2];
  if (!path_.ends_with('/')) path_ += '/';
}

std::unique_ptr<httplib::Client> Remote::connect() const {
  auto out = std::make_unique<httplib::Client>(host_);
  out->set_connection_timeout(kConnectSeconds);
  out->set_read_timeout(kTransferSeconds);
  out->set_write_timeout(kTransferSeconds);
  return out;
}

bool Remote::fails(const std::string& reason) {
  if (reachable_.exchange(false) && on_warning_)
    on_warning_(fmt::format("the store at {}{} does not answer ({}); this run uses the local one",
                            host_, path_, reason));
  return false;
}

bool Remote::has(const std::string& name) {
  if (!reachable_) return false;
  const httplib::Result result = connect()->Head(path_ + name);
  if (!result) return fails(to_string(result.error()));
  return result->status >= kBroken ? fails(answer_of(result->status)) : result->status == kFound;
}

bool Remote::get(const std::string& name, const fs::path& target) {
  if (!reachable_) return false;
  std::ofstream out(target, std::ios::binary);
  int status = 0;
  const httplib::Result result = connect()->Get(
      path_ + name,
      [&](const httplib::Response& response) {
        status = response.status;
        return status == kFound;
      },
      [&](const char* data, size_t count) {
        return out.write(data, static_cast<std::streamsize>(count)).good();
      });
  // A handler that stops the transfer makes it fail with this error: no such file, or a full disk.
  if (!result && result.error() != httplib::Error::Canceled)
    return fails(to_string(result.error()));
  if (status >= kBroken) return fails(answer_of(status));
  return result && status == kFound && out.flush();
}

void Remote::put(const std::string& name, const fs::path& source) {
  if (!reachable_ || !writable_) return;
  std::error_code gone;  // Another process may have removed the file since.
  const uintmax_t bytes = fs::file_size(source, gone);
  if (gone) return;
  std::ifstream in(source, std::ios::binary);
  std::vector<char> part(1 << 16);
  const httplib::Result result = connect()->Put(
      path_ + name, bytes,
      [&](size_t, size_t length, httplib::DataSink& sink) {
        in.read(part.data(), static_cast<std::streamsize>(std::min(length, part.size())));
        return in.gcount() > 0 && sink.write(part.data(), static_cast<size_t>(in.gcount()));
      },
      "application/octet-stream");
  if (!result && result.error() != httplib::Error::Canceled)  // The file ended too early.
    fails(to_string(result.error()));
  else if (result && result->status >= kBroken)
    fails(answer_of(result->status));
  else if (result && result->status >= kRefused)
    writable_ = false;
}

}  // namespace vug::store
