// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/reader.h>

#include <vug/survey_files/text_encoding.h>
#include <vug/survey_files/text_lines.h>

#include <algorithm>

namespace vug::survey::svx {

namespace {

/// Storage for the stations and legs of a text of mostly data lines. Growing step by step would
/// copy them several times. The limit keeps what texts without data claim small.
void reserve_for_lines(Reader& reader, std::string_view text) {
  constexpr ptrdiff_t kMost = 1 << 17;
  const ptrdiff_t lines = std::count(text.begin(), text.end(), '\n') + 1;
  const auto count = static_cast<size_t>(std::min(lines, kMost));
  reader.stations.reserve(count);
  reader.out.legs.reserve(count);
}

}  // namespace

void Reader::read(std::string_view text) {
  if (file_names.empty()) reserve_for_lines(*this, text);
  const std::string& name = file_names.emplace_back(files.current().string());
  const size_t outside = std::exchange(outer_scopes, scopes.size());
  TextLines lines(text, name);
  while (lines.next()) {
    if (lines.line().find('\0') != std::string_view::npos)
      lines.fail("the line contains a NUL byte", "a .svx file is a text in ASCII or UTF-8");
    const std::shared_ptr<const Characters> characters = settings.characters;
    Line line(lines.line(), name, lines.number(), *characters);
    if (line.is(line.peek(), kKeyword)) {
      line.skip(1);
      run_command(*this, line);
    } else {
      read_data_line(*this, line);
    }
  }
  if (scopes.size() > outer_scopes)
    throw Error(ErrorCode::bad_input, "*begin without *end in this file", scopes.back().where,
                "each *begin has one *end in the same file");
  outer_scopes = outside;
  traverse = {};
}

void include_file(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string name = line.text();
  if (name.empty()) line.fail_expected("the name of a file", "e.g. *include cave/entrance");
  const SourceLocation where = line.range(start);
  line.require_end();
  const std::string text = as_utf8(reader.files.enter(name, ".svx", where));
  // The settings of the included file last, except its survey.
  const std::string survey = reader.settings.survey;
  reader.read(text);
  reader.files.leave();
  reader.settings.survey = survey;
}

}  // namespace vug::survey::svx
