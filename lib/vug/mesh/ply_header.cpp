// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/ply_header.h>
#include <vug/mesh/text_scanner.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vug::mesh {
namespace {

PlyType parse_type(const TextScanner& scan, std::string_view word) {
  constexpr std::pair<std::string_view, PlyType> kNames[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const auto& [name, type] : kNames)
    if (name == word) return type;
  scan.fail(fmt::format("unknown PLY type '{}'", printable(word)),
            "types are char, uchar, short, ushort, int, uint, float, double");
}

PlyProperty parse_property(TextScanner& scan, const PlyElement& element) {
  PlyProperty property;
  std::string_view word = scan.word_in_line();
  property.is_list = word == "list";
  if (property.is_list) {
    property.count_type = parse_type(scan, scan.word_in_line());
    if (!is_whole(property.count_type)) scan.fail("the length of a list must be a whole number");
    word = scan.word_in_line();
  }
  property.type = parse_type(scan, word);
  property.name = scan.word_in_line();
  if (property.name.empty()) scan.fail("a property needs a name");
  for (const PlyProperty& other : element.properties)
    if (other.name == property.name)
      scan.fail(fmt::format("duplicate property '{}'", printable(property.name)));
  return property;
}

PlyHeader::Encoding parse_encoding(TextScanner& scan) {
  const std::string_view word = scan.word_in_line();
  if (scan.word_in_line() != "1.0") scan.fail("unsupported PLY version: only 1.0 is known");
  if (word == "ascii") return PlyHeader::Encoding::ascii;
  if (word == "binary_little_endian") return PlyHeader::Encoding::little_endian;
  if (word == "binary_big_endian") return PlyHeader::Encoding::big_endian;
  scan.fail(fmt::format("unknown PLY encoding '{}'", printable(word)),
            "encodings are ascii, binary_little_endian, binary_big_endian");
}

/// Rejects counts that the file is too short for, before any memory is allocated for them.
void check_counts(const PlyHeader& header, size_t bytes, const std::string& file) {
  for (const PlyElement& element : header.elements) {
    uint64_t least = 0;
    for (const PlyProperty& p : element.properties)
      least += header.encoding == PlyHeader::Encoding::ascii ? 2
               : p.is_list                                   ? size_of(p.count_type)
                                                             : size_of(p.type);
    // The last number of a text may lack its separator.
    if (least > 0 && element.count > (bytes - header.body + 1) / least)
      throw Error(ErrorCode::bad_input,
                  fmt::format("{} elements '{}' do not fit into the {} bytes that follow",
                              element.count, printable(element.name), bytes - header.body),
                  {file, element.line, 1}, "the file may be cut off");
  }
}

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, const std::string& file) {
  TextScanner scan(bytes, file);
  PlyHeader header;
  if (scan.rest_of_line() != "ply")
    TextScanner(bytes, file).fail("the file does not begin with 'ply'", "is this a PLY file?");
  bool has_format = false;
  for (;;) {
    const std::string_view keyword = scan.word_in_line();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.encoding = parse_encoding(scan);
      has_format = true;
    } else if (keyword == "element") {
      PlyElement element{std::string(scan.word_in_line()), 0, {}, scan.line()};
      const int64_t count = scan.integer(scan.word_in_line());
      if (count < 0) scan.fail("an element count is negative");
      element.count = static_cast<uint64_t>(count);
      for (const PlyElement& other : header.elements)
        if (other.name == element.name)
          scan.fail(fmt::format("duplicate element '{}'", printable(element.name)));
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) scan.fail("a property precedes the first element");
      header.elements.back().properties.push_back(parse_property(scan, header.elements.back()));
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      scan.fail(fmt::format("unknown PLY header line '{}'", printable(keyword)));
    }
    if (!scan.next_line()) scan.fail("the header has no 'end_header'", "the file may be cut off");
  }
  if (!has_format) scan.fail("the header lacks a format line");
  scan.next_line();
  header.body = scan.offset();
  header.body_line = scan.line();
  check_counts(header, bytes.size(), file);
  return header;
}

}  // namespace vug::mesh
