// SPDX-License-Identifier: Apache-2.0
// A centreline of a Therion text: commands that change settings, and lines of data.
#pragma once

#include <vug/survey/observations.h>
#include <vug/survey_files/named_stations.h>
#include <vug/survey_files/therion/leg_vector.h>

#include <map>
#include <optional>

namespace vug::survey::therion {

/// What all centrelines of a survey share.
struct Context {
  Observations& observations;
  NamedStations& stations;
  Diagnostics& warnings;
  std::map<std::string, Grade> grades = known_grades();
};

/// The full name of a station "st@sub.survey", which is relative to the survey `path`.
/// Error(bad_input) for names with empty parts and names longer than 4000 bytes.
std::string full_name(const Token& name, const std::string& path);
/// Equates all stations of "equate a b ...".
void equate(const std::vector<Token>& line, const std::string& path, Context& context);

class Centreline {
 public:
  Centreline(Context& context, std::string path, SourceLocation start)
      : context_(context), path_(std::move(path)), start_(std::move(start)) {}

  /// Interprets a line inside of the centreline.
  void read_line(const std::vector<Token>& line);
  /// Checks the end. Error(bad_input) if a group is not closed.
  void finish();
  const SourceLocation& start() const { return start_; }

 private:
  bool read_command(const std::string& command, const std::vector<Token>& line);
  bool read_calibration(const std::string& command, const std::vector<Token>& line);
  void read_units(const std::vector<Token>& line);
  void read_calibrate(const std::vector<Token>& line);
  void read_declination(const std::vector<Token>& line);
  void read_date(const std::vector<Token>& line);
  void read_flags(const std::vector<Token>& line);
  void read_infer(const std::vector<Token>& line);
  void read_station(const std::vector<Token>& line);
  void read_fix(const std::vector<Token>& line);
  void read_coordinate_system(const std::vector<Token>& line);
  void apply(const Grade& grade);

  void read_data(const std::vector<Token>& line);
  void read_interleaved(const std::vector<Token>& line);
  void add_dimensions(const DataLine& line);
  void add_leg(DataLine line);
  int station(const Token& name);
  void add_sections(int from, int to, const Values& values);
  CrossSection section(int station, const Values& values, bool second) const;

  Context& context_;
  std::string path_;
  SourceLocation start_;
  Settings settings_;
  std::vector<std::pair<Settings, SourceLocation>> groups_;
  bool new_tube_ = true;          ///< The next cross-section starts a tube.
  int tube_end_ = -1;             ///< The station of the last cross-section.
  bool expects_station_ = true;   ///< The next line of interleaved data.
  std::optional<DataLine> last_;  ///< The last station of interleaved data.
  std::optional<DataLine> leg_;   ///< The readings after it.
};

}  // namespace vug::survey::therion
