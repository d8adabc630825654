// SPDX-License-Identifier: Apache-2.0
// The products of a shot that a build would reuse or make, without building anything.
#pragma once

#include <vug/building/stored_products.h>
#include <vug/shot/shot.h>

namespace vug::building {

/// The drips that were stored before, the level sets of the volumes, and the meshes on them that
/// are shown or declared; those that depend on other meshes, whose content is not known before they
/// are built, are left out.
std::vector<ProductReport> explain_products(const shot::Shot& shot, const StoreUse& use);

}  // namespace vug::building
