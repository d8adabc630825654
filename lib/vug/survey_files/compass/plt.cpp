// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/dates.h>
#include <vug/survey_files/compass/feet.h>
#include <vug/survey_files/compass/plt.h>
#include <vug/survey_files/named_stations.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/text_lines.h>

#include <fmt/format.h>

namespace vug::survey::compass {
namespace {

constexpr double kSamePlace = 0.01;  ///< Metres between mentions of one station.

class PltReader {
 public:
  PltReader(std::string_view text, const std::string& file, Diagnostics& warnings)
      : lines_(text, file), warnings_(warnings), stations_(survey_.stations) {}

  Survey read() {
    bool known = false;
    while (lines_.next()) {
      const std::string_view line = trimmed(lines_.line());
      if (line.empty()) continue;
      const char command = line[0];
      if (command == 'M' || command == 'D' || command == 'd') {
        read_point(command);
      } else if (command == 'N') {
        read_survey(line.substr(1));
      } else if (command == 'S' && survey_.title.empty()) {
        survey_.title = trimmed(line.substr(1));
      } else if (std::string_view("ZSXFLOGPCV").find(command) == std::string_view::npos) {
        lines_.fail(fmt::format("unknown command {}", quote_text(line)),
                    "expected a Compass .plt file with lines that begin with M, D or N");
      }
      known = true;
    }
    if (!known)
      throw Error(ErrorCode::bad_input, "the file is empty", {lines_.file(), 1, 1},
                  "expected a Compass .plt file");
    return std::move(survey_);
  }

 private:
  void read_survey(std::string_view text) {
    const std::vector<Word> words = split_words(text);
    name_ = words.empty() ? "" : std::string(words[0].text);
    date_.reset();
    last_ = -1;
    if (words.size() < 5 || words[1].text != "D") return;
    const DateText date = parse_date({words[4].text, words[2].text, words[3].text});
    if (!date.range) lines_.fail(date.fault, "write the month, the day and the year: D 7 10 1979");
    date_ = date.range;
  }

  double number(const std::vector<Word>& words, size_t index, const char* name) const {
    if (index >= words.size())
      lines_.fail(fmt::format("the line ends before the {}", name),
                  "write M north east up Sname P left right up down I distance");
    const auto value = parse_number(words[index].text);
    if (!value)
      lines_.fail(fmt::format("{} is not a number", quote_text(words[index].text)), words[index],
                  "write a decimal number such as 12.5");
    return *value;
  }

  int station(const std::string& name, const Vec3d& position) {
    int index = stations_.find(name);
    std::string unique = name;
    if (index >= 0 &&
        (survey_.stations[static_cast<size_t>(index)].position - position).length() > kSamePlace) {
      unique = name_ + '.' + name;
      index = stations_.find(unique);
      if (index < 0)
        warnings_.warning(lines_.at(),
                          fmt::format("the name {} is used at two places; here it "
                                      "becomes {}",
                                      quote_text(name), quote_text(unique)),
                          "give one of the two stations another name");
    }
    if (index >= 0) return index;
    index = stations_.find_or_add(unique, lines_.at());
    survey_.stations[static_cast<size_t>(index)].position = position;
    return index;
  }

  void read_point(char command) {
    const std::vector<Word> words = split_words(lines_.line());
    const double north = kFoot * number(words, 1, "northing");
    const double east = kFoot * number(words, 2, "easting");
    const Vec3d position(east, north, kFoot * number(words, 3, "elevation"));
    require_plausible(position, lines_.at());
    if (words.size() < 5 || words[4].text.size() < 2 || words[4].text[0] != 'S')
      lines_.fail("the name of the station is missing", "write S and the name after the numbers");
    const int at = station(std::string(words[4].text.substr(1)), position);
    if (command == 'M' || last_ < 0) {
      if (command != 'M')
        lines_.fail("a line to draw precedes the first position", "begin with a line M");
      open_ = false;
    } else if (at != last_) {
      add_leg(at, command == 'd', words.back().text);
    }
    read_walls(words, at);
    last_ = at;
  }

  void add_leg(int to, bool surface, std::string_view flags) {
    Leg leg;
    leg.from = last_;
    leg.to = to;
    leg.surface = surface;
    if (flags.starts_with('F')) {
      leg.duplicate = flags.find('L') != std::string_view::npos;
      leg.splay = flags.find('S') != std::string_view::npos;
    }
    leg.survey = name_;
    leg.date = date_;
    leg.where = lines_.at();
    for (const int end : {leg.from, leg.to}) {
      Station& s = survey_.stations[static_cast<size_t>(end)];
      (surface ? s.surface : s.underground) = true;
    }
    survey_.legs.push_back(std::move(leg));
  }

  void read_walls(const std::vector<Word>& words, int at) {
    if (words.size() < 6 || words[5].text != "P") return;
    CrossSection section;
    section.station = at;
    size_t index = 6;
    bool any = false;
    for (auto* side : {&section.left, &section.right, &section.up, &section.down}) {
      const double value = number(words, index++, "distance to a wall");
      if (value < 0 || value > kMissingWall) continue;
      *side = kFoot * value;
      any = true;
    }
    if (any) {
      if (!open_) survey_.tubes.emplace_back();
      survey_.tubes.back().push_back(section);
    }
    open_ = any;
  }

  TextLines lines_;
  Diagnostics& warnings_;
  Survey survey_;
  NamedStations stations_;
  std::string name_;  ///< The current survey.
  std::optional<DateRange> date_;
  int last_ = -1;      ///< The station of the last point, or -1.
  bool open_ = false;  ///< Whether the next cross-section continues the last tube.
};

}  // namespace

Survey read_plt(std::string_view text, const std::string& file, Diagnostics& warnings) {
  return PltReader(text, file, warnings).read();
}

}  // namespace vug::survey::compass
