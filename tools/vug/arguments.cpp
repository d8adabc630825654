#include "arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/scene/lexer.h>

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
      return fmt::format("'{}' is no number {}", text, bounds);
    if (!(number->value >= low && number->value <= high))
      return fmt::format("{} is not {}", text, bounds);
    text = fmt::format("{}", number->value);
    return {};
  };
  return CLI::Validator(read, "");
}

CLI::Validator integer_in(int low, int high) {
  const auto check = [=](std::string& text) -> std::string {
    int number = 0;
    if (parse_integer(text, number) && number >= low && number <= high) return {};
    return fmt::format("'{}' is no whole number from {} to {}", text, low, high);
  };
  return CLI::Validator(check, "");
}

CLI::Validator seed_number() {
  const auto check = [](std::string& text) -> std::string {
    uint64_t number = 0;
    return parse_integer(text, number) ? ""
                                       : fmt::format("'{}' is no whole number from 0 on", text);
  };
  return CLI::Validator(check, "");
}

Error unknown_verb_error(const std::string& word, const std::vector<std::string>& verbs,
                         const std::string& before) {
  const std::string after = before.empty() ? "" : before + " ";
  if (word.empty())
    return Error(ErrorCode::bad_input, "there is no verb", {},
                 fmt::format("say what to do: vug {}{}; 'vug {}--help' tells more", after,
                             fmt::join(verbs, ", "), after));
  return Error(ErrorCode::bad_input, fmt::format("there is no verb '{}{}'", after, word), {},
               suggestion(word, verbs));
}

void require_extension(const std::string& file, const std::string& ending,
                       const std::string& hint) {
  const std::string name = std::filesystem::path(file).filename().string();
  if (extension_of(file) == ending) return;
  // A name that begins with its only dot has no ending for the system.
  const bool nameless = extension_of("x" + name) == ending;
  throw Error(ErrorCode::bad_input,
              nameless ? fmt::format("'{}' has no name before its ending", file)
                       : fmt::format("'{}' does not end in {}", file, ending),
              {}, nameless ? "write for instance picture" + ending : hint);
}

}  // namespace vug::cli
