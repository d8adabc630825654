// SPDX-License-Identifier: Apache-2.0
// Writes the bytes of a fuzzer to a file, for readers that take a path.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

/// One file for the whole run; each call replaces its contents.
inline const std::filesystem::path& file_of_bytes(const uint8_t* data, size_t size,
                                                  const std::string& suffix) {
  static const struct Scratch {
    std::filesystem::path path;
    explicit Scratch(const std::string& end)
        : path(std::filesystem::temp_directory_path() /
               ("vug_fuzz_" + std::to_string(getpid()) + end)) {}
    ~Scratch() {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }
  } scratch(suffix);
  std::ofstream out(scratch.path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return scratch.path;
}
