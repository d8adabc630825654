// SPDX-License-Identifier: Apache-2.0
// The state of the reading of a .svx file and of the files that it includes.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey_files/input_files.h>
#include <vug/survey_files/svx/north.h>
#include <vug/survey_files/svx/readings.h>
#include <vug/survey_files/svx/stations.h>

#include <deque>
#include <set>

namespace vug::survey::svx {

/// The settings before a *begin, and its place.
struct Scope {
  Settings before;
  SourceLocation where;
};

/// The state of an interleaved order: the last station, and the leg after it.
struct Traverse {
  std::optional<StationLine> station;
  std::optional<LegLine> leg;
};

struct Reader {
  Reader(InputFiles& input, Diagnostics& notes) : files(input), warnings(notes) {}

  /// Reads the lines of the file in progress.
  void read(std::string_view text);
  /// Checks names and returns the result; call it once, after the files.
  Observations finish();

  InputFiles& files;
  Diagnostics& warnings;
  Observations out;
  Settings settings;
  std::vector<Scope> scopes;
  size_t outer_scopes = 0;  ///< Those of the files that include the current one.
  StationTable stations;
  Traverse traverse;
  int repetitions = 0;   ///< Measurements in the last leg; 0: a next one is a leg of its own.
  bool in_tube = false;  ///< The next cross-section continues the last tube.
  std::set<std::pair<std::string, int>> exports;  ///< Surveys and the stations that they export.
  std::set<std::string> exporting;                ///< Surveys with *export.
  North north;
  std::deque<std::string> file_names;  ///< Referred to by lines.
};

/// Runs the command after the asterisk.
void run_command(Reader& reader, Line& line);
/// Reads a line that is not a command.
void read_data_line(Reader& reader, Line& line);
/// Reads the file of *include.
void include_file(Reader& reader, Line& line);

}  // namespace vug::survey::svx
