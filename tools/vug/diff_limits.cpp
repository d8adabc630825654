// SPDX-License-Identifier: Apache-2.0
#include "diff_limits.h"

#include <fmt/format.h>
#include <vug/base/json_file.h>
#include <vug/scene/lexer.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace vug::cli {

image::Limit parse_limit(const std::string& text, image::Measure::Better better) {
  const bool low = better == image::Measure::Better::low;
  const char* option = low ? "--max" : "--min";
  const size_t equals = text.find('=');
  std::optional<Number> number;
  if (equals != std::string::npos) number = scene::read_number(text.substr(equals + 1));
  if (!number || (number->dimension != Dimension::none && number->dimension != Dimension::ratio))
    throw Error(ErrorCode::bad_input, fmt::format("invalid limit '{} {}'", option, text), {},
                low ? "write --max rmse=0.01 or --max N.rmse=0.01" : "write --min psnr=40");
  const image::Limit limit = image::limit_of(text.substr(0, equals), number->value);
  if (image::measure_of(limit.measure).better != better)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} values of {} are better", low ? "higher" : "lower", limit.measure),
                {}, fmt::format("write {} {}", low ? "--min" : "--max", text));
  return limit;
}

std::vector<image::Limit> limits_of(const nlohmann::ordered_json& object,
                                    const std::string& where) {
  if (!object.is_object())
    throw Error(ErrorCode::bad_input,
                fmt::format("the limits in '{}' are not a JSON object", where), {},
                "write {\"rmse\": 0.01, \"N.max\": 0.1}");
  std::vector<image::Limit> out;
  for (const auto& [name, value] : object.items()) {
    if (!value.is_number())
      throw Error(ErrorCode::bad_input,
                  fmt::format("the limit '{}' in '{}' is not a number", name, where), {},
                  "write {\"rmse\": 0.01, \"N.max\": 0.1}");
    try {
      out.push_back(image::limit_of(name, value.get<double>()));
    } catch (Error& error) {
      error.within(fmt::format("reading the limits in '{}'", where));
      throw;
    }
  }
  return out;
}

std::vector<image::Limit> read_limits(const std::filesystem::path& file) {
  return limits_of(read_json<nlohmann::ordered_json>(file, "see docs/guides/image_tests.md"),
                   file.string());
}

}  // namespace vug::cli
