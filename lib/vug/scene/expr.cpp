// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/expr.h>

namespace vug::scene {

SourceLocation word_at(const SourceLocation& where, const std::string& word) {
  return {where.file, where.line, where.column, where.line, where.column + utf8_count(word)};
}

}  // namespace vug::scene
