// SPDX-License-Identifier: Apache-2.0
// The store of the command, and the text of reports on its products.
#pragma once

#include <vug/building/stored_products.h>
#include <vug/loading/load.h>

#include <string>

namespace vug::cli {

/// The user's store (store::default_folder) for the products of a scene; without a store if it is
/// off. A failure to store a product is a warning on stderr.
building::StoreUse store_use(const loading::Loaded& loaded);

/// "level_set 'rock': reused, saves 12.5 s" or "mesh 'rock': built in 3.1 s: polish has changed".
std::string to_text(const building::ProductReport& report);

}  // namespace vug::cli
