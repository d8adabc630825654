// SPDX-License-Identifier: Apache-2.0
// VUG_FUZZ_TARGET(name) { ... } defines a fuzz target: a function of the bytes `data` and their
// number `size`. libFuzzer links one target into each program; the program `replay` contains all
// targets, by their names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace vug::fuzzing {

using Target = void (*)(const uint8_t* data, size_t size);

/// The targets of this program.
inline std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> all;
  return all;
}

/// Adds a target before main starts.
struct Registration {
  Registration(const char* name, Target target) { targets().emplace(name, target); }
};

}  // namespace vug::fuzzing

#define VUG_FUZZ_TARGET(name)                                                         \
  static void fuzz_##name(const uint8_t* data, size_t size);                          \
  static const vug::fuzzing::Registration registration_of_##name(#name, fuzz_##name); \
  static void fuzz_##name(const uint8_t* data, size_t size)
