// SPDX-License-Identifier: Apache-2.0
// Stations by their names.
#pragma once

#include <vug/network/network.h>

#include <string_view>

namespace vug::network {

/// The index of the station with that full name, or with a full name that ends in "." and `name` if
/// there is only one, so that "choke2.14" finds "dow.choke2.14". A station also has the names that
/// the survey equates. Throws Error(bad_input) with the nearest names if there is none, and with
/// the candidates if there are several.
int find_station(const Network& network, std::string_view name);

}  // namespace vug::network
