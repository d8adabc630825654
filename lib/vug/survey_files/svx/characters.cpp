// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/characters.h>

#include <string_view>
#include <utility>

namespace vug::survey::svx {

Characters::Characters() {
  constexpr std::pair<CharacterClass, std::string_view> kInitial[] = {
      {kBlank, " \t,"}, {kComment, ";"}, {kDecimal, "."}, {kKeyword, "*"}, {kMinus, "-"},
      {kName, "_-"},    {kOmit, "-"},    {kPlus, "+"},    {kRoot, "\\"},   {kSeparator, "."}};
  for (const auto& [in, all] : kInitial)
    for (const char c : all) add(c, in);
  clear(kName);
  for (const char c : std::string_view("_-")) add(c, kName);
}

void Characters::clear(CharacterClass in) {
  for (uint16_t& each : classes_) each = static_cast<uint16_t>(each & ~in);
  if (in != kName) return;
  const auto add_range = [&](char first, char last) {
    for (char c = first; c <= last; ++c) add(c, kName);
  };
  add_range('0', '9');
  add_range('A', 'Z');
  add_range('a', 'z');
}

}  // namespace vug::survey::svx
