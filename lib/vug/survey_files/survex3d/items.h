// SPDX-License-Identifier: Apache-2.0
// The codes of the items of Survex's .3d files, version 8 [@survex2024].
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vug::survey::survex3d {

constexpr std::string_view kMagic = "Survex 3D Image File";
constexpr double kUnit = 0.01;  ///< Metres: coordinates are whole centimetres.

/// The first byte of an item. Codes 0 to 4 select the data style of the legs that follow; code 0
/// while the style is "normal" ends the file.
enum Item : uint8_t {
  kStyleNormal = 0x00,
  kStyleDiving = 0x01,
  kStyleCartesian = 0x02,
  kStyleCylpolar = 0x03,
  kStyleNosurvey = 0x04,
  kMove = 0x0f,
  kNoDate = 0x10,
  kDate = 0x11,
  kDateShortRange = 0x12,
  kDateRange = 0x13,
  kError = 0x1f,
  kSection = 0x30,      ///< Bit 0: the last of its tube; 16-bit distances.
  kWideSection = 0x32,  ///< The same with 32-bit distances.
  kLine = 0x40,         ///< Up to 0x7f, with the flags of a leg.
  kLabel = 0x80,        ///< Up to 0xff, with the flags of a station.
};

constexpr uint8_t kLastOfTube = 0x01;

constexpr uint8_t kLegSurface = 0x01;
constexpr uint8_t kLegDuplicate = 0x02;
constexpr uint8_t kLegSplay = 0x04;
constexpr uint8_t kSameLabel = 0x20;

constexpr uint8_t kStationSurface = 0x01;
constexpr uint8_t kStationUnderground = 0x02;
constexpr uint8_t kStationEntrance = 0x04;
constexpr uint8_t kStationExported = 0x08;
constexpr uint8_t kStationFixed = 0x10;
constexpr uint8_t kStationAnonymous = 0x20;
constexpr uint8_t kStationWall = 0x40;

/// Bit of the byte after the header: the coordinates are those of an extended elevation.
constexpr uint8_t kExtendedElevation = 0x80;

/// The most bytes of a label. Every item repeats the label, so a limit keeps the memory that a
/// damaged file needs in proportion to its size.
constexpr size_t kLongestLabel = 4000;

}  // namespace vug::survey::survex3d
