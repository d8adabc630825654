// SPDX-License-Identifier: Apache-2.0
#include "../scan/external_data.h"
#include "faults.h"

#include <vug/base/atomic_file.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey {
namespace {

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

constexpr int32_t kNobody = INT32_MIN;
constexpr int32_t id(int series, int station) { return series << 16 | station; }

struct RawShot {
  int32_t from = 0, to = 0, millimetres = 0;
  double bearing = 0, gradient = 0;  // degrees
  int16_t trip = 0;
  std::string comment{};
};

/// A file with one trip on 2020-11-09, a declination of 4 degrees, and a reference point.
std::string top_file(const std::vector<RawShot>& shots, bool reference = false) {
  std::string bytes = "Top\3";
  put<uint32_t>(bytes, 1);
  put<int64_t>(bytes, 637'404'768'000'000'000);
  bytes += std::string("\4trip", 5);
  put<int16_t>(bytes, static_cast<int16_t>(4 * 65536 / 360));
  put(bytes, static_cast<uint32_t>(shots.size()));
  for (const RawShot& shot : shots) {
    put(bytes, shot.from);
    put(bytes, shot.to);
    put(bytes, shot.millimetres);
    put(bytes, static_cast<uint16_t>(std::lround(shot.bearing * 65536 / 360)));
    put(bytes, static_cast<int16_t>(std::lround(shot.gradient * 65536 / 360)));
    put<uint8_t>(bytes, shot.comment.empty() ? 0 : 2);
    put<uint8_t>(bytes, 9);
    put(bytes, shot.trip);
    if (!shot.comment.empty()) {
      put(bytes, static_cast<uint8_t>(shot.comment.size()));
      bytes += shot.comment;
    }
  }
  put<uint32_t>(bytes, reference ? 1 : 0);
  if (reference) {
    put(bytes, id(1, 0));
    put<int64_t>(bytes, 452'000'123);
    put<int64_t>(bytes, 5'123'000'456);
    put<int32_t>(bytes, 1'234'500);
    bytes += std::string("\3pit", 4);
  }
  bytes += std::string(12, '\0');
  for (int drawing = 0; drawing < 2; ++drawing) {
    bytes += std::string(12, '\0');
    bytes += std::string("\1\1\0\0\0........\1\3", 15) + std::string(16, '.') + '\0';
  }
  return bytes;
}

Observations read_top(const std::string& bytes, Diagnostics& warnings) {
  return std::get<Observations>(format_of("x.top").read(bytes, "x.top", {}, warnings));
}

TEST(PocketTopo, RepeatedShotsAreAveraged) {
  Diagnostics warnings;
  const Observations survey = read_top(top_file({{id(1, 0), id(1, 1), 10000, 89.5, 0},
                                                 {id(1, 0), id(1, 1), 10030, 90.5, 0},
                                                 {id(1, 1), id(1, 0), 10030, 270, 0},
                                                 {id(1, 1), kNobody, 2000, 86, 45},
                                                 {kNobody, id(1, 1), 2000, 266, -45},
                                                 {id(1, 1), id(1, 2), 0, 0, 0},
                                                 {id(1, 2), kNobody + 8, 5000, 356, 0, -1}},
                                                true),
                                       warnings);
  EXPECT_TRUE(warnings.all().empty());
  EXPECT_EQ(survey.title, "trip");
  ASSERT_EQ(survey.legs.size(), 4U);
  const ObservedLeg& leg = survey.legs[0];
  EXPECT_NEAR(leg.leg.length, 10.02, 1e-9);
  EXPECT_NEAR(leg.vector.x, 10.02 * std::cos(4 * kPi / 180), 1e-3);
  EXPECT_NEAR(leg.vector.y, -10.02 * std::sin(4 * kPi / 180), 1e-3);
  // Three readings of 5 cm, rotated by 4 degrees.
  const double tape = 0.05 * 0.05 / 3, across = std::pow(10.02 * 0.5 * kPi / 180, 2) / 3;
  EXPECT_NEAR(leg.covariance.xx + leg.covariance.yy, tape + across + 2 * 0.05 * 0.05 / 3, 1e-6);
  ASSERT_TRUE(leg.leg.date);
  EXPECT_EQ(leg.leg.date->first, 44142);  // 2020-11-09
  EXPECT_EQ(leg.leg.survey, "1");
  // Both splays end at the same point.
  EXPECT_TRUE(survey.legs[1].leg.splay && survey.legs[2].leg.splay);
  EXPECT_NEAR((survey.legs[1].vector - survey.legs[2].vector).length(), 0, 1e-3);
  EXPECT_NEAR(survey.legs[1].vector.x, std::sqrt(2.0), 1e-3);
  EXPECT_TRUE(survey.stations[static_cast<size_t>(survey.legs[1].leg.to)].wall);
  ASSERT_EQ(survey.equates.size(), 1U);
  // Plain numbers count from the smallest integer. A leg outside of all trips keeps its bearing.
  EXPECT_EQ(survey.stations[static_cast<size_t>(survey.legs[3].leg.to)].name, "7");
  EXPECT_NEAR(survey.legs[3].vector.x, -5 * std::sin(4 * kPi / 180), 1e-3);
  EXPECT_FALSE(survey.legs[3].leg.date);
  ASSERT_EQ(survey.fixes.size(), 1U);
  EXPECT_EQ(survey.fixes[0].position, Vec3d(452000.123, 5123000.456, 1234.5));
  EXPECT_EQ(survey.stations[static_cast<size_t>(survey.fixes[0].station)].comment, "pit");
}

TEST(PocketTopo, ShotsThatDisagreeAreLegsOfTheirOwn) {
  Diagnostics warnings;
  const Observations survey = read_top(top_file({{id(1, 0), id(1, 1), 10000, 90, 0},
                                                 {id(1, 0), id(1, 1), 10060, 90, 0},
                                                 {id(1, 0), id(1, 1), 10060, 92, 0, 0, "comment"},
                                                 {kNobody, kNobody, 1, 0, 0},
                                                 {id(1, 1), id(1, 1), 1, 0, 0}}),
                                       warnings);
  EXPECT_EQ(survey.legs.size(), 3U);
  ASSERT_EQ(warnings.all().size(), 4U);
  EXPECT_EQ(warnings.all()[0].message,
            "shot 2 from 1.0 to 1.1 differs from the previous one by more than 5 cm or 1.7 degrees "
            "and became a leg of its own");
  EXPECT_EQ(warnings.all()[2].message, "shot 4 has no stations and was dropped");
  EXPECT_EQ(warnings.all()[3].message, "shot 5 leads from 1.1 to itself and was dropped");
}

TEST(PocketTopo, FaultsNameTheirByte) {
  const std::string shots = top_file({{id(1, 0), id(1, 1), 10000, 90, 0}});
  const auto with = [&](size_t at, const std::string& bytes) {
    return std::string(shots).replace(at, bytes.size(), bytes);
  };
  const std::string four = "\xff\xff\xff\xff";
  expect_faults(
      "top",
      {
          {"", 0, "the file does not begin as a PocketTopo file (byte 0)"},
          {"Tip\3....", 0, "the file does not begin as a PocketTopo file (byte 0)"},
          {"Top\2....", 0, "the version of the .top file is 2, but only 3 is supported (byte 3)"},
          {with(4, four), 0, "the file is too short for 4294967295 entries (byte 4)"},
          {with(16, four + four), 0, "the length of a text has more than 5 bytes (byte 16)"},
          {with(16, "\xf0\x7f"), 0, "the file ends too early (byte 18)"},
          {with(23, four), 0, "the file is too short for 4294967295 entries (byte 23)"},
          {with(35, four), 0, "the length of shot 1 is negative: -1 mm (byte 27)"},
          {with(45, "\1"), 0, "shot 1 belongs to trip 1 of 1 (byte 27)"},
          {with(45, "\xfe\xff"), 0, "shot 1 belongs to trip -2 of 1 (byte 27)"},
          {with(75, "\2"), 0, "unknown element 2 of a drawing (byte 75)"},
          {with(76, four), 0, "the file is too short for 4294967295 entries (byte 76)"},
      });
}

TEST(PocketTopo, CoordinatesBeyondTheLimitAreRefused) {
  std::string far = top_file({{id(1, 0), id(1, 1), 10000, 90, 0}}, true);
  const size_t east = far.find("\3pit") - 20;
  far[east + 7] = '\x10';  // 1e15 m
  expect_faults("top", {{far, 0, fmt::format("a coordinate exceeds 1000000 km (byte {})", east)}});
}

TEST(PocketTopo, DamagedFilesAreRefusedOrRead) {
  EXPECT_EQ(
      read_damaged(
          "top",
          top_file({{id(1, 0), id(1, 1), 10000, 90, 0}, {id(1, 1), kNobody, 2000, 90, 45}}, true)),
      0U);
}

TEST(PocketTopo, FlakePotHasItsShots) {
  const std::filesystem::path file = external_data() / "surveys" / "applecross" / "flake-pot.top";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with surveys/applecross";
  Diagnostics warnings;
  const Observations survey = read_top(read_text(file), warnings);
  std::vector<const ObservedLeg*> splays, legs;
  for (const ObservedLeg& leg : survey.legs) (leg.leg.splay ? splays : legs).push_back(&leg);
  // 153 shots: 120 splays, two that equate series, and 31 shots of 10 legs.
  EXPECT_EQ(splays.size(), 120U);
  EXPECT_EQ(legs.size(), 10U);
  EXPECT_EQ(survey.equates.size(), 2U);
  EXPECT_TRUE(warnings.all().empty());
  const auto degrees = [](double radians) { return radians * 180 / kPi; };
  const auto expect_leg = [&](const ObservedLeg& leg, double length, double bearing, double clino,
                              double tolerance) {
    EXPECT_NEAR(leg.leg.length, length, tolerance);
    EXPECT_NEAR(degrees(std::atan2(leg.vector.x, leg.vector.y)), bearing, 10 * tolerance);
    EXPECT_NEAR(degrees(std::asin(leg.vector.z / leg.vector.length())), clino, 10 * tolerance);
  };
  expect_leg(*splays[0], 0.647, 78.92, -30.32, 6e-4);
  // The first of three shots of the leg is 2.435 m, 90.79 and -61.53 degrees.
  expect_leg(*legs[0], (2.435 + 2.440 + 2.435) / 3, (90.79 + 90.96 + 90.96) / 3,
             (-61.53 - 61.62 - 61.51) / 3, 2e-3);
  EXPECT_EQ(survey.stations[static_cast<size_t>(legs[0]->leg.from)].name, "200.0");
  EXPECT_EQ(survey.stations[static_cast<size_t>(legs[0]->leg.to)].name, "200.1");
}

}  // namespace
}  // namespace vug::survey
