// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/svx/commands.h>

#include <fmt/format.h>

#include <map>

namespace vug::survey::svx {
namespace {

/// For notes about instruments, people and copyright, which do not change coordinates.
void skip_text(Reader&, Line& line) { line.rest(); }

using Command = void (*)(Reader&, Line&);

const std::map<std::string, Command>& commands() {
  static const std::map<std::string, Command> all = {
      {"alias", command_alias},
      {"begin", command_begin},
      {"calibrate", command_calibrate},
      {"cartesian", command_cartesian},
      {"case", command_case},
      {"copyright", skip_text},
      {"cs", command_cs},
      {"data", command_data},
      {"date", command_date},
      {"declination", command_declination},
      {"end", command_end},
      {"entrance", command_entrance},
      {"equate", command_equate},
      {"export", command_export},
      {"fix", command_fix},
      {"flags", command_flags},
      {"include", include_file},
      {"infer", command_infer},
      {"instrument", skip_text},
      {"prefix", command_prefix},
      {"ref", skip_text},
      {"require", command_require},
      {"sd", command_sd},
      {"set", command_set},
      {"solve", skip_text},
      {"team", skip_text},
      {"title", command_title},
      {"truncate", command_truncate},
      {"units", command_units},
  };
  return all;
}

}  // namespace

void run_command(Reader& reader, Line& line) {
  line.peek();
  const size_t start = line.position();
  const std::string name = line.keyword();
  const auto found = commands().find(name);
  if (found == commands().end()) {
    std::vector<std::string> known;
    for (const auto& [each, command] : commands()) known.push_back(each);
    line.set_position(start);
    const std::string word = line.word();
    line.fail(start, fmt::format("unknown command '*{}'", word),
              did_you_mean(word, known, "'*' begins a command, ';' a comment"));
  }
  found->second(reader, line);
  line.require_end();
}

}  // namespace vug::survey::svx
