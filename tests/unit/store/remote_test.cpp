// SPDX-License-Identifier: Apache-2.0
// Stores that share products through a web server.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/store/store.h>

#include <gtest/gtest.h>
#include <httplib.h>

#include <fstream>
#include <map>
#include <mutex>
#include <thread>

namespace vug::store {
namespace {

namespace fs = std::filesystem;

/// A server that keeps the bodies of PUT requests and returns them.
class FileServer {
 public:
  FileServer() {
    server_.Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
      const std::lock_guard lock(mutex_);
      ++gets;
      const auto file = files.find(request.path);
      if (broken)
        response.status = 503;
      else if (file == files.end())
        response.status = 404;
      else
        response.set_content(file->second, "application/octet-stream");
    });
    server_.Put(".*", [this](const httplib::Request& request, httplib::Response& response) {
      const std::lock_guard lock(mutex_);
      ++puts;
      response.status = refuse ? 403 : 201;
      if (!refuse) files[request.path] = request.body;
    });
    port_ = server_.bind_to_any_port("127.0.0.1");
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::yield();
  }
  ~FileServer() { stop(); }
  void stop() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/cave"; }

  std::map<std::string, std::string> files;
  int gets = 0, puts = 0;
  bool refuse = false, broken = false;

 private:
  httplib::Server server_;
  std::mutex mutex_;
  std::thread thread_;
  int port_ = 0;
};

const Key& key() {
  static const Key out = Key(ProductKind{"text", 1}).add("number", 3);
  return out;
}

struct RemoteStore : testing::Test {
  ScratchFolder scratch{"vug_remote_store"};
  FileServer server;
  std::vector<std::string> warnings;

  Store store(const std::string& name) {
    return Store({scratch.path() / name, 1'000'000'000,
                  [this](const std::string& text) { warnings.push_back(text); }, server.url()});
  }
  static void keep(Store& store, const std::string& text = "rock", const Key& of = key()) {
    store.keep(of, 1.5, ".txt",
               [&](const fs::path& file) { std::ofstream(file, std::ios::binary) << text; });
  }
  static std::string text_in(Store& store) {
    const auto entry = store.find(key());
    return entry ? read_text(entry->object) : "absent";
  }
};

TEST_F(RemoteStore, GivesOneMachineTheProductsOfAnother) {
  Store first = store("a"), second = store("b");
  EXPECT_FALSE(second.contains(key()));
  EXPECT_EQ(text_in(second), "absent");
  keep(first);
  EXPECT_TRUE(second.contains(key()));
  EXPECT_EQ(text_in(second), "rock");
  EXPECT_DOUBLE_EQ(second.find(key())->seconds, 1.5);
  server.stop();
  EXPECT_EQ(text_in(second), "rock") << "the copy stays";
  EXPECT_TRUE(warnings.empty());
}

TEST_F(RemoteStore, SendsEachContentOnce) {
  Store first = store("a");
  keep(first);
  EXPECT_EQ(server.puts, 2) << "a product and its action";
  keep(first, "rock", Key(ProductKind{"text", 1}).add("number", 4));
  EXPECT_EQ(server.puts, 3) << "an action for the same product";
}

TEST_F(RemoteStore, RefusesDamagedFiles) {
  Store first = store("a");
  keep(first);
  for (auto& [name, content] : server.files) {
    const std::string intact = content;
    for (const std::string& damaged :
         {std::string("x") + intact.substr(1), intact.substr(1), intact + "x", std::string()}) {
      content = damaged;
      Store second = store("b");
      EXPECT_EQ(text_in(second), "absent") << name;
      fs::remove_all(scratch.path() / "b");
    }
    content = intact;
  }
  Store second = store("b");
  EXPECT_EQ(text_in(second), "rock");
}

TEST_F(RemoteStore, StaysInItsFolder) {
  Store first = store("a");
  keep(first);
  const fs::path outside = scratch.path() / "outside.txt";
  write_text(outside, "mine");
  const std::string intact = vug::digest("rock").hex() + ".txt";
  server.files["/cave/objects/../../" + intact] = "rock";
  // Actions with a correct seal whose object leads elsewhere: to a file, and to a new one.
  for (const std::string& object : {std::string("../outside.txt"), "../" + intact}) {
    for (auto& [name, content] : server.files) {
      if (name.find("/actions/") == std::string::npos) continue;
      std::string text = content.substr(0, content.size() - 33);
      const size_t begin = text.find(" text ") + 6;
      text.replace(begin, text.find(' ', begin) - begin, object);
      content = text + vug::digest(text).hex() + "\n";
    }
    Store second = store("b");
    EXPECT_EQ(text_in(second), "absent") << object;
  }
  EXPECT_TRUE(fs::exists(outside)) << "files whose digest is wrong are removed";
  EXPECT_FALSE(fs::exists(scratch.path() / intact));
}

TEST_F(RemoteStore, OnlyReadsAServerThatRefusesFiles) {
  server.refuse = true;
  Store first = store("a");
  keep(first);
  keep(first, "other", Key(ProductKind{"text", 1}).add("number", 4));
  EXPECT_EQ(server.puts, 1) << "it does not try again";
  EXPECT_EQ(text_in(first), "rock");
  EXPECT_TRUE(warnings.empty());
}

TEST_F(RemoteStore, WorksWithoutAServerThatReportsAnError) {
  server.broken = true;
  Store first = store("a");
  EXPECT_EQ(text_in(first), "absent");
  keep(first);
  EXPECT_EQ(text_in(first), "rock");
  EXPECT_EQ(server.gets, 1) << "it does not try again";
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("HTTP 503"), std::string::npos) << warnings[0];
}

TEST_F(RemoteStore, WorksWithoutTheServerAfterOneWarning) {
  server.stop();
  Store first = store("a");
  EXPECT_EQ(text_in(first), "absent");
  keep(first);
  EXPECT_EQ(text_in(first), "rock");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("does not answer"), std::string::npos) << warnings[0];
}

TEST(RemoteStoreAddress, IsChecked) {
  const ScratchFolder folder("vug_remote_store");
  for (const char* bad : {"ftp://a/b", "localhost:80", "http://", "http://a b", "http://a?x=1"})
    EXPECT_THROW(Store({folder.path(), 0, nullptr, bad}), Error) << bad;
  for (const char* good : {"http://a", "https://a:8443/b/c/", "http://[::1]:80"})
    EXPECT_NO_THROW(Store({folder.path(), 0, nullptr, good})) << good;
}

}  // namespace
}  // namespace vug::store
