// SPDX-License-Identifier: Apache-2.0
// Interface of mesh file formats, and their choice by extension. Coordinates in files are in
// metres. Data that a format cannot hold is dropped on writing (see the documentation of each
// format). The error for an unknown extension lists the known extensions.
#pragma once

#include <vug/base/schema.h>
#include <vug/mesh/comments.h>
#include <vug/mesh/mesh.h>

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace vug::mesh {

/// Takes the next bytes of a file that is being written.
using ByteSink = std::function<void(std::string_view)>;

/// A file format, identified by its extension (the kind's name).
struct Format {
  KindInfo info;
  /// Parses `bytes`. Throws Error(bad_input) with `file` and the line (text) or byte offset
  /// (binary) for anything truncated, inconsistent, out of range or not finite.
  Mesh (*read)(std::string_view bytes, const std::string& file) = nullptr;
  void (*write)(const Mesh& mesh, const Comments& notes, const ByteSink& sink) = nullptr;
};

const std::vector<const Format*>& formats();

/// Returns the format for a file's extension in any case; throws Error(bad_input) for an unknown
/// extension.
const Format& format_of(const std::filesystem::path& file);

Mesh read_mesh(const std::filesystem::path& file);

/// Writes to a temporary file next to the target and renames it. The same mesh gives the same
/// bytes.
void write_mesh(const Mesh& mesh, const std::filesystem::path& file, const Comments& notes = {});

}  // namespace vug::mesh
