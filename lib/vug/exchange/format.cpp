// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/require_kind.h>
#include <vug/exchange/format.h>

#include <fmt/format.h>

namespace vug::exchange {

const Format& format(const std::string& name) {
  return require_kind(formats(), name, fmt::format("unknown exchange format '{}'", name));
}

WriteReport write(const Format& format, const Assembly& assembly, const Space& space,
                  const std::filesystem::path& file, const FormatOptions& options,
                  Progress& progress) {
  const Space& there = format.space.value_or(space);
  FormatOptions with_variants = options;
  if (!options.variants.empty() && !format.variants)
    throw Error(ErrorCode::bad_input,
                fmt::format("files of the format {} have no variants", format.info.name));
  for (AssemblyVariant& each : with_variants.variants)
    each.assembly = std::make_shared<const Assembly>(converted(*each.assembly, there));
  return format.write(converted(assembly, there), file, with_variants, progress);
}

std::vector<std::pair<std::string, std::string>> read_metadata(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  const Format& known = format(extension.empty() ? extension : extension.substr(1));
  return known.read_metadata(read_text(file), file.string());
}

}  // namespace vug::exchange
