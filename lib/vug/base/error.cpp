// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>

#include <fmt/format.h>

#include <tuple>

namespace vug {

SourceLocation SourceLocation::up_to(const SourceLocation& last) const {
  return {file, line, column, last.end_line, last.end_column};
}

bool SourceLocation::contains(const SourceLocation& inner) const {
  return has_end() && inner.has_end() && file == inner.file &&
         std::tie(line, column) <= std::tie(inner.line, inner.column) &&
         std::tie(inner.end_line, inner.end_column) <= std::tie(end_line, end_column);
}

std::string to_string(const SourceLocation& where) {
  // An expression of the command line has one line, which the excerpt shows.
  if (!where.known() || where.file.starts_with("-D ")) return where.file;
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

std::string range_text(const SourceLocation& where) {
  if (!where.has_end()) return to_string(where);
  return fmt::format("{}-{}:{}", to_string(where), where.end_line, where.end_column);
}

Error::Error(ErrorCode code, const std::string& message, SourceLocation where, std::string hint)
    : std::runtime_error(message), code_(code), where_(std::move(where)), hint_(std::move(hint)) {}

std::string Error::located_message() const {
  return where_.known() ? fmt::format("{}: {}", to_string(where_), what()) : what();
}

Error& Error::within(std::string doing) {
  context_.push_back(std::move(doing));
  return *this;
}

}  // namespace vug
