// SPDX-License-Identifier: Apache-2.0
#include <vug/base/dynamic_library.h>
#include <vug/base/error.h>

#include <gtest/gtest.h>

namespace vug {
namespace {

constexpr const char* kFiles[] = {"libno_such_library.so.9", "libm.so.6"};

template <class Work>
std::string error_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_EQ(error.hint(), "install it");
    return error.what();
  }
  return "";
}

TEST(DynamicLibrary, IsTheFirstFileThatExists) {
  double (*truncate)(double) = nullptr;
  DynamicLibrary(kFiles, "the library", "install it").find("trunc", truncate);
  EXPECT_EQ(truncate(-2.5), -2);
}

TEST(DynamicLibrary, ErrorsNameTheReason) {
  const std::string missing =
      error_of([] { DynamicLibrary(std::span(kFiles).first(1), "the library", "install it"); });
  EXPECT_TRUE(missing.starts_with("the library cannot be loaded: libno_such_library.so.9"))
      << missing;
  double (*function)(double) = nullptr;
  EXPECT_EQ(error_of([&] {
              DynamicLibrary(kFiles, "the library", "install it").find("no_such", function);
            }),
            "the library lacks the function no_such");
}

}  // namespace
}  // namespace vug
