// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/svx/reader.h>

#include <vug/base/atomic_file.h>
#include <vug/survey/svx/files.h>
#include <vug/survey/text_encoding.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::svx {
namespace {

/// Calls `use` with each line, without its end, and its number. Lines end in LF, CR or CR LF.
template <class Use>
void for_each_line(std::string_view bytes, const Use& use) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  for (int number = 1; !bytes.empty(); ++number) {
    const size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    use(bytes.substr(0, end), number);
    const bool both = bytes.substr(end).starts_with("\r\n");
    bytes.remove_prefix(std::min(bytes.size(), end + (both ? 2 : 1)));
  }
}

}  // namespace

Reader::Reader(const std::filesystem::path& file, const ReadOptions& read_options,
               Diagnostics& notes)
    : options(read_options),
      warnings(notes),
      root(canonical_folder(options.root.empty() ? file.parent_path() : options.root)) {}

void Reader::read(std::string_view bytes, const std::filesystem::path& file) {
  bytes_read += bytes.size();
  if (bytes_read > options.max_bytes)
    throw Error(ErrorCode::too_large,
                fmt::format("the files of the survey have more than {} bytes", options.max_bytes),
                {}, "raise the limit if the files are correct");
  const std::string& name = file_names.emplace_back(file.string());
  files.push_back(file);
  const size_t outside = std::exchange(outer_scopes, scopes.size());
  for_each_line(bytes, [&](std::string_view text, int number) {
    if (text.find('\0') != std::string_view::npos)
      throw Error(ErrorCode::bad_input, "the line contains a NUL byte", {name, number, 1},
                  "a .svx file is a text in ASCII or UTF-8");
    const std::shared_ptr<const Characters> characters = settings.characters;
    Line line(text, name, number, *characters);
    if (!line.is(line.peek(), kKeyword)) return read_data_line(*this, line);
    line.skip(1);
    run_command(*this, line);
  });
  if (scopes.size() > outer_scopes)
    throw Error(ErrorCode::bad_input, "*begin without *end in this file", scopes.back().where,
                "each *begin has one *end in the same file");
  outer_scopes = outside;
  traverse = {};
  files.pop_back();
}

void include_file(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string name = line.text();
  if (name.empty()) line.fail_expected("the name of a file", "e.g. *include cave/entrance");
  const SourceLocation where = line.range(start);
  line.require_end();
  const std::filesystem::path file =
      find_included({name, where, reader.files, reader.root, reader.options.allow_outside});
  const std::string bytes = as_utf8(read_text(file));
  // The settings of the included file last, except its survey.
  const std::string survey = reader.settings.survey;
  reader.read(bytes, file);
  reader.settings.survey = survey;
}

}  // namespace vug::survey::svx
