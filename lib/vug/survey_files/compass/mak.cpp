// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/compass/dat.h>
#include <vug/survey_files/compass/feet.h>
#include <vug/survey_files/compass/mak.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/text_encoding.h>
#include <vug/survey_files/text_lines.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::compass {
namespace {

constexpr size_t kLongestEntry = 100'000;  ///< Bytes.

/// The EPSG code of the UTM zone of a datum; empty if unknown. Zones of the south are negative.
std::string utm_system(const std::string& datum, int zone) {
  const std::string name = lower_case(datum);
  const int number = std::abs(zone);
  if (name == "wgs 1984") return fmt::format("EPSG:{}", (zone < 0 ? 32700 : 32600) + number);
  if (name == "north american 1983" && zone > 0 && zone <= 23)
    return fmt::format("EPSG:{}", 26900 + number);
  if (name == "north american 1927" && zone > 0 && zone <= 22)
    return fmt::format("EPSG:{}", 26700 + number);
  return "";
}

class MakReader {
 public:
  MakReader(std::string_view text, InputFiles& files, Diagnostics& warnings)
      : lines_(text, files.current().string()),
        files_(files),
        warnings_(warnings),
        stations_(result_.stations) {}

  Observations read() {
    while (lines_.next()) {
      const std::string_view line = trimmed(lines_.line());
      if (line.empty()) continue;
      if (entry_.empty()) {
        start_ = lines_.at();
        if (line[0] == '/') continue;
      }
      entry_ += line;
      read_complete_entries();
    }
    if (!entry_.empty())
      throw Error(ErrorCode::bad_input, "an entry is not closed", start_,
                  "end the entry with a semicolon");
    if (!found_)
      throw Error(ErrorCode::bad_input, "the project lists no .dat file", {lines_.file(), 1, 1},
                  "expected a Compass .mak file with entries such as #cave.dat;");
    name_coordinate_system();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, std::string hint) const {
    throw Error(ErrorCode::bad_input, problem, start_, std::move(hint));
  }

  void read_complete_entries() {
    if (entry_.size() > kLongestEntry) fail("an entry is too long", "end it with a semicolon");
    std::string_view rest = entry_;
    for (size_t end; (end = rest.find(';')) != std::string_view::npos;) {
      const std::string entry(trimmed(rest.substr(0, end)));
      rest = trimmed(rest.substr(end + 1));
      if (rest.starts_with('/')) rest = {};
      if (!entry.empty()) read_entry(entry);
    }
    entry_ = std::string(rest);
  }

  void read_entry(const std::string& entry) {
    const std::string_view rest = trimmed(std::string_view(entry).substr(1));
    switch (entry[0]) {
      case '#':
        return read_file(rest);
      case '@':
        return read_place(rest);
      case '&':
        datum_ = rest;
        return;
      case '$':
        zone_ = read_zone(rest);
        return;
      case '%':
        convergence_ = number(rest);
        if (std::fabs(*convergence_) > 360)
          fail("the convergence is not between -360 and 360 degrees", "write degrees");
        return;
      case '*':  // A convergence that is not in use.
        number(rest);
        convergence_ = 0;
        return;
      case '!':  // Settings of the program.
      case '[':  // Folders in the tree of the program.
      case ']':
        return;
      default:
        fail(fmt::format("unknown entry {}", quote_text(entry)),
             "entries begin with #, @, &, $, %, *, ! or /");
    }
  }

  double number(std::string_view text) const {
    const auto value = parse_number(trimmed(text));
    if (!value)
      fail(fmt::format("{} is not a number", quote_text(text)),
           "write a decimal number such as 1.50");
    return *value;
  }

  int read_zone(std::string_view text) const {
    const auto zone = parse_integer(trimmed(text), -60, 60);
    if (!zone || *zone == 0)
      fail(fmt::format("{} is not a UTM zone", quote_text(text)),
           "write 1 to 60, with a minus sign in the southern hemisphere");
    return *zone;
  }

  /// Easting, northing, elevation, zone and convergence of the place of the project.
  void read_place(std::string_view text) {
    const std::vector<Word> words = split_words(text, ", \t");
    if (words.size() != 5)
      fail(fmt::format("a place has 5 numbers, found {}", words.size()),
           "write @easting,northing,elevation,zone,convergence;");
    for (const Word& word : words) number(word.text);
    if (words[3].text != "0") zone_ = read_zone(words[3].text);
  }

  /// "file.dat,A1,B2[F,1,2,3]": links and fixed stations.
  void read_file(std::string_view text) {
    found_ = true;
    const size_t comma = std::min(text.find(','), text.size());
    const std::string name(trimmed(text.substr(0, comma)));
    const SourceLocation where = start_;
    const std::string bytes = as_utf8(files_.enter(name, ".dat", where));
    DatTarget target{result_, stations_, convergence_.value_or(0)};
    read_dat(bytes, files_.current().string(), target, warnings_);
    files_.leave();
    text.remove_prefix(comma);
    while (!text.empty()) {
      text.remove_prefix(1);
      const size_t end = std::min(text.find_first_of(",["), text.size());
      const std::string station(trimmed(text.substr(0, end)));
      text.remove_prefix(end);
      if (station.empty()) fail("the name of a station is missing", "write #file.dat,station;");
      if (text.starts_with('[')) text = read_fix(station, text, where);
      if (!text.empty() && text[0] != ',')
        fail(fmt::format("expected ',' or ';' before {}", quote_text(text)),
             "separate stations with commas");
    }
  }

  /// Reads "[F,1,2,3]" and returns the text behind it.
  std::string_view read_fix(const std::string& station, std::string_view text,
                            const SourceLocation& where) {
    const size_t end = text.find(']');
    if (end == std::string_view::npos)
      fail("the coordinates of a station are not closed by ']'", "write station[M,1,2,3]");
    const std::vector<Word> words = split_words(text.substr(1, end - 1), ", \t");
    const std::string unit = words.empty() ? "" : lower_case(words[0].text);
    if (words.size() != 4 || (unit != "f" && unit != "m"))
      fail(fmt::format("the coordinates of {} are not a unit and three numbers",
                       quote_text(station)),
           "write station[M,easting,northing,elevation], with F for feet");
    Fix fix;
    for (int axis = 0; axis < 3; ++axis)
      fix.position[axis] =
          (unit == "f" ? kFoot : 1) * number(words[static_cast<size_t>(axis) + 1].text);
    require_plausible(fix.position, where);
    fix.station = stations_.find_or_add(station, where);
    fix.where = where;
    result_.stations[static_cast<size_t>(fix.station)].fixed = true;
    result_.add(fix);
    return trimmed(text.substr(end + 1));
  }

  void name_coordinate_system() {
    if (datum_.empty() || !zone_) return;
    result_.coordinate_system = utm_system(datum_, *zone_);
    if (result_.coordinate_system.empty())
      warnings_.warning({lines_.file(), 1, 1},
                        fmt::format("the coordinate system of the datum {} and the UTM zone {} is "
                                    "unknown; coordinates are used as local metres",
                                    quote_text(datum_), *zone_),
                        "known: WGS 1984, North American 1983, North American 1927");
  }

  TextLines lines_;
  InputFiles& files_;
  Diagnostics& warnings_;
  Observations result_;
  NamedStations stations_;
  std::string entry_;     ///< The text of entries that are not closed yet.
  SourceLocation start_;  ///< The line on which it starts.
  std::string datum_;
  std::optional<int> zone_;
  std::optional<double> convergence_;  ///< Degrees.
  bool found_ = false;
};

}  // namespace

Observations read_mak(std::string_view text, InputFiles& files, Diagnostics& warnings) {
  return MakReader(text, files, warnings).read();
}

}  // namespace vug::survey::compass
