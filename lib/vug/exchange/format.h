// SPDX-License-Identifier: Apache-2.0
// Interface of the file formats of whole assemblies. Each is a kind, named by its extension.
#pragma once

#include <vug/base/kind.h>
#include <vug/base/progress.h>
#include <vug/exchange/assembly.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::exchange {

/// Another version of an assembly, such as one with other parameters.
struct AssemblyVariant {
  std::string name;
  std::shared_ptr<const Assembly> assembly;
};

struct FormatOptions {
  /// Write repeated prototypes as instances instead of copies.
  bool instancing = true;
  /// Factor from W/sr/m^2 to the stored radiance of emissive surfaces; none: as the format defines.
  std::optional<double> emission_scale;
  /// File next to which the environment maps exist already; empty: they are written next to the own
  /// file.
  std::filesystem::path pictures_of = {};
  /// Written with the assembly into one file; only for formats that can contain them.
  std::vector<AssemblyVariant> variants = {};
};

/// The written files, and notes about them as full sentences.
struct WriteReport {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> unsupported;  ///< Data that the format cannot hold.
  std::vector<std::string> notes =
      {};  ///< Data stored in a form that not every reader understands.
};

struct Format {
  KindInfo info;
  std::optional<Space> space;  ///< Set if the format allows only one space.
  bool levels = false;         ///< Files can contain levels of detail in addition to the full mesh.
  /// The assembly must be in a space that the format allows. Files are complete or absent. Throws
  /// Error(io), Error(too_large).
  WriteReport (*write)(const Assembly& assembly, const std::filesystem::path& file,
                       const FormatOptions& options, Progress& progress) = nullptr;
  /// Parses the bytes of a whole file; see the function `read_metadata`.
  std::vector<std::pair<std::string, std::string>> (*read_metadata)(
      std::string_view bytes, const std::string& file) = nullptr;
  bool variants = false;  ///< Files can contain variants of the whole assembly.
};

const std::vector<const Format*>& formats();
/// Throws Error(bad_input), listing the known formats, for an unknown name.
const Format& format(const std::string& name);

/// Converts to `space`, or to that of the format, and writes. The same assembly gives the same
/// bytes. Error(bad_input) for variants that the format cannot contain.
WriteReport write(const Format& format, const Assembly& assembly, const Space& space,
                  const std::filesystem::path& file, const FormatOptions& options = {},
                  Progress& progress = Progress::none());

/// Reads the provenance of a file by name, "vug:recipe" and others; empty for files of other
/// programs. Throws Error(bad_input) if the file does not have the format of its extension or is
/// truncated.
std::vector<std::pair<std::string, std::string>> read_metadata(const std::filesystem::path& file);

/// Lumens per watt for formats in candela, lux or nits: 683, by which programs that count in watts
/// divide again.
inline constexpr double kLumenPerWatt = 683;

}  // namespace vug::exchange

/// Opens the one definition exported by a format's file, outside of any namespace.
#define VUG_EXCHANGE_FORMAT(name) VUG_EXPORT_KIND(vug::exchange, Format, name##_format)
