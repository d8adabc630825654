// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: the beginning of a USD text.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_text.h>

#include <string>

namespace vug::exchange {

/// Writes the metadata of a layer: its provenance, its default prim and its space.
void write_usd_header(UsdText& out, const std::string& default_prim, const Provenance& from,
                      const Space& space);

}  // namespace vug::exchange
