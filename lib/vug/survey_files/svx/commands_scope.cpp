// SPDX-License-Identifier: Apache-2.0
// The commands that begin and end surveys.
#include <vug/survey_files/svx/commands.h>

#include <fmt/format.h>

namespace vug::survey::svx {
namespace {

constexpr size_t kMaxScopes = 1000;

}  // namespace

void command_begin(Reader& reader, Line& line) {
  if (reader.scopes.size() >= kMaxScopes)
    line.fail(0, fmt::format("more than {} nested *begin", kMaxScopes), "each *begin has one *end");
  const SourceLocation where = line.range(0);
  reader.scopes.push_back({reader.settings, where});
  if (!line.at_end())
    reader.settings.survey = StationTable::read_survey(line, reader.settings, reader.warnings);
}

void command_end(Reader& reader, Line& line) {
  if (reader.scopes.size() <= reader.outer_scopes)
    line.fail(0, "*end without *begin in this file", "each *begin has one *end in the same file");
  const Settings& before = reader.scopes.back().before;
  line.at_end();
  const size_t start = line.position();
  const bool named = reader.settings.survey != before.survey;
  const std::string expected =
      named && !before.survey.empty() && reader.settings.survey.starts_with(before.survey + ".")
          ? reader.settings.survey.substr(before.survey.size() + 1)
          : reader.settings.survey;
  if (!line.at_end()) {
    const std::string found = StationTable::read_survey(line, before, reader.warnings);
    if (!named)
      line.fail(start, "*end names a survey, but its *begin does not", "write '*end' only");
    if (found != reader.settings.survey)
      line.fail(start,
                fmt::format("*end does not match '*begin {}' in line {}", expected,
                            reader.scopes.back().where.line),
                fmt::format("write '*end {}'", expected));
  } else if (named) {
    reader.warnings.warning(line.range(0),
                            fmt::format("*end of survey '{}' without its name", expected),
                            fmt::format("write '*end {}'", expected));
  }
  reader.settings = std::move(reader.scopes.back().before);
  reader.scopes.pop_back();
  reader.traverse = {};
  reader.in_tube = false;
}

void command_prefix(Reader& reader, Line& line) {
  reader.warnings.warning(line.range(0), "*prefix is deprecated", "use *begin and *end");
  const char next = line.peek();
  Settings& settings = reader.settings;
  const bool root = line.is(next, kRoot) && line.word_at(line.position()).end_column ==
                                                line.word_at(line.position()).column + 1;
  if (root) {
    line.skip(1);
    settings.survey.clear();
    return;
  }
  settings.survey = StationTable::read_survey(line, settings, reader.warnings);
}

}  // namespace vug::survey::svx
