// SPDX-License-Identifier: Apache-2.0
// Point clouds from text files with one point per line.
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/mesh/text_scanner.h>
#include <vug/scan/read.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace vug::scan {
namespace {

constexpr size_t kMaxColumns = 7;

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r' || c == '\v' || c == '\f';
}

/// The numbers of one line; `fault` is the first word that is not a number.
struct NumberRow {
  std::array<double, kMaxColumns> values{};
  size_t count = 0;    ///< Number of words, including those beyond the known columns.
  size_t numbers = 0;  ///< Number of words that are numbers.
  std::string_view fault;
};

bool parse_number(std::string_view word, double& value) {
  if (word.front() == '+') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, code] = std::from_chars(word.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return false;
  // Underflow counts as 0, overflow as infinity.
  if (code == std::errc::result_out_of_range)
    value = word.find("e-") != word.npos || word.find("E-") != word.npos ? 0 : kInfinity;
  return true;
}

NumberRow row_of(std::string_view line) {
  NumberRow row;
  for (size_t at = 0; at < line.size();) {
    if (is_separator(line[at])) {
      ++at;
      continue;
    }
    const size_t begin = at;
    while (at < line.size() && !is_separator(line[at])) ++at;
    const std::string_view word = line.substr(begin, at - begin);
    double value = 0;
    if (parse_number(word, value))
      ++row.numbers;
    else if (row.fault.empty())
      row.fault = word;
    if (row.count < kMaxColumns) row.values[row.count] = value;
    ++row.count;
  }
  return row;
}

bool is_comment(std::string_view line) {
  const size_t begin = line.find_first_not_of(" \t");
  return begin != line.npos && (line[begin] == '#' || line.substr(begin, 2) == "//");
}

class XyzReader {
 public:
  XyzReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  PointCloud read() {
    size_t begin = bytes_.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // UTF-8 byte order mark.
    for (; begin < bytes_.size(); ++line_) {
      const size_t end = std::min(bytes_.find('\n', begin), bytes_.size());
      add(bytes_.substr(begin, end - begin));
      begin = end + 1;
    }
    const float most = cloud_.colours.empty() ? 0.0F : brightest_;
    const float scale = most > 255 ? 65535.0F : most > 1 ? 255.0F : 1.0F;
    for (Vec3f& colour : cloud_.colours) colour /= scale;
    return std::move(cloud_);
  }

 private:
  void add(std::string_view line) {
    if (is_comment(line)) return;
    const NumberRow row = row_of(line);
    if (row.count == 0) return;
    const bool first = std::exchange(first_, false);
    const bool heading = row.numbers == 0 || (row.count == 1 && row.fault.empty());
    if (first && heading && !looks_binary(line)) return;
    if (!row.fault.empty())
      fail(line, row.fault, fmt::format("'{}' is not a number", mesh::printable(row.fault)),
           "a line needs x y z, optionally an intensity and red, green, blue");
    if (row.count != columns_ && columns_ != 0)
      fail(line, line,
           fmt::format("{} numbers, but the previous lines have {}", row.count, columns_),
           "the file may be cut off");
    if (row.count != 3 && row.count != 4 && row.count != 6 && row.count != 7)
      fail(line, line, fmt::format("invalid point with {} numbers", row.count),
           "3 are x y z, 4 also the intensity, 6 also red, green, blue, 7 all of these");
    columns_ = row.count;
    add(row, line);
  }

  void add(const NumberRow& row, std::string_view line) {
    const auto& v = row.values;
    if (!(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]))) {
      ++cloud_.dropped;
      return;
    }
    cloud_.positions.emplace_back(v[0], v[1], v[2]);
    if (columns_ == 4 || columns_ == 7) cloud_.intensities.push_back(static_cast<float>(v[3]));
    if (columns_ < 6) return;
    const size_t red = columns_ - 3;
    for (size_t c = red; c < red + 3; ++c) {
      if (v[c] < 0 || v[c] > 65535)
        fail(line, line, fmt::format("{} is not a colour value", v[c]),
             "the last three of 6 numbers are red, green, blue; omit normals");
      brightest_ = std::max(brightest_, static_cast<float>(v[c]));
    }
    cloud_.colours.emplace_back(static_cast<float>(v[red]), static_cast<float>(v[red + 1]),
                                static_cast<float>(v[red + 2]));
  }

  static bool looks_binary(std::string_view line) {
    return std::any_of(line.begin(), line.end(), [](char c) { return c >= 0 && c < '\t'; });
  }

  [[noreturn]] void fail(std::string_view line, std::string_view at, const std::string& message,
                         const std::string& hint) const {
    throw Error(ErrorCode::bad_input, message,
                {file_, line_, static_cast<int>(at.data() - line.data()) + 1},
                looks_binary(line) ? "a cloud must be a PLY file or a text of numbers" : hint);
  }

  std::string_view bytes_;
  const std::string& file_;
  PointCloud cloud_;
  size_t columns_ = 0;
  int line_ = 1;
  bool first_ = true;
  float brightest_ = 0;
};

}  // namespace

PointCloud parse_xyz(std::string_view bytes, const std::string& file, const ReadOptions& options) {
  // Vectors that grow by doubling take up to three times their size while they reallocate.
  const auto lines = static_cast<double>(std::count(bytes.begin(), bytes.end(), '\n') + 1);
  require_memory(lines * 3 * (sizeof(Vec3d) + sizeof(Vec3f) + 4), options.memory,
                 "the cloud of " + file, "reduce the number of points");
  return XyzReader(bytes, file).read();
}

}  // namespace vug::scan
