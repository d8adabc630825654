// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>

#include <fmt/format.h>

namespace vug {

std::string to_string(const SourceLocation& where) {
  if (!where.known()) return where.file;
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

Error::Error(ErrorCode code, const std::string& message, SourceLocation where, std::string hint)
    : std::runtime_error(message), code_(code), where_(std::move(where)), hint_(std::move(hint)) {}

Error& Error::within(std::string doing) {
  context_.push_back(std::move(doing));
  return *this;
}

}  // namespace vug
