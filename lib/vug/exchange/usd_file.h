// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: files of USD layers.
#pragma once

#include <vug/exchange/usd_layer.h>

#include <filesystem>
#include <functional>

namespace vug::exchange {

/// Calls `write` with a layer that becomes text. The file is complete on return; if anything throws, the previous file remains unchanged.
/// Throws Error(io).
void write_usd_file(const std::filesystem::path& file, const std::function<void(UsdLayer&)>& write);

}  // namespace vug::exchange
