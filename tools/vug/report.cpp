#include "report.h"

#include "bar.h"
#include "verb.h"

#include <fmt/format.h>

#include <cstdio>

namespace vug::cli {

int report(const Error& error) {
  clear_bar();
  const std::string where = to_string(error.where());
  fmt::print(stderr, "{}{}error: {}\n", where, where.empty() ? "" : ": ", error.what());
  for (const std::string& doing : error.context()) fmt::print(stderr, "  while {}\n", doing);
  if (!error.hint().empty()) fmt::print(stderr, "hint: {}\n", error.hint());
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

}  // namespace vug::cli
