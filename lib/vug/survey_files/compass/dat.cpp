// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/backsights.h>
#include <vug/survey_files/compass/dat.h>
#include <vug/survey_files/compass/dat_header.h>
#include <vug/survey_files/compass/feet.h>
#include <vug/survey_files/plausible.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey::compass {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kMissingAngle = -900;  ///< Angles at or below are missing; the files have -999.

/// A line of readings, in feet and degrees.
struct Shot {
  Word from, to;
  double length = 0;
  std::optional<double> bearing, gradient, back_bearing, back_gradient;
  std::optional<double> left, up, down, right;
  bool excluded = false, duplicate = false, splay = false;
  SourceLocation where;
};

class SurveyReader {
 public:
  SurveyReader(TextLines& lines, DatTarget& target, Diagnostics& warnings)
      : lines_(lines), target_(target), warnings_(warnings), header_(read_dat_header(lines)) {
    if (target.observations.title.empty()) target.observations.title = header_.cave;
  }

  /// Reads to the form feed that ends the survey, or to the end of the file.
  void read() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      const bool last = line.find('\f') != std::string_view::npos;
      if (!trimmed(line).empty()) add(read_shot(line));
      if (last) return;
    }
  }

 private:
  const Word& word(const std::vector<Word>& words, size_t index) const {
    constexpr const char* kColumns[] = {"FROM", "TO",   "LEN",   "BEAR", "INC", "LEFT",
                                        "UP",   "DOWN", "RIGHT", "AZM2", "INC2"};
    if (index >= words.size())
      lines_.fail(fmt::format("the line ends before {}", kColumns[index]),
                  header_.has_backsights
                      ? "expected FROM TO LEN BEAR INC LEFT UP DOWN RIGHT AZM2 INC2"
                      : "expected FROM TO LEN BEAR INC LEFT UP DOWN RIGHT");
    return words[index];
  }
  double number(const std::vector<Word>& words, size_t index) const {
    const Word& at = word(words, index);
    const auto value = parse_number(at.text);
    if (!value)
      lines_.fail(fmt::format("{} is not a number", quote_text(at.text)), at,
                  "write a decimal number such as 12.50");
    return *value;
  }
  std::optional<double> angle(const std::vector<Word>& words, size_t index, double low,
                              double high) const {
    const double value = number(words, index);
    if (value <= kMissingAngle) return std::nullopt;
    if (value < low || value > high)
      lines_.fail(fmt::format("the angle {} is not between {} and {} degrees", value, low, high),
                  words[index], "write -999 for a missing angle");
    return value;
  }
  std::optional<double> wall(const std::vector<Word>& words, size_t index) const {
    const double value = number(words, index);
    if (value < 0 || value > kMissingWall) return std::nullopt;
    return kFoot * value;
  }

  Shot read_shot(std::string_view line) {
    const std::vector<Word> words = split_words(line, " \t\f\x1a");
    Shot shot;
    shot.from = word(words, 0);
    shot.to = word(words, 1);
    shot.where = lines_.at(words[0].start, words[1].start + words[1].text.size() - words[0].start);
    shot.length = number(words, 2);
    if (shot.length < 0)
      lines_.fail(fmt::format("the length {} is negative", shot.length), words[2],
                  "write the length in feet");
    shot.bearing = angle(words, 3, 0, 360);
    shot.gradient = angle(words, 4, -90, 90);
    shot.left = wall(words, 5);
    shot.up = wall(words, 6);
    shot.down = wall(words, 7);
    shot.right = wall(words, 8);
    size_t end = 9;
    if (header_.has_backsights) {
      shot.back_bearing = angle(words, 9, 0, 360);
      shot.back_gradient = angle(words, 10, -90, 90);
      end = 11;
    }
    if (end < words.size() && words[end].text.starts_with("#|"))
      read_flags(shot, line.substr(words[end].start + 2), words[end]);
    return shot;
  }

  void read_flags(Shot& shot, std::string_view flags, const Word& word) {
    const size_t end = flags.find('#');
    if (end == std::string_view::npos)
      lines_.fail("the flags do not end with '#'", word, "write flags as in #|LP#");
    for (const char flag : lower_case(flags.substr(0, end))) {
      if (flag == 'x') shot.excluded = true;
      if (flag == 'l') shot.duplicate = true;
      if (flag == 's') shot.splay = true;
      if (std::string_view("xlspc ").find(flag) == std::string_view::npos)
        warnings_.warning(lines_.at(word),
                          fmt::format("the unknown flag '{}' was ignored", flag < ' ' ? '?' : flag),
                          "known: L, P, X, C, S");
    }
  }

  static std::optional<Reading> reading(std::optional<double> degrees, double variance) {
    if (!degrees) return std::nullopt;
    return Reading{*degrees * kDegree, variance};
  }

  MeasuredVector vector(const Shot& shot, double length) {
    const Deviations sd;
    const double position = sd.position * sd.position;
    const Reading tape{length, sd.tape * sd.tape};
    const auto fore = [](std::optional<double> v, double more) {
      return v ? std::optional(*v + more) : v;
    };
    const auto gradient = reading(fore(shot.gradient, header_.fore.gradient), sd.clino * sd.clino);
    const auto back_gradient =
        reading(fore(shot.back_gradient, header_.back.gradient), sd.clino * sd.clino);
    const double north = header_.declination - target_.convergence;
    const auto bearing =
        reading(fore(shot.bearing, header_.fore.bearing + north), sd.compass * sd.compass);
    const auto back_bearing = reading(fore(shot.back_bearing, header_.back.bearing + north + 180),
                                      sd.compass * sd.compass);
    const auto reversed =
        back_gradient ? std::optional(Reading{-back_gradient->value, back_gradient->variance})
                      : std::nullopt;
    if (!gradient && !reversed && length > 0)
      throw Error(ErrorCode::bad_input, "the inclination is missing", shot.where,
                  "write the inclination of the shot or of its backsight");
    const Reading slope =
        length > 0 ? *BothDirections{gradient, reversed}.combine("clino", shot.where, warnings_)
                   : Reading{};
    if (std::fabs(slope.value) > kPi / 2 * (1 + 1e-9))
      throw Error(ErrorCode::bad_input, "the corrected inclination is steeper than vertical",
                  shot.where, "check the corrections in the header");
    if (!bearing && !back_bearing) {
      const bool plumb = std::fabs(shot.gradient.value_or(-shot.back_gradient.value_or(0))) == 90;
      if (!plumb && length > 0)
        throw Error(ErrorCode::bad_input, "the bearing is missing", shot.where,
                    "only shots with an inclination of 90 or -90 may lack a bearing");
      return plumb_leg({std::copysign(length, slope.value), tape.variance}, sd.plumb * sd.plumb,
                       position);
    }
    return polar_leg(tape,
                     *BothDirections{bearing, back_bearing}.combine_bearings(shot.where, warnings_),
                     slope, position);
  }

  void add(const Shot& shot) {
    if (shot.excluded) return;
    const int from = target_.stations.find_or_add(std::string(shot.from.text), shot.where);
    if (shot.from.text == shot.to.text) {
      // Compass marks the walls at the last station of a survey by a shot of length 0.
      if (shot.length > 0)
        throw Error(ErrorCode::bad_input,
                    fmt::format("the shot leads from {} to itself", quote_text(shot.from.text)),
                    shot.where, "name two stations, or write the length 0");
      add_section(shot, from, from);
      return;
    }
    const int to = target_.stations.find_or_add(std::string(shot.to.text), shot.where);
    const double length = shot.length > 0 ? kFoot * (shot.length + header_.fore.length) : 0;
    if (length < 0)
      throw Error(ErrorCode::bad_input, "the corrected length is negative", shot.where,
                  "check the correction of lengths in the header");
    const MeasuredVector measured = vector(shot, length);
    require_plausible(measured, shot.where);
    ObservedLeg leg;
    leg.leg.from = from;
    leg.leg.to = to;
    leg.leg.style = Style::normal;
    leg.leg.duplicate = shot.duplicate;
    leg.leg.splay = shot.splay;
    leg.leg.survey = header_.name;
    leg.leg.date = header_.date;
    leg.leg.length = length;
    leg.leg.where = shot.where;
    leg.vector = measured.vector;
    leg.covariance = measured.covariance;
    target_.observations.legs.push_back(std::move(leg));
    if (!shot.splay) add_section(shot, from, to);
  }

  /// Successive shots, each from the end of the one before, form a tube.
  void add_section(const Shot& shot, int from, int to) {
    std::vector<Tube>& tubes = target_.observations.tubes;
    if (shot.left || shot.right || shot.up || shot.down) {
      if (!tube_open_ || from != last_) tubes.emplace_back();
      tubes.back().push_back(
          {header_.sections_at_to ? to : from, shot.left, shot.right, shot.up, shot.down});
      tube_open_ = true;
    } else {
      tube_open_ = false;
    }
    last_ = to;
  }

  TextLines& lines_;
  DatTarget& target_;
  Diagnostics& warnings_;
  DatHeader header_;
  bool tube_open_ = false;
  int last_ = -1;  ///< The end of the last shot.
};

}  // namespace

void read_dat(std::string_view text, const std::string& file, DatTarget& target,
              Diagnostics& warnings) {
  TextLines lines(text, file);
  bool found = false;
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    found = true;
    SurveyReader(lines, target, warnings).read();
  }
  if (!found)
    throw Error(ErrorCode::bad_input, "the file contains no survey", {file, 1, 1},
                "expected a Compass .dat file");
}

}  // namespace vug::survey::compass
