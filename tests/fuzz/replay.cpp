// SPDX-License-Identifier: Apache-2.0
// replay TARGET FOLDER: runs a fuzz target over the files of a folder, without libFuzzer: the
// corpus as a test.
#include "target.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

int main(int argc, char** argv) {
  const auto& targets = vug::fuzzing::targets();
  const auto target = argc == 3 ? targets.find(argv[1]) : targets.end();
  if (target == targets.end()) {
    std::fprintf(stderr, "usage: replay TARGET FOLDER, where TARGET is one of\n");
    for (const auto& [name, function] : targets) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[2])) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    target->second(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    ++files;
  }
  std::printf("%d inputs replayed\n", files);
  return files > 0 ? 0 : 1;
}
