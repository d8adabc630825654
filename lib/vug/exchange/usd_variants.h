// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: several versions of an assembly in one USD layer.
#pragma once

#include <vug/exchange/format.h>
#include <vug/exchange/usd_layer.h>

namespace vug::exchange {

/// Writes the assembly and the variants of the options as the variant set "variant" of the root
/// prim, in which the assembly is called "default". Parts that are equal in all versions are
/// written once, outside of the variants.
void write_usd_variants(const Assembly& assembly, const std::filesystem::path& file,
                        const FormatOptions& options, UsdLayer& layer, WriteReport& written,
                        Progress& progress);

}  // namespace vug::exchange
