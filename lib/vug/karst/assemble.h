// SPDX-License-Identifier: Apache-2.0
// Internal to karst: the network of a plan.
#pragma once

#include <vug/karst/plan.h>
#include <vug/karst/samples.h>

namespace vug::karst {

/// Shapes all passages and names stations and legs. Throws Error(bad_input) if two key points have
/// the same name.
network::Network assemble(const Plan& plan, const KeyPoints& keys, const Samples& samples,
                          const Rock& rock, const KarstOptions& options);

}  // namespace vug::karst
