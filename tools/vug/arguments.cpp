// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/scene/lexer.h>

#include <algorithm>
#include <charconv>

namespace vug::cli {
namespace {

template <class T>
bool parse_integer(const std::string& text, T& number) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end;
}

std::string bounds_text(double low, double high, Dimension dimension) {
  return dimension == Dimension::none ? fmt::format("from {} to {}", low, high)
                                      : fmt::format("from {} to {}", quantity_text(low, dimension),
                                                    quantity_text(high, dimension));
}

}  // namespace

CLI::Validator number_in(Dimension dimension, double low, double high) {
  const std::string bounds = bounds_text(low, high, dimension);
  const auto read = [=](std::string& text) -> std::string {
    const std::optional<Number> number = scene::read_number(text);
    if (!number || (number->dimension != Dimension::none && number->dimension != dimension))
      return fmt::format("invalid value '{}': expected a number {}", text, bounds);
    if (!(number->value >= low && number->value <= high))
      return fmt::format("value {} is out of range: expected a number {}", text, bounds);
    text = fmt::format("{}", number->value);
    return {};
  };
  return CLI::Validator(read, "");
}

CLI::Validator number_or_name(const ParamInfo& info) {
  const CLI::Validator number = number_in(info.dimension, info.min, info.max);
  const auto read = [=, names = info.choices](std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return {};
    const std::string fault = number(text);
    return fault.empty() ? fault : fmt::format("{}, or {}", fault, fmt::join(names, ", "));
  };
  return CLI::Validator(read, "");
}

CLI::Validator integer_in(int low, int high) {
  const auto check = [=](std::string& text) -> std::string {
    int number = 0;
    if (parse_integer(text, number) && number >= low && number <= high) return {};
    return fmt::format("invalid value '{}': expected an integer from {} to {}", text, low, high);
  };
  return CLI::Validator(check, "");
}

CLI::Validator seed_number() {
  const auto check = [](std::string& text) -> std::string {
    uint64_t number = 0;
    return parse_integer(text, number)
               ? ""
               : fmt::format("invalid seed '{}': expected an integer of at least 0", text);
  };
  return CLI::Validator(check, "");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [=](std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    return fmt::format("invalid value '{}': expected {}", text, fmt::join(words, ", "));
  };
  return CLI::Validator(check, fmt::format("{{{}}}", fmt::join(words, ",")));
}

void require_no_scene(const std::string& file) {
  if (extension_of(file) != ".vug") return;
  throw Error(ErrorCode::bad_input, fmt::format("'{}' is a scene, not a file built from one", file),
              {}, "'vug check' describes a scene, and 'vug list' the kinds that it can use");
}

std::vector<int> parse_crop(const std::string& text) {
  const auto crop = parse_numbers(text, "N,N,N,N", "crop", "write --crop left,top,right,bottom");
  if (crop[0] >= crop[2] || crop[1] >= crop[3])
    throw Error(ErrorCode::bad_input, fmt::format("invalid crop '{}': it contains no pixels", text),
                {}, "write --crop left,top,right,bottom; right and bottom are exclusive");
  return crop;
}

Error unknown_verb_error(const std::string& word, const std::vector<std::string>& verbs,
                         const std::string& before) {
  const std::string after = before.empty() ? "" : before + " ";
  if (word.empty())
    return Error(ErrorCode::bad_input, "no verb given", {},
                 fmt::format("write vug {}VERB, where VERB is one of {}; see 'vug {}--help'", after,
                             fmt::join(verbs, ", "), after));
  return Error(ErrorCode::bad_input, fmt::format("unknown verb '{}{}'", after, word), {},
               suggestion(word, verbs));
}

std::vector<int> parse_numbers(const std::string& text, const std::string& pattern,
                               const std::string& what, const std::string& hint) {
  std::vector<int> numbers;
  const char *at = text.data(), *end = text.data() + text.size();
  bool good = true;
  for (const char c : pattern) {
    if (c != 'N') {
      good = good && at != end && *at == c;
      if (good) ++at;
      continue;
    }
    const auto read = std::from_chars(at, end, numbers.emplace_back());
    good = good && read.ec == std::errc() && numbers.back() >= 0;
    at = read.ptr;
  }
  if (!good || at != end)
    throw Error(ErrorCode::bad_input, fmt::format("invalid {} '{}'", what, text), {}, hint);
  return numbers;
}

void require_extension(const std::string& file, const std::string& ending,
                       const std::string& hint) {
  const std::string name = std::filesystem::path(file).filename().string();
  if (extension_of(file) == ending) return;
  // std::filesystem gives a name whose only dot is the first character no extension.
  const bool nameless = extension_of("x" + name) == ending;
  throw Error(ErrorCode::bad_input,
              nameless ? fmt::format("'{}' has no name before its extension", file)
                       : fmt::format("'{}' does not end in {}", file, ending),
              {}, nameless ? "write, for instance, picture" + ending : hint);
}

}  // namespace vug::cli
