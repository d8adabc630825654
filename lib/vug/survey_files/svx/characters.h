// SPDX-License-Identifier: Apache-2.0
// The classes of characters of .svx files, which the command *set changes.
#pragma once

#include <array>
#include <cstdint>

namespace vug::survey::svx {

enum CharacterClass : uint16_t {
  kBlank = 1,
  kComment = 2,
  kDecimal = 4,
  kKeyword = 8,
  kMinus = 16,
  kName = 32,
  kOmit = 64,
  kPlus = 128,
  kRoot = 256,
  kSeparator = 512,
};

/// The classes of each byte, as a sum of the values above.
class Characters {
 public:
  /// The classes at the start of a file. Letters and digits are always in names.
  Characters();

  bool is(char c, CharacterClass in) const { return (classes_[static_cast<uint8_t>(c)] & in) != 0; }
  void add(char c, CharacterClass to) { classes_[static_cast<uint8_t>(c)] |= to; }
  /// Empties a class; names keep letters and digits.
  void clear(CharacterClass in);

 private:
  std::array<uint16_t, 256> classes_{};
};

}  // namespace vug::survey::svx
