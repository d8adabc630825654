// Files that hold a whole assembly. Each is a kind; its name is its extension.
#pragma once

#include <vug/base/kind.h>
#include <vug/base/progress.h>
#include <vug/exchange/assembly.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::exchange {

struct FormatOptions {
  /// Many of one part as one thing that repeats; else each on its own.
  bool instancing = true;
  /// Numbers for the radiance of shining surfaces over W/sr/m^2; none: as the format defines them.
  std::optional<double> emission_scale;
  /// Beside this file pictures of skies lie already; empty: they are written beside the own.
  std::filesystem::path pictures_of = {};
};

/// What was written, and in sentences what is told of it.
struct WriteReport {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> unsupported;  ///< What the format cannot hold.
  std::vector<std::string> notes = {};   ///< What it holds so that not every reader understands it.
};

struct Format {
  KindInfo info;
  std::optional<Space> space;  ///< Where the format allows one only.
  bool levels = false;         ///< A file holds levels of detail beside the whole.
  /// The assembly stands in a space that the format allows. Files are whole or not there.
  /// Error(io), Error(too_large).
  WriteReport (*write)(const Assembly& assembly, const std::filesystem::path& file,
                       const FormatOptions& options, Progress& progress) = nullptr;
  /// Of a whole file's bytes; see the function of that name.
  std::vector<std::pair<std::string, std::string>> (*read_metadata)(
      std::string_view bytes, const std::string& file) = nullptr;
};

const std::vector<const Format*>& formats();
/// Error(bad_input), with those that there are, where there is none of that name.
const Format& format(const std::string& name);

/// Converts to `space`, or to that of the format, and writes. The same assembly, the same bytes.
WriteReport write(const Format& format, const Assembly& assembly, const Space& space,
                  const std::filesystem::path& file, const FormatOptions& options = {},
                  Progress& progress = Progress::none());

/// The texts of a file's provenance by name, "vug:recipe" and others; none in others' files.
/// Error(bad_input) for what is no file of the format that its extension names, or cut off.
std::vector<std::pair<std::string, std::string>> read_metadata(const std::filesystem::path& file);

/// Lumen to a watt where a format counts in candela, lux or nits: 683, which programs divide by
/// that count in watts again.
inline constexpr double kLumenPerWatt = 683;

}  // namespace vug::exchange

/// Opens the one definition that a format's file exports, from outside of any namespace.
#define VUG_EXCHANGE_FORMAT(name) VUG_EXPORT_KIND(vug::exchange, Format, name##_format)
