// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>
#include <vug/survey_files/backsights.h>
#include <vug/survey_files/named_stations.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/text_encoding.h>
#include <vug/survey_files/walls/read.h>
#include <vug/survey_files/walls/settings.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::survey::walls {
namespace {

constexpr size_t kLongestName = 4000;

bool is_omitted(std::string_view text) {
  return text.size() >= 2 && text.find_first_not_of('-') == std::string_view::npos;
}
bool is_nameless(std::string_view name) { return name == "-"; }

class Reader {
 public:
  Reader(std::string_view text, const std::string& file, Diagnostics& warnings)
      : lines_(text, file), warnings_(warnings), stations_(result_.stations) {}

  Observations read() {
    while (lines_.next()) {
      std::string_view line = lines_.line();
      line = line.substr(0, line.find(';'));
      const std::vector<Word> words = split_words(line, " \t,");
      if (words.empty() || words[0].text == "\x1a") continue;
      if (in_comment_ || words[0].text.starts_with("#[")) {
        in_comment_ = !words[0].text.starts_with("#]");
        comment_ = in_comment_ && comment_.line == 0 ? lines_.at() : comment_;
        if (!in_comment_) comment_ = {};
      } else if (words[0].text[0] == '#') {
        read_directive(words);
      } else {
        read_leg(line);
      }
    }
    if (in_comment_)
      throw Error(ErrorCode::bad_input, "the comment is not closed", comment_, "add '#]'");
    return std::move(result_);
  }

 private:
  void read_directive(const std::vector<Word>& words) {
    const std::string name = lower_case(words[0].text.substr(1));
    if (name == "units" || name == "u") {
      read_unit_line(words);
    } else if (name == "fix" || name == "f") {
      read_fix(words);
    } else if (name == "date") {
      read_date(words);
    } else if (name == "prefix" || name == "prefix1" || name == "p") {
      set_prefix(words, 0);
    } else if (name == "prefix2" || name == "prefix3") {
      set_prefix(words, name == "prefix2" ? 1 : 2);
    } else if (name != "segment" && name != "seg" && name != "s" && name != "note" && name != "n" &&
               name != "flag" && name != "symbol" && name != "sym") {
      lines_.fail(fmt::format("the directive {} is not supported", quote_text(words[0].text)),
                  words[0], "known: #units, #fix, #date, #prefix, #segment, #note, #flag, #symbol");
    }
  }

  void read_unit_line(const std::vector<Word>& words) {
    std::vector<Word> rest;
    for (const Word& word : words) {
      const std::string lower = lower_case(word.text);
      if (lower == "save") {
        if (saved_.size() >= 10) lines_.fail("more than 10 units are saved", word, "restore some");
        saved_.push_back(settings_);
      } else if (lower == "restore") {
        if (saved_.empty()) lines_.fail("RESTORE without SAVE", word, "add SAVE above");
        settings_ = saved_.back();
        saved_.pop_back();
      } else {
        rest.push_back(word);
      }
    }
    read_units(lines_, rest, 1, settings_);
  }

  void set_prefix(const std::vector<Word>& words, size_t level) {
    settings_.prefixes[level] = words.size() > 1 ? words[1].text : std::string_view();
  }

  void read_date(const std::vector<Word>& words) {
    constexpr const char* kForms = "write #date 2001-02-03 or #date 2/3/2001";
    const bool american = words.size() > 1 && words[1].text.find('/') != std::string_view::npos;
    const std::vector<Word> parts =
        words.size() == 2 ? split_words(words[1].text, "-/") : std::vector<Word>();
    if (parts.size() != 3) lines_.fail("'#date' has no date", kForms);
    const DateText date = parse_date(
        {parts[american ? 2 : 0].text, parts[american ? 0 : 1].text, parts[american ? 1 : 2].text});
    if (!date.range) lines_.fail(date.fault, words[1], kForms);
    date_ = date.range;
  }

  /// The survey of the current prefixes and of those in the name, and the name itself.
  std::pair<std::string, std::string> split_name(const Word& word) const {
    std::array<std::string, 3> prefixes = settings_.prefixes;
    std::vector<std::string> parts;
    std::string_view rest = word.text;
    for (size_t colon; (colon = rest.find(':')) != std::string_view::npos;) {
      parts.emplace_back(rest.substr(0, colon));
      rest.remove_prefix(colon + 1);
    }
    if (parts.size() > prefixes.size() || rest.empty())
      lines_.fail(fmt::format("{} is not the name of a station", quote_text(word.text)), word,
                  "write a name with at most three prefixes, such as a:b:c:1");
    for (size_t i = 0; i < parts.size(); ++i) prefixes[parts.size() - 1 - i] = parts[i];
    std::string survey;
    for (size_t i = prefixes.size(); i-- > 0;)
      if (!prefixes[i].empty()) survey += (survey.empty() ? "" : ".") + prefixes[i];
    std::string name(rest);
    if (settings_.letters != Settings::Case::mixed)
      for (char& c : name) {
        if (settings_.letters == Settings::Case::lower && c >= 'A' && c <= 'Z')
          c = static_cast<char>(c + 32);
        if (settings_.letters == Settings::Case::upper && c >= 'a' && c <= 'z')
          c = static_cast<char>(c - 32);
      }
    if (survey.size() + name.size() > kLongestName)
      lines_.fail(fmt::format("a name is longer than {} bytes", kLongestName), word,
                  "use shorter names");
    return {survey, name};
  }

  int station(const Word& word) {
    if (is_nameless(word.text)) return stations_.add_anonymous(true, lines_.at(word));
    const auto [survey, name] = split_name(word);
    return stations_.find_or_add(survey.empty() ? name : survey + '.' + name, lines_.at(word));
  }

  double distance(const Word& word) const {
    const auto value = parse_distance(word.text, settings_.distance_unit);
    if (!value)
      lines_.fail(fmt::format("{} is not a length", quote_text(word.text)), word,
                  "write a number such as 12.5, 12.5m, 41f or 41i6");
    return *value;
  }

  void read_fix(const std::vector<Word>& words) {
    if (words.size() < 5)
      lines_.fail("'#fix' has a station and three coordinates", "write #fix STATION EAST NORTH UP");
    Fix fix;
    fix.where = lines_.at();
    fix.station = station(words[1]);
    for (size_t i = 2; i < 4; ++i)
      if (std::string_view("nsewNSEW").find(words[i].text[0]) != std::string_view::npos)
        lines_.fail(fmt::format("{} is a latitude or longitude, which '#fix' does not support here",
                                quote_text(words[i].text)),
                    words[i], "write the easting, the northing and the height as lengths");
    for (size_t i = 0; i < 3; ++i) {
      const std::string_view letter = settings_.rect_order;
      const size_t axis = i < letter.size() ? std::string_view("enu").find(letter[i]) : 2;
      fix.position[static_cast<int>(axis)] = distance(words[i + 2]);
    }
    require_plausible(fix.position, fix.where);
    result_.stations[static_cast<size_t>(fix.station)].fixed = true;
    result_.add(fix);
  }

  /// "fore/back", of which one may be missing or omitted; nothing if both are.
  std::optional<Reading> angle(const Word& word, bool vertical) {
    const size_t slash = std::min(word.text.find('/'), word.text.size());
    const std::string_view texts[2] = {word.text.substr(0, slash),
                                       word.text.substr(std::min(slash + 1, word.text.size()))};
    const Deviations sd;
    const double deviation = vertical ? sd.clino : sd.compass;
    BothDirections both;
    for (int back = 0; back < 2; ++back) {
      if (texts[back].empty() || is_omitted(texts[back])) continue;
      const AngleUnit& unit = vertical ? (back ? settings_.back_vertical : settings_.vertical)
                                       : (back ? settings_.back_azimuth : settings_.azimuth);
      const auto raw = parse_angle(texts[back], unit);
      const double low = vertical ? -kPi / 2 : 0, high = vertical ? kPi / 2 : 2 * kPi;
      if (!raw || *raw < low - 1e-9 || *raw > high + 1e-9)
        lines_.fail(fmt::format("{} is not {}", quote_text(texts[back]),
                                vertical ? "a vertical angle" : "an azimuth"),
                    word,
                    vertical ? "write a number between -90 and 90 degrees"
                             : "write a number between 0 and 360 degrees");
      double value = *raw;
      if (vertical)
        value += back ? settings_.add_back_vertical : settings_.add_vertical;
      else
        value += back ? settings_.add_back_azimuth : settings_.add_azimuth;
      const bool turn = back && !(vertical ? settings_.corrected_back_vertical
                                           : settings_.corrected_back_azimuth);
      if (turn) value = vertical ? -value : value + kPi;
      if (vertical && std::fabs(value) > high + 1e-9)
        lines_.fail("the corrected vertical angle is steeper than vertical", word,
                    "check INCV and INCVB of #units");
      (back ? both.back : both.fore) = Reading{value, deviation * deviation};
    }
    return vertical ? both.combine("clino", lines_.at(word), warnings_)
                    : both.combine_bearings(lines_.at(word), warnings_);
  }

  MeasuredVector polar_vector(const std::vector<Word>& words, double& length) {
    std::optional<Reading> azimuth, vertical;
    const Deviations sd;
    for (size_t i = 0; i < settings_.order.size(); ++i) {
      const char column = settings_.order[i];
      if (i + 2 >= words.size()) {
        if (column == 'v') break;
        lines_.fail(
            fmt::format("the line ends before the {}", column == 'd' ? "distance" : "azimuth"),
            "write FROM TO and the readings in the order of #units");
      }
      const Word& word = words[i + 2];
      if (column == 'd') {
        length = distance(word);
        if (length < 0) lines_.fail("the distance is negative", word, "write a positive number");
        if (length > 0) length += settings_.add_distance;
        if (length < 0)
          lines_.fail("the corrected distance is negative", word, "check INCD of #units");
      } else if (column == 'a') {
        azimuth = angle(word, false);
      } else {
        vertical = angle(word, true);
      }
    }
    const Reading tape{length, sd.tape * sd.tape};
    const double position = sd.position * sd.position;
    const Reading slope = vertical.value_or(Reading{0, sd.level * sd.level});
    if (!azimuth) {
      if (length > 0 && std::fabs(std::fabs(slope.value) - kPi / 2) > 1e-6)
        lines_.fail("the azimuth is missing",
                    "only legs with a vertical angle of 90 or -90 may lack it");
      return plumb_leg({std::copysign(length, slope.value), tape.variance}, sd.plumb * sd.plumb,
                       position);
    }
    azimuth->value += settings_.declination - settings_.grid;
    return polar_leg(tape, *azimuth, slope, position);
  }

  MeasuredVector rectangular_vector(const std::vector<Word>& words, double& length) {
    MeasuredVector result;
    for (size_t i = 0; i < settings_.rect_order.size(); ++i) {
      if (i + 2 >= words.size()) {
        if (settings_.rect_order[i] == 'u') break;
        lines_.fail("the line ends before an offset", "write FROM TO EAST NORTH UP");
      }
      const size_t axis = std::string_view("enu").find(settings_.rect_order[i]);
      result.vector[static_cast<int>(axis)] = distance(words[i + 2]);
    }
    const Deviations sd;
    const double variance = sd.coordinate * sd.coordinate;
    result.covariance.xx = result.covariance.yy = result.covariance.zz = variance;
    result = turned(result, -settings_.grid);  // Offsets refer to true north.
    length = result.vector.length();
    return result;
  }

  /// Removes "<l,r,u,d>" or "*l,r,u,d*" and a directive at the end of the line.
  std::optional<CrossSection> take_walls(std::string_view& line) {
    const size_t start = line.find_first_of("<*");
    if (start == std::string_view::npos) {
      line = line.substr(0, line.find('#'));
      return std::nullopt;
    }
    const size_t end = line.find(line[start] == '<' ? '>' : '*', start + 1);
    const Word whole{line.substr(start, end - start), start};
    if (end == std::string_view::npos)
      lines_.fail("the distances to the walls are not closed", whole, "write <l,r,u,d>");
    const std::vector<Word> words = split_words(line.substr(start + 1, end - start - 1), ", \t");
    if (words.size() < 4)
      lines_.fail("fewer than four distances to the walls", whole, "write <l,r,u,d>");
    CrossSection section;
    size_t i = 0;
    for (auto* side : {&section.left, &section.right, &section.up, &section.down}) {
      const Word& word = words[i++];
      if (is_omitted(word.text)) continue;
      const auto value = parse_distance(word.text, settings_.wall_unit);
      if (!value)
        lines_.fail(fmt::format("{} is not a distance to a wall", quote_text(word.text)), whole,
                    "write numbers, or -- for unknown distances");
      require_plausible_wall(*value, lines_.at(whole));
      if (*value >= 0) *side = *value;
    }
    line = line.substr(0, start);
    return section;
  }

  void read_leg(std::string_view line) {
    const std::optional<CrossSection> walls = take_walls(line);
    const std::vector<Word> words = split_words(line);
    if (words.empty() || (words.size() == 1 && !walls))
      lines_.fail("the line names fewer than two stations", "write FROM TO and the readings");
    if (words.size() == 1) return add_walls(station(words[0]), -1, walls);
    const bool open = is_nameless(words[0].text) || is_nameless(words[1].text);
    if (is_nameless(words[0].text) && is_nameless(words[1].text))
      lines_.fail("a leg joins two anonymous stations", "name one of the stations");
    double length = 0;
    const MeasuredVector measured =
        settings_.rectangular ? rectangular_vector(words, length) : polar_vector(words, length);
    ObservedLeg leg;
    leg.leg.from = station(words[0]);
    leg.leg.to = station(words[1]);
    if (leg.leg.from == leg.leg.to)
      lines_.fail(fmt::format("the leg leads from {} to itself", quote_text(words[0].text)),
                  words[1], "name two stations");
    leg.leg.style = settings_.rectangular ? Style::cartesian : Style::normal;
    leg.leg.splay = open;
    leg.leg.survey = split_name(is_nameless(words[0].text) ? words[1] : words[0]).first;
    leg.leg.date = date_;
    leg.leg.length = length;
    leg.leg.where = lines_.at();
    leg.vector = measured.vector;
    leg.covariance = measured.covariance;
    require_plausible(measured, leg.leg.where);
    const int from = leg.leg.from, to = leg.leg.to;
    result_.legs.push_back(std::move(leg));
    if (!open) add_walls(settings_.walls_at_to ? to : from, to, walls);
  }

  /// Successive legs form a tube; `next` is the station at which the next leg must start.
  void add_walls(int at, int next, std::optional<CrossSection> walls) {
    if (walls) {
      walls->station = at;
      if (!(tube_open_ && (at == tube_next_ || settings_.walls_at_to)))
        result_.tubes.emplace_back();
      result_.tubes.back().push_back(*walls);
    }
    tube_open_ = walls.has_value() && next >= 0;
    tube_next_ = next;
  }

  TextLines lines_;
  Diagnostics& warnings_;
  Observations result_;
  NamedStations stations_;
  Settings settings_;
  std::vector<Settings> saved_;
  std::optional<DateRange> date_;
  bool in_comment_ = false;
  SourceLocation comment_;  ///< The start of the open comment.
  bool tube_open_ = false;
  int tube_next_ = -1;
};

}  // namespace

Observations read(std::string_view text, const std::string& file, Diagnostics& warnings) {
  return Reader(text, file, warnings).read();
}

}  // namespace vug::survey::walls
