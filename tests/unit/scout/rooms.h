// SPDX-License-Identifier: Apache-2.0
// Simple caves for the search of shots.
#pragma once

#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/scout/location.h>

#include <memory>
#include <string>

namespace vug::scout {

/// A loaded scene with its location.
struct Room {
  explicit Room(const std::string& text)
      : loaded(loading::load_text(text, "room.vug")), builder(loaded.shot) {
    EXPECT_TRUE(loaded.usable()) << loaded.report();
    location = prepare_location(builder, picture::plan_picture(loaded.shot));
  }
  loading::Loaded loaded;
  building::Builder builder;
  Location location;
};

/// Rock from x, z = -14 to 14 and y = -2 to 8 with air from (-12, 0, -3) to (12, 5, 3), and further
/// statements.
inline std::string hall(const std::string& more = "", const std::string& rock = "") {
  return "let solid = box(size: (28, 10, 28)).translate((0, 3, 0))\n"
         "let air = box(size: (24, 5, 6)).translate((0, 2.5, 0))\n"
         "volume rock = level_set(difference(solid, air)" +
         rock +
         ", voxel: 25cm)\n"
         "mesh cave on rock {}\nobject walls on cave {}\n" +
         more;
}

}  // namespace vug::scout
