// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/picture_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

namespace vug::picture {
namespace {

constexpr const char* kForm = "use --frames 1..24, 1..24x2 for every second frame, or 3,7,10..12";
constexpr size_t kMaxFrames = 100'000;

/// Removes a whole number from the beginning of the text.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(read.ptr - text.data()));
  return number;
}

bool take(std::string_view& text, std::string_view word) {
  if (text.substr(0, word.size()) != word) return false;
  text.remove_prefix(word.size());
  return true;
}

/// The position of the frame number in a file name, and its minimum number of digits.
struct Slot {
  size_t at = 0, length = 0;
  int digits = 0;
};

std::vector<Slot> find_slots(const std::string& name) {
  std::vector<Slot> found;
  for (size_t i = 0; i < name.size(); ++i) {
    size_t end = i;
    if (name[i] == '#') {
      while (end < name.size() && name[end] == '#') ++end;
      found.push_back({i, end - i, static_cast<int>(end - i)});
    } else if (name[i] == '%') {
      ++end;
      while (end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
      if (end >= name.size() || name[end] != 'd' || end - i > 3) continue;
      const std::string width = name.substr(i + 1, end - i - 1);
      found.push_back({i, end + 1 - i, std::atoi(width.c_str())});
      ++end;
    }
    if (end > i) i = end - 1;
  }
  return found;
}

}  // namespace

std::vector<int> parse_frames(const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    return Error(ErrorCode::bad_input, fmt::format("'{}' {}", text, why), {}, kForm);
  };
  std::vector<int> frames;
  std::string_view rest = text;
  do {
    const auto first = take_number(rest);
    int64_t step = 1;
    std::optional<int> last = first;
    if (first && take(rest, "..")) {
      last = take_number(rest);
      if (last && take(rest, "x")) step = take_number(rest).value_or(0);
    }
    if (!first || !last || step < 1) throw refuse("is not a range of frames");
    if (*last < *first) throw refuse("runs backwards");
    for (int64_t frame = *first; frame <= *last; frame += step) {
      frames.push_back(static_cast<int>(frame));
      if (frames.size() > kMaxFrames)
        throw refuse(fmt::format("has more than {} frames", kMaxFrames));
    }
  } while (take(rest, ","));
  if (!rest.empty()) throw refuse("is not a range of frames");
  std::vector<int> sorted = frames;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw refuse("contains a frame twice");
  return frames;
}

std::filesystem::path frame_path(const std::filesystem::path& pattern, int frame) {
  std::string name = pattern.filename().string();
  const std::vector<Slot> found = find_slots(name);
  if (found.size() != 1)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' has {} for the frame number", pattern.string(),
                            found.empty() ? "no place" : "more than one place"),
                {}, "use one run of # for its digits: cave.####.exr");
  name.replace(found[0].at, found[0].length,
               fmt::format("{:0{}}", frame, std::max(found[0].digits, 1)));
  return pattern.parent_path() / name;
}

bool has_frame_number(const std::filesystem::path& pattern) {
  return !find_slots(pattern.filename().string()).empty();
}

bool is_finished(const std::filesystem::path& exr, const shot::Shot& shot,
                 const PicturePlan& plan) {
  std::vector<std::filesystem::path> files = {exr, png_path(exr)};
  if (plan.render.settings.deep) files.push_back(deep_path(exr));
  for (const std::filesystem::path& file : files)
    if (!unreadable_reason(file).empty()) return false;
  PicturePlan first = plan;
  if (plan.options.eye == 0 && is_stereo(plan)) first.options.eye = -1;
  const image::Metadata wanted = identifying_metadata(shot, first);
  try {
    const image::Metadata found = image::read_info(exr).metadata;
    return std::all_of(wanted.begin(), wanted.end(), [&](const auto& entry) {
      return std::find(found.begin(), found.end(), entry) != found.end();
    });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace vug::picture
