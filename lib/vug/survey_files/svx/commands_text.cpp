// SPDX-License-Identifier: Apache-2.0
// The commands about names, characters and texts, and the flags of legs.
#include <vug/survey_files/svx/commands.h>

#include <fmt/format.h>

#include <map>

namespace vug::survey::svx {
namespace {

const std::map<std::string, CharacterClass>& class_names() {
  static const std::map<std::string, CharacterClass> all = {
      {"blank", kBlank}, {"comment", kComment},    {"decimal", kDecimal}, {"keyword", kKeyword},
      {"minus", kMinus}, {"names", kName},         {"omit", kOmit},       {"plus", kPlus},
      {"root", kRoot},   {"separator", kSeparator}};
  return all;
}

/// The value of a hexadecimal digit, or -1.
int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int letter = (c | 0x20) - 'a';
  return letter >= 0 && letter < 6 ? 10 + letter : -1;
}

}  // namespace

bool read_switch(Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string word = line.keyword();
  if (word == "on" || word == "off") return word == "on";
  line.set_position(start);
  line.fail_expected("'on' or 'off'", "e.g. *infer plumbs on");
}

void command_alias(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const bool station = line.keyword() == "station";
  if (!station || line.word() != "-")
    line.fail(start, "*alias defines '-' only", "write '*alias station - ..'");
  if (line.at_end()) {
    reader.settings.hyphen_is_wall = false;
    return;
  }
  if (line.word() != "..")
    line.fail(start, "*alias defines '-' as '..' only", "write '*alias station - ..'");
  reader.settings.hyphen_is_wall = true;
}

void command_case(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string word = line.keyword();
  LetterCase& letter_case = reader.settings.letter_case;
  if (word == "preserve")
    letter_case = LetterCase::preserve;
  else if (word == "toupper")
    letter_case = LetterCase::upper;
  else if (word == "tolower")
    letter_case = LetterCase::lower;
  else {
    line.set_position(start);
    line.fail_expected("'preserve', 'toupper' or 'tolower'", "e.g. *case preserve");
  }
}

void command_flags(Reader& reader, Line& line) {
  Settings& settings = reader.settings;
  while (!line.at_end()) {
    size_t start = line.position();
    std::string word = line.keyword();
    const bool value = word != "not";
    if (!value) {
      line.peek();
      start = line.position();
      word = line.keyword();
    }
    if (word == "surface")
      settings.surface = value;
    else if (word == "duplicate")
      settings.duplicate = value;
    else if (word == "splay")
      settings.splay = value;
    else {
      line.set_position(start);
      line.fail_expected("a flag", suggestion(word, {"surface", "duplicate", "splay"}));
    }
  }
}

void command_infer(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string word = line.keyword();
  Settings& settings = reader.settings;
  if (word == "plumbs") {
    settings.infer_plumbs = read_switch(line);
  } else if (word == "equates") {
    settings.infer_equates = read_switch(line);
  } else if (word == "exports") {
    settings.infer_exports = read_switch(line);
  } else {
    line.set_position(start);
    line.fail_expected("'plumbs', 'equates' or 'exports'", "e.g. *infer plumbs on");
  }
}

void command_require(Reader&, Line& line) {
  const std::string version = line.word();
  if (version.empty() || version.find_first_not_of("0123456789.") != std::string::npos)
    line.fail(0, fmt::format("'{}' is not a version of Survex", version), "e.g. *require 1.2.3");
}

void command_set(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string name = line.keyword();
  const auto found = class_names().find(name);
  if (found == class_names().end()) {
    std::vector<std::string> known;
    for (const auto& [each, value] : class_names()) known.push_back(each);
    line.set_position(start);
    line.fail_expected("a class of characters", suggestion(name, known));
  }
  auto changed = std::make_shared<Characters>(*reader.settings.characters);
  changed->clear(found->second);
  line.peek();
  for (char c = line.at(0); c != 0 && !line.is(c, kBlank) && !line.is(c, kComment);
       c = line.at(0)) {
    const int high = hexadecimal(line.at(1)), low = hexadecimal(line.at(2));
    if (c == 'x' && high >= 0 && low >= 0) {
      changed->add(static_cast<char>(16 * high + low), found->second);
      line.skip(3);
      continue;
    }
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))
      line.fail(line.position(), "letters and digits have a fixed meaning",
                "write other characters as x and two hexadecimal digits, e.g. x2C");
    changed->add(c, found->second);
    line.skip(1);
  }
  line.require_end();
  reader.traverse = {};  // Its lines refer to the characters.
  reader.settings.characters = changed;
}

void command_title(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string title = line.text();
  if (title.empty()) line.fail(start, "*title without a text", "write *title \"Name of the cave\"");
  if (reader.out.title.empty()) reader.out.title = title;
}

void command_truncate(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  if (line.keyword() == "off") {
    reader.settings.truncate = SIZE_MAX;
    return;
  }
  line.set_position(start);
  const double length = line.number("a number of characters or 'off'");
  if (length < 1 || length > 1000)
    line.fail(start, "names are truncated to 1 to 1000 characters",
              "e.g. *truncate 8 or *truncate off");
  reader.settings.truncate = static_cast<size_t>(length);
}

}  // namespace vug::survey::svx
