// Mesh files. Numbers in files are metres; what a format cannot hold is left out on writing
// (see each format's doc). Files of unknown extension name the extensions that are known.
#pragma once

#include <vug/base/schema.h>
#include <vug/mesh/comments.h>
#include <vug/mesh/mesh.h>

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace vug::mesh {

/// Takes the next bytes of a file being written.
using ByteSink = std::function<void(std::string_view)>;

/// One kind of file, known by its extension (the kind's name).
struct Format {
  KindInfo info;
  /// The mesh in `bytes`. Error(bad_input) with `file` and line (text) or byte offset (binary)
  /// for anything truncated, inconsistent, out of range or not finite.
  Mesh (*read)(std::string_view bytes, const std::string& file) = nullptr;
  void (*write)(const Mesh& mesh, const Comments& notes, const ByteSink& sink) = nullptr;
};

const std::vector<const Format*>& formats();

/// The format for a file's extension (any case); Error(bad_input) when there is none.
const Format& format_of(const std::filesystem::path& file);

Mesh read_mesh(const std::filesystem::path& file);

/// Writes beside the target and renames. The same mesh gives the same bytes.
void write_mesh(const Mesh& mesh, const std::filesystem::path& file, const Comments& notes = {});

}  // namespace vug::mesh
