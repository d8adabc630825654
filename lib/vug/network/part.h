// SPDX-License-Identifier: Apache-2.0
// Parts of a network: the legs of a survey, a zone or a tier.
#pragma once

#include <vug/network/network.h>

#include <optional>
#include <string>
#include <string_view>

namespace vug::network {

/// The conditions of the legs of a part; all must hold.
struct PartOptions {
  std::string name{};  ///< See is_in_survey; empty: all legs.
  std::optional<Stage> stage = std::nullopt;
  std::optional<int> tier = std::nullopt;
  bool rest = false;  ///< The legs for which a condition does not hold instead.
};

/// Whether the levels of `name`, separated by dots, are consecutive levels of the leg's survey, or
/// of the names of both stations if the leg has no survey: "choke2" and "dow.choke2" match a leg of
/// "dow.choke2.inlet".
bool is_in_survey(const Network& network, const Leg& leg, std::string_view name);

/// The network with the legs of the part and all stations. Throws Error(bad_input) if no leg is in
/// the part.
Network part_of(const Network& network, const PartOptions& options);

}  // namespace vug::network
