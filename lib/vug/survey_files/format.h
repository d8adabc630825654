// SPDX-License-Identifier: Apache-2.0
// Interface of survey file formats, and their choice by extension.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/schema.h>
#include <vug/survey/observations.h>

#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

namespace vug::survey {

struct ReadOptions {
  /// The folder that included files must lie in; empty: the folder of the first file.
  std::filesystem::path root;
  /// Lets included files lie anywhere.
  bool allow_outside = false;
  /// The most bytes that all files together may have.
  std::size_t max_bytes = std::size_t{1} << 30;
};

/// Text formats store measurements, .3d and .lox coordinates.
using Contents = std::variant<Observations, Survey>;

/// A file format, identified by its extension (the kind's name).
struct Format {
  KindInfo info;
  /// Parses `bytes` of `file`. Throws Error(bad_input) with the line (text) or byte offset (binary)
  /// for anything truncated, inconsistent, out of range or not finite; adds warnings to `warnings`.
  Contents (*read)(std::string_view bytes, const std::filesystem::path& file,
                   const ReadOptions& options, Diagnostics& warnings) = nullptr;
  /// The bytes of a file with this survey; null if the format is only read.
  std::string (*write)(const Survey& survey) = nullptr;
  /// A line that makes stations in the syntax of a text format, for the hint of empty files.
  const char* example = nullptr;
};

const std::vector<const Format*>& formats();

/// The format for a file's extension in any case; null for an unknown extension.
const Format* find_format(const std::filesystem::path& file);

/// The same, but throws Error(bad_input) for an unknown
/// extension.
const Format& format_of(const std::filesystem::path& file);

}  // namespace vug::survey
