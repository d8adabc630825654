// SPDX-License-Identifier: Apache-2.0
// https://slurm.schedmd.com/job_array.html
// https://github.com/OpenJobDescription/openjd-specifications/wiki/2023-09-Template-Schemas
#include <vug/base/error.h>
#include <vug/farm/task_list.h>

#include <fmt/format.h>

#include <charconv>
#include <set>
#include <string_view>

namespace vug::farm {
namespace {

constexpr size_t kMostTasks = 1000000;

Error list_error(const std::string& text) {
  return Error(ErrorCode::bad_input, fmt::format("invalid list of tasks '{}'", text), {},
               "write --tasks 0-7, --tasks 0-20:5, or several separated by commas");
}

/// Removes the number at the beginning of `rest`.
size_t take_number(std::string_view& rest, const std::string& text) {
  size_t number = 0;
  const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (fault != std::errc()) throw list_error(text);
  rest.remove_prefix(static_cast<size_t>(end - rest.data()));
  return number;
}

/// Removes the character if it is the first one of `rest`.
bool take(std::string_view& rest, char expected) {
  if (!rest.starts_with(expected)) return false;
  rest.remove_prefix(1);
  return true;
}

}  // namespace

std::vector<size_t> parse_tasks(const std::string& text) {
  std::vector<size_t> out;
  std::set<size_t> known;
  std::string_view rest = text;
  do {
    const size_t first = take_number(rest, text);
    size_t last = first, step = 1;
    if (take(rest, '-')) {
      last = take_number(rest, text);
      if (take(rest, ':')) step = take_number(rest, text);
    }
    if (last < first || step == 0) throw list_error(text);
    if ((last - first) / step >= kMostTasks - out.size()) throw list_error(text);
    for (size_t i = 0; i <= (last - first) / step; ++i)
      if (const size_t task = first + i * step; known.insert(task).second) out.push_back(task);
  } while (take(rest, ','));
  if (!rest.empty()) throw list_error(text);
  return out;
}

}  // namespace vug::farm
