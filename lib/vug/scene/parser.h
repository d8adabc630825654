// SPDX-License-Identifier: Apache-2.0
// Parser of scene texts. All syntax errors of a text are found in one run: after an error the
// parser continues with the next statement, entry or rule.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>
#include <vug/scene/file_reader.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::scene {

struct ParseOptions {
  /// Folders that `include` searches after the including file's folder.
  std::vector<std::filesystem::path> include_folders;
  FileReader read;            ///< The default reads from disk.
  bool check_modules = true;  ///< Report unknown parameters of modules.
  /// Texts of further statements that belong to the text. Messages call them `appended`, `appended
  /// 2`, ..., and relative paths in them start at the folder of the text.
  std::vector<std::string> appended;
  int max_nesting = 200;              ///< Nesting depth of brackets.
  int max_depth = 1000;               ///< Height of an expression tree.
  int max_errors = 100;               ///< Reported errors per file; further ones are dropped.
  size_t max_bytes = 8 << 20;         ///< Size of one file.
  size_t max_total_bytes = 64 << 20;  ///< Size of all files together.
};

/// Parses `text`; `file` is its name in messages and for relative includes. After syntax errors the
/// document contains the valid parts, and `skipped` the names in the rest. An Evaluator can find
/// further errors of such a document, but no products may be built from it.
Document parse(std::string text, const std::string& file, Diagnostics& diagnostics,
               const ParseOptions& options = {});

/// Reads and parses a file. Throws Error(bad_input) if the file cannot be read.
Document parse_file(const std::filesystem::path& file, Diagnostics& diagnostics,
                    const ParseOptions& options = {});

/// Parses a single expression (`-D NAME=...`); null, with diagnostics, after a syntax error.
ExprPtr parse_expression(const std::string& text, const std::string& file, Diagnostics& diagnostics,
                         const ParseOptions& options = {});

}  // namespace vug::scene
