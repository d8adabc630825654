// SPDX-License-Identifier: Apache-2.0
#include "error_report.h"

#include "progress_bar.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/utf8.h>

#include <cstdio>

namespace vug::cli {

int print_error(const Error& error) {
  clear_progress_bar();
  // Messages quote names and files, which may contain arbitrary bytes.
  const std::string where = printable(to_string(error.where()));
  fmt::print(stderr, "{}{}error: {}\n", where, where.empty() ? "" : ": ", printable(error.what()));
  for (const std::string& doing : error.context())
    fmt::print(stderr, "  while {}\n", printable(doing));
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", printable(error.hint()));
  switch (error.code()) {
    case ErrorCode::bad_input:
    case ErrorCode::too_large:
      return kUnusable;
    case ErrorCode::io:
    case ErrorCode::cancelled:
    case ErrorCode::internal:
      break;
  }
  return kFailed;
}

void print_warning(const Error& error, const std::string& what) {
  fmt::print(stderr, "warning: {}; {}\n", printable(error.what()), what);
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", printable(error.hint()));
}

}  // namespace vug::cli
