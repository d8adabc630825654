// SPDX-License-Identifier: Apache-2.0
// Names of stations in a centreline, and the commands about stations.
#include <vug/survey/fix_covariance.h>
#include <vug/survey_files/plausible.h>
#include <vug/survey_files/therion/centreline.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::therion {
namespace {

constexpr size_t kLongestName = 4000;

}  // namespace

std::string full_name(const Token& name, const std::string& path) {
  std::string_view text = name.text;
  const size_t at = std::min(text.find('@'), text.size());
  std::string result = path;
  const auto append = [&](std::string_view part) {
    if (part.empty())
      fail(fmt::format("a part of the name {} is empty", quote_text(name.text)), name.where,
           "write a station as name, or as name@survey");
    if (!result.empty()) result += '.';
    result += part;
    if (result.size() > kLongestName)
      fail(fmt::format("a name is longer than {} bytes", kLongestName), name.where,
           "use shorter names");
  };
  // The innermost survey comes first after '@'.
  std::string_view surveys = at < text.size() ? text.substr(at + 1) : std::string_view();
  bool more = at < text.size();
  while (more) {
    const size_t point = surveys.rfind('.');
    more = point != std::string_view::npos;
    append(more ? surveys.substr(point + 1) : surveys);
    if (more) surveys = surveys.substr(0, point);
  }
  append(text.substr(0, at));
  return result;
}

void equate(const std::vector<Token>& line, const std::string& path, Context& context) {
  if (line.size() < 3)
    fail("'equate' names fewer than two stations", line[0].where, "write: equate a b@survey");
  const int first = context.stations.find_or_add(full_name(line[1], path), line[1].where);
  for (size_t i = 2; i < line.size(); ++i) {
    const int other = context.stations.find_or_add(full_name(line[i], path), line[i].where);
    if (other != first) context.observations.add(Equate{first, other, line[i].where});
  }
}

void Centreline::read_station(const std::vector<Token>& line) {
  if (line.size() < 3)
    fail("'station' lacks an argument", line[0].where, "write: station NAME COMMENT [FLAGS]");
  Station& s = context_.observations.stations[static_cast<size_t>(
      context_.stations.find_or_add(full_name(line[1], path_), line[1].where))];
  if (!line[2].text.empty()) s.comment = line[2].text;
  static const std::string_view kOther[] = {"fixed",
                                            "continuation",
                                            "sink",
                                            "spring",
                                            "doline",
                                            "dig",
                                            "arch",
                                            "overhang",
                                            "explored",
                                            "air-draught",
                                            "air-draught:winter",
                                            "air-draught:summer",
                                            "attr",
                                            "code"};
  bool value = true;
  for (size_t i = 3; i < line.size(); ++i) {
    const std::string flag = lower_case(line[i].text);
    if (flag == "not") {
      value = false;
      continue;
    }
    if (flag == "entrance")
      s.entrance = value;
    else if (std::find(std::begin(kOther), std::end(kOther), flag) == std::end(kOther))
      fail(fmt::format("unknown flag of a station {}", quote_text(line[i].text)), line[i].where,
           "known: entrance, fixed, continuation, sink, spring, doline, dig, air-draught");
    if (flag == "explored" || flag == "code") ++i;
    if (flag == "attr") i += 2;
    value = true;
  }
}

void Centreline::read_fix(const std::vector<Token>& line) {
  const size_t numbers = line.size() - std::min<size_t>(line.size(), 2);
  if (numbers != 3 && numbers != 6 && numbers != 9)
    fail("'fix' has a station and 3, 6 or 9 numbers", line[0].where,
         "write: fix STATION X Y Z [SDX SDY SDZ [COVXY COVYZ COVZX]]");
  std::array<double, 9> values{};
  for (size_t i = 0; i < numbers; ++i) values[i] = read_number(line[i + 2]);
  Fix fix;
  fix.station = context_.stations.find_or_add(full_name(line[1], path_), line[1].where);
  fix.position = {values[0], values[1], values[2]};
  fix.where = line[0].where.up_to(line.back().where);
  require_plausible(fix.position, fix.where);
  if (numbers > 3)
    fix.covariance = fix_covariance({values[3], values[4], values[5]},
                                    {values[6], values[7], values[8]}, fix.where);
  context_.observations.stations[static_cast<size_t>(fix.station)].fixed = true;
  context_.observations.add(fix);
}

}  // namespace vug::survey::therion
