// SPDX-License-Identifier: Apache-2.0
// A verb with verbs of its own, such as `vug facade fit`.
#pragma once

#include "verb.h"

#include <vector>

namespace vug::cli {

/// Each verb becomes a subcommand; the message for a missing or unknown one lists them.
Verb verb_group(std::string name, std::string doc, std::vector<Verb> verbs);

}  // namespace vug::cli
