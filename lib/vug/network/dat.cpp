// SPDX-License-Identifier: Apache-2.0
#include <vug/network/dat.h>

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/mesh/text_scanner.h>
#include <vug/network/survey_space.h>

namespace vug::network {
namespace {

constexpr std::string_view kNodes = "_nodes.dat";
constexpr std::string_view kLinks = "_links.dat";
constexpr double kLargest = 1e9;  ///< Metres; a coordinate beyond it is not a position on Earth.

struct DatFiles {
  std::filesystem::path nodes;
  std::filesystem::path links;
};

DatFiles files_of(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  if (!is_dat_name(file))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the name of '{}' does not end with {} or {}", file.string(), kNodes, kLinks),
        {}, "a karst network consists of the two files NAME_nodes.dat and NAME_links.dat");
  name.resize(name.size() - kNodes.size());
  return {file.parent_path() / (name + std::string(kNodes)),
          file.parent_path() / (name + std::string(kLinks))};
}

/// Calls `parse(scanner, first word)` for each line that has words, and rejects what is left of it.
template <class Parse>
void for_each_line(const DatText& source, const char* form, const Parse& parse) {
  mesh::TextScanner scanner(source.text, source.file);
  if (source.text.starts_with("\xEF\xBB\xBF"))
    scanner = mesh::TextScanner(source.text, source.file, 3);  // UTF-8 byte order mark.
  do {
    const std::string_view word = scanner.word_in_line();
    if (word.empty() || word.front() == '#') continue;
    parse(scanner, word);
    const std::string_view rest = scanner.word_in_line();
    if (!rest.empty() && rest.front() != '#')
      scanner.fail(fmt::format("unexpected '{}' at the end of the line", mesh::printable(rest)),
                   form);
  } while (scanner.next_line());
}

constexpr const char* kNodeForm = "a line of nodes is 'x y z' in metres";
constexpr const char* kLinkForm = "a line of links is 'i j', two stations counted from 1";

double coordinate(mesh::TextScanner& scanner, std::string_view word) {
  if (word.empty()) scanner.fail("the line has fewer than three coordinates", kNodeForm);
  const double value = scanner.number(word);
  if (!(value >= -kLargest && value <= kLargest))
    scanner.fail(fmt::format("the coordinate {} is out of range", value),
                 "coordinates must be between -1e9 and 1e9 metres");
  return value;
}

int station_index(mesh::TextScanner& scanner, std::string_view word, size_t stations) {
  if (word.empty()) scanner.fail("the line has fewer than two stations", kLinkForm);
  const int64_t number = scanner.integer(word);
  if (number < 1 || number > static_cast<int64_t>(stations))
    scanner.fail(fmt::format("station {} does not exist", number),
                 fmt::format("stations count from 1 to {}", stations));
  return static_cast<int>(number - 1);
}

}  // namespace

Network parse_dat(const DatText& nodes, const DatText& links, const OriginOptions& options) {
  std::vector<NamedPoint> points;
  for_each_line(nodes, kNodeForm, [&](mesh::TextScanner& scanner, std::string_view word) {
    const double x = coordinate(scanner, word);
    const double y = coordinate(scanner, scanner.word_in_line());
    const double z = coordinate(scanner, scanner.word_in_line());
    points.push_back({std::to_string(points.size() + 1), {x, y, z}});
  });
  Network network;
  network.origin = scene_origin(points, options);
  for (const NamedPoint& point : points)
    network.stations.push_back(
        {.name = point.name, .position = to_scene(point.position - network.origin)});
  for_each_line(links, kLinkForm, [&](mesh::TextScanner& scanner, std::string_view word) {
    const int from = station_index(scanner, word, points.size());
    const int to = station_index(scanner, scanner.word_in_line(), points.size());
    network.legs.push_back({.from = from, .to = to});
  });
  return network;
}

bool is_dat_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(kNodes) || name.ends_with(kLinks);
}

Network read_dat(const std::filesystem::path& file, const OriginOptions& options) {
  const DatFiles files = files_of(file);
  const std::string nodes = read_text(files.nodes);
  const std::string links = read_text(files.links);
  Network network =
      parse_dat({nodes, files.nodes.string()}, {links, files.links.string()}, options);
  network.files = {files.nodes, files.links};
  return network;
}

std::string nodes_dat(const Network& network) {
  std::string text;
  for (const Station& station : network.stations) {
    const Vec3d point = to_survey(station.position) + network.origin;
    text += fmt::format("{} {} {}\n", point.x, point.y, point.z);
  }
  return text;
}

std::string links_dat(const Network& network) {
  std::string text;
  for (const Leg& leg : network.legs) text += fmt::format("{} {}\n", leg.from + 1, leg.to + 1);
  return text;
}

void write_dat(const Network& network, const std::filesystem::path& file) {
  require_valid(network);
  const DatFiles files = files_of(file);
  write_text(files.nodes, nodes_dat(network));
  write_text(files.links, links_dat(network));
}

}  // namespace vug::network
