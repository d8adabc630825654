// From text to document. All faults of a text are found in one run: after a fault the parser
// goes on at the next statement, entry or rule.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vug::scene {

struct ParseOptions {
  /// Where `include` looks after the including file's own folder.
  std::vector<std::filesystem::path> include_folders;
  /// Reads a file, or nothing when there is none; the default reads the disk.
  std::function<std::optional<std::string>(const std::filesystem::path&)> read;
  int max_nesting = 200;              ///< Brackets inside brackets.
  int max_depth = 1000;               ///< Height of an expression tree.
  int max_errors = 100;               ///< Of one file; further ones are dropped.
  size_t max_bytes = 8 << 20;         ///< Size of one file.
  size_t max_total_bytes = 64 << 20;  ///< Size of all files together.
};

/// Parses `text`, called `file` in messages and for relative includes. The document holds what
/// could be understood, and in `lost` what else there was: an Evaluator finds the further faults of
/// such a document, but nothing may be made of it.
Document parse(std::string text, const std::string& file, Diagnostics& diagnostics,
               const ParseOptions& options = {});

/// Reads and parses a file. Error(bad_input) when the file itself cannot be read.
Document parse_file(const std::filesystem::path& file, Diagnostics& diagnostics,
                    const ParseOptions& options = {});

/// One expression alone (`-D NAME=...`); null with diagnostics when it is none.
ExprPtr parse_expression(const std::string& text, const std::string& file, Diagnostics& diagnostics,
                         const ParseOptions& options = {});

}  // namespace vug::scene
