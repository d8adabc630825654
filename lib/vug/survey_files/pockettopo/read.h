// SPDX-License-Identifier: Apache-2.0
// Reader of PocketTopo's .top files [@heeb2010].
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>

#include <string_view>

namespace vug::survey::pockettopo {

/// The shots in the bytes of a .top file of version 3. Successive shots between two stations are
/// averaged if they agree; others become legs of their own, with a warning. Shots without a second
/// station are splays, shots of length 0 between two stations equate them, and references fix
/// stations. Drawings are dropped. Throws Error(bad_input) with the byte offset for damaged files.
Observations read(std::string_view bytes, const std::string& file, Diagnostics& warnings);

}  // namespace vug::survey::pockettopo
