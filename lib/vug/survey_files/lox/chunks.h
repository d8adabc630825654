// SPDX-License-Identifier: Apache-2.0
// The chunks of Loch's .lox files [@therion2024]. A file is a sequence of chunks, each with four
// 32-bit numbers (type, bytes of all records, number of records, bytes of data), the records, and
// the data to which records refer by position and length. Numbers are little-endian.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vug::survey::lox {

enum Chunk : uint32_t { kSurveys = 1, kStations, kShots, kScraps, kSurfaces, kBitmaps };

// Bytes of a record.
constexpr size_t kSurveyRecord = 24;
constexpr size_t kStationRecord = 52;
constexpr size_t kShotRecord = 92;
constexpr size_t kScrapRecord = 32;

constexpr uint32_t kStationSurface = 1;
constexpr uint32_t kStationEntrance = 2;
constexpr uint32_t kStationFixed = 4;

constexpr uint32_t kShotSurface = 1;
constexpr uint32_t kShotDuplicate = 2;
constexpr uint32_t kShotWithoutSection = 8;
constexpr uint32_t kShotSplay = 16;

/// The shape of a cross-section; 0 means none.
constexpr uint32_t kOval = 1;

/// The angle in degrees above which Loch draws cross-sections horizontally.
constexpr double kVerticalThreshold = 60;

// Names of stations without a name: on a feature and on the wall.
constexpr const char* kAnonymous = ".";
constexpr const char* kAnonymousWall = "-";

// Limits that keep the memory for a damaged file in proportion to its size, because each station
// repeats the names of the surveys around it.
constexpr int kDeepestNesting = 100;
constexpr size_t kLongestName = 4000;

}  // namespace vug::survey::lox
