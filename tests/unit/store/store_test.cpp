// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/store/maintenance.h>
#include <vug/store/store.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

namespace vug::store {
namespace {

namespace fs = std::filesystem;

const ProductKind kKind{"text", 1};

Key key_of(int number, int epoch = 1) {
  return Key(ProductKind{"text", epoch}).add("number", number).add("other", 7);
}
std::string content_of(int number) {
  return std::string(1000 + static_cast<size_t>(number), static_cast<char>('a' + number % 26));
}
void keep(Store& store, int number) {
  store.keep(key_of(number), 1.5, ".txt", [&](const fs::path& file) {
    std::ofstream(file, std::ios::binary) << content_of(number);
  });
}
/// The content for a number; nothing if it is absent, or if another process has removed it since.
std::optional<std::string> load(Store& store, int number) {
  const auto entry = store.find(key_of(number));
  if (!entry) return std::nullopt;
  try {
    return read_text(entry->object);
  } catch (const Error&) {
    return std::nullopt;
  }
}
std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& each : fs::recursive_directory_iterator(folder))
    if (each.is_regular_file()) out.push_back(each.path());
  std::sort(out.begin(), out.end());
  return out;
}

struct StoreTest : testing::Test {
  ScratchFolder scratch{"vug_store_test"};
  Store store{{scratch.path(), 1'000'000'000}};
};

TEST_F(StoreTest, FindsWhatWasKept) {
  EXPECT_FALSE(store.contains(key_of(3)));
  EXPECT_FALSE(load(store, 3));
  keep(store, 3);
  EXPECT_TRUE(store.contains(key_of(3)));
  EXPECT_EQ(load(store, 3), content_of(3));
  EXPECT_EQ(store.find(key_of(3))->seconds, 1.5);
  EXPECT_EQ(store.find(key_of(3))->object.extension(), ".txt");
  EXPECT_FALSE(load(store, 4));
  EXPECT_FALSE(store.find(key_of(3, 2))) << "another epoch";
}

TEST_F(StoreTest, KeysDependOnKindEpochNamesAndValues) {
  const Key key = key_of(1);
  EXPECT_EQ(key.digest(), key_of(1).digest());
  EXPECT_NE(key.digest(), key_of(2).digest());
  EXPECT_NE(key.digest(), key_of(1, 2).digest());
  EXPECT_NE(key.digest(), Key(ProductKind{"other", 1}).add("number", 1).add("other", 7).digest());
  EXPECT_NE(key.digest(), Key(kKind).add("digit", 1).add("other", 7).digest());
  EXPECT_NE(key.digest(), Key(kKind).add("number", 1).digest());
}

TEST_F(StoreTest, EqualContentsShareAFile) {
  keep(store, 1);
  store.keep(key_of(2), 1, ".txt",
             [&](const fs::path& file) { std::ofstream(file, std::ios::binary) << content_of(1); });
  EXPECT_EQ(files_below(scratch.path() / "objects").size(), 1u);
  EXPECT_EQ(load(store, 2), content_of(1));
}

// Every file of the store, damaged in every way: the product is absent, and can be kept again.
TEST_F(StoreTest, DamagedFilesCountAsAbsent) {
  const auto truncate = [](const fs::path& file) {
    fs::resize_file(file, fs::file_size(file) / 2);
  };
  const auto clear = [](const fs::path& file) { fs::resize_file(file, 0); };
  const auto remove = [](const fs::path& file) { fs::remove(file); };
  const auto flip = [](const fs::path& file) {
    std::fstream io(file, std::ios::binary | std::ios::in | std::ios::out);
    io.seekg(static_cast<std::streamoff>(fs::file_size(file) / 2));
    const char byte = static_cast<char>(io.get() ^ 4);
    io.seekp(static_cast<std::streamoff>(fs::file_size(file) / 2));
    io.put(byte);
  };
  const std::vector<std::function<void(const fs::path&)>> damages = {truncate, clear, remove, flip};
  keep(store, 5);
  const size_t count = files_below(scratch.path()).size();
  ASSERT_EQ(count, 2u);
  for (size_t which = 0; which < count; ++which)
    for (size_t damage = 0; damage < damages.size(); ++damage) {
      SCOPED_TRACE(testing::Message() << "file " << which << " damage " << damage);
      ASSERT_EQ(load(store, 5), content_of(5));
      damages[damage](files_below(scratch.path())[which]);
      EXPECT_FALSE(load(store, 5));
      keep(store, 5);
    }
  EXPECT_EQ(load(store, 5), content_of(5));
}

TEST_F(StoreTest, AnEntryInThePlaceOfAnotherIsNotUsed) {
  keep(store, 1);
  keep(store, 2);
  const std::vector<fs::path> entries = files_below(scratch.path() / "actions");
  ASSERT_EQ(entries.size(), 2u);
  fs::copy_file(entries[0], entries[1], fs::copy_options::overwrite_existing);
  EXPECT_NE(load(store, 1).has_value(), load(store, 2).has_value());
}

TEST_F(StoreTest, VerifyRemovesExactlyTheDamagedFiles) {
  for (int i = 0; i < 20; ++i) keep(store, i);
  EXPECT_EQ(verify(scratch.path()).intact, 40u);
  const std::vector<fs::path> objects = files_below(scratch.path() / "objects");
  for (size_t i = 0; i < 5; ++i) fs::resize_file(objects[i], 10);
  const VerifyReport report = verify(scratch.path());
  EXPECT_EQ(report.damaged, 5u);
  EXPECT_EQ(report.intact, 35u);
  EXPECT_EQ(verify(scratch.path()).damaged, 0u);
}

// The bound holds for the whole folder, and what was used last remains.
TEST(StoreBound, RemovesTheLeastRecentlyUsed) {
  const ScratchFolder scratch("vug_store_test");
  const uint64_t most = 64'000;
  Store store({scratch.path(), most});
  for (int i = 0; i < 400; ++i) {
    keep(store, i);
    EXPECT_EQ(load(store, i), content_of(i)) << "the newest product remains";
  }
  EXPECT_LE(statistics(scratch.path()).bytes, most);
  EXPECT_GT(statistics(scratch.path()).bytes, most / 4);
}

TEST_F(StoreTest, TrimKeepsWhatWasUsedLast) {
  for (int i = 0; i < 10; ++i) {
    keep(store, i);
    const auto age = std::chrono::hours(100 - i);
    fs::last_write_time(store.find(key_of(i))->object, fs::file_time_type::clock::now() - age);
  }
  load(store, 0);  // Used again.
  const TrimReport report = trim(scratch.path(), 3500);
  EXPECT_EQ(report.files, 7u);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(store.contains(key_of(i)), i == 0 || i >= 8) << i;
  EXPECT_EQ(files_below(scratch.path() / "actions").size(), 3u) << "entries without product";
}

TEST_F(StoreTest, AFolderThatCannotBeWrittenIsSilent) {
  std::string warning;
  Store none({"/proc/vug_store", 1000, [&](const std::string& text) { warning = text; }});
  EXPECT_FALSE(none.is_writable());
  keep(none, 1);
  EXPECT_FALSE(load(none, 1));
  EXPECT_FALSE(none.remember("name", key_of(1)));
  EXPECT_EQ(warning, "");
}

TEST_F(StoreTest, AFailureToWriteIsOneWarning) {
  int warnings = 0;
  Store other({scratch.path(), 1'000'000, [&](const std::string&) { ++warnings; }});
  for (int i = 0; i < 3; ++i)
    other.keep(key_of(i), 1, "",
               [](const fs::path&) { throw std::runtime_error("no space left"); });
  EXPECT_EQ(warnings, 1);
  EXPECT_TRUE(files_below(scratch.path()).empty()) << "no temporary files remain";
}

TEST_F(StoreTest, NamesTheChangedPartsOfAKey) {
  EXPECT_FALSE(store.remember("scene/rock", key_of(1)));
  EXPECT_EQ(changed_parts(*store.remember("scene/rock", key_of(1)), key_of(1)),
            std::vector<std::string>());
  EXPECT_EQ(changed_parts(*store.remember("scene/rock", key_of(2)), key_of(2)),
            std::vector<std::string>{"number"});
  EXPECT_FALSE(store.remember("scene/other", key_of(2)));
}

// Four processes keep, find and trim in the same folder at once: each product is absent or right.
TEST_F(StoreTest, ManyProcessesShareAFolder) {
  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child) {
    const pid_t pid = fork();
    if (pid == 0) {
      Store mine({scratch.path(), 100'000});
      int wrong = 0;
      for (int step = 0; step < 300; ++step) {
        const int number = (step * 7 + child * 13) % 40;
        const auto found = load(mine, number);
        if (found && *found != content_of(number)) ++wrong;
        if (!found) keep(mine, number);
        if (step % 50 == child) trim(scratch.path(), 20'000);
        if (step % 70 == child) verify(scratch.path());
      }
      _exit(wrong > 0);
    }
    children.push_back(pid);
  }
  for (const pid_t pid : children) {
    int status = 0;
    waitpid(pid, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(verify(scratch.path()).damaged, 0u);
}

// A process that is killed at any moment leaves no wrong product and no damaged file in place.
TEST_F(StoreTest, KilledProcessesLeaveNoDamage) {
  for (int round = 0; round < 50; ++round) {
    const pid_t pid = fork();
    if (pid == 0) {
      Store mine({scratch.path(), 1'000'000});
      for (int number = 0;; ++number) keep(mine, number % 200);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500 + 137 * round));
    kill(pid, SIGKILL);
    int status = 0;
    waitpid(pid, &status, 0);
    for (int number = 0; number < 200; number += 17) {
      const auto found = load(store, number);
      EXPECT_TRUE(!found || *found == content_of(number));
    }
  }
  EXPECT_EQ(verify(scratch.path()).damaged, 0u);
}

}  // namespace
}  // namespace vug::store
