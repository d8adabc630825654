// SPDX-License-Identifier: Apache-2.0
// Helpers for tests of the language.
#pragma once

#include <gtest/gtest.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

namespace vug::scene {

/// Parses a document; the test fails if there are errors.
inline Document parsed(const std::string& text) {
  Diagnostics diagnostics;
  Document document = parse(text, "t.vug", diagnostics);
  EXPECT_EQ(report(diagnostics, document.sources), "") << text;
  return document;
}

/// The messages of all errors, one per line.
inline std::string faults(const std::string& text, const ParseOptions& options = {}) {
  Diagnostics diagnostics;
  parse(text, "t.vug", diagnostics, options);
  std::string out;
  for (const Diagnostic& one : diagnostics.all())
    out += std::to_string(one.where.line) + ": " + one.message + "\n";
  return out;
}

/// The canonical line of an expression.
inline std::string shape_of(const std::string& text) {
  Diagnostics diagnostics;
  const ExprPtr expr = parse_expression(text, "t", diagnostics);
  return expr ? dump(*expr) : diagnostics.all().at(0).message;
}

}  // namespace vug::scene
