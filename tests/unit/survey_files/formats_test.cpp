// SPDX-License-Identifier: Apache-2.0
// Behaviour that the formats of measurements share.
#include "faults.h"

#include <vug/survey/adjust.h>

namespace vug::survey {
namespace {

const std::string kMark = "\xef\xbb\xbf";  // The byte order mark of UTF-8.

std::string dat_head(const std::string& date) {
  return "CAVE\nSURVEY NAME: A\nSURVEY DATE: " + date +
         "\nSURVEY TEAM:\nme\nDECLINATION: 0 FORMAT: DDDDLUDRLADBF\n\nFROM TO\n\n";
}

/// The same two legs with readings that disagree, in each format of texts.
std::vector<std::pair<std::string, std::string>> texts(const std::string& bearings,
                                                       const std::string& gradients) {
  const std::string line = " 10 " + bearings + " " + gradients;
  return {
      {"svx", "*data normal from to tape compass backcompass clino backclino\nA B" + line + "\n"},
      {"th",
       "survey s\ncentreline\ndata normal from to length compass backcompass clino backclino\n"
       "A B" +
           line + "\nendcentreline\nendsurvey\n"}};
}

std::string messages_of(const std::string& format, const std::string& bytes) {
  Diagnostics warnings;
  format_of("x." + format).read(bytes, "x." + format, {}, warnings);
  std::string all;
  for (const Diagnostic& each : warnings.all()) all += each.message + "\n";
  return all;
}

TEST(Formats, ReadingsThatDisagreeHaveOneWarning) {
  const std::string compass =
      "the readings of the compass in both directions differ by 7.1 standard deviations\n";
  const std::string clino =
      "the readings of the clino in both directions differ by 7.1 standard deviations\n";
  for (const auto& [format, text] : texts("90 275", "0 0"))
    EXPECT_EQ(messages_of(format, text), compass);
  for (const auto& [format, text] : texts("90 270", "5 0"))
    EXPECT_EQ(messages_of(format, text), clino);
  EXPECT_EQ(messages_of("srv", "A B 10 90/275 0/0\n"), compass);
  EXPECT_EQ(messages_of("srv", "A B 10 90/270 5/0\n"), clino);
  EXPECT_EQ(messages_of("dat", dat_head("7 10 1979") + "A B 10 90 0 0 0 0 0 275 0\n"), compass);
  EXPECT_EQ(messages_of("dat", dat_head("7 10 1979") + "A B 10 90 5 0 0 0 0 270 0\n"), clino);
}

TEST(Formats, ByteOrderMarksAreSkipped) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"svx", "1 2 10 0 0\n"},
      {"srv", "1 2 10 0 0\n"},
      {"th", "centreline\ndata normal from to length compass clino\n1 2 10 0 0\nendcentreline\n"},
      {"dat", dat_head("7 10 1979") + "1 2 10 0 0 0 0 0 0 180 0\n"}};
  for (const auto& [format, text] : files) {
    SCOPED_TRACE(format);
    const auto read = std::get<Observations>(read_bytes(format, kMark + text));
    ASSERT_EQ(read.stations.size(), 2U);
    EXPECT_EQ(read.stations[0].name, "1");
  }
  EXPECT_EQ(std::get<Survey>(read_bytes("plt", kMark + "SMain\n")).title, "Main");
}

TEST(Formats, DaysThatDoNotExistAreRefused) {
  expect_faults("srv", {{"#date 2001-02-31\n", 1, "the day of '2001-02-31' does not exist"},
                        {"#date 4/31/2001\n", 1, "the day of '2001-4-31' does not exist"}});
  expect_faults("dat", {{dat_head("2 31 1979"), 3, "the day of '1979-2-31' does not exist"}});
  expect_faults("plt", {{"N x D 2 31 1979\n", 1, "the day of '1979-2-31' does not exist"}});
  expect_faults("svx", {{"*date 2001.02.31\n", 1, "the day of '2001.02.31' does not exist"}});
}

TEST(Formats, StationsAreOnTheSurfaceOrUnderground) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"svx", "A B 10 0 0\n*flags surface\nB C 10 0 0\n"},
      {"th",
       "centreline\ndata normal from to length compass clino\nA B 10 0 0\nflags surface\n"
       "B C 10 0 0\nendcentreline\n"},
      {"srv", "A B 10 0 0\n"},
      {"dat", dat_head("7 10 1979") + "A B 10 0 0 0 0 0 0 180 0\n"}};
  for (const auto& [format, text] : files) {
    SCOPED_TRACE(format);
    Diagnostics warnings;
    const Survey survey = adjust(std::get<Observations>(read_bytes(format, text)), warnings);
    EXPECT_TRUE(survey.stations[0].underground && !survey.stations[0].surface);
    EXPECT_TRUE(survey.stations[1].underground);
    if (survey.legs.size() < 2) continue;
    EXPECT_TRUE(survey.stations[1].surface);
    EXPECT_TRUE(survey.stations[2].surface && !survey.stations[2].underground);
  }
}

TEST(Formats, TheFirstFileIsNotLargerThanTheLimit) {
  ReadOptions small;
  small.max_bytes = 5;
  Diagnostics warnings;
  for (const char* file : {"x.svx", "x.th", "x.mak"}) try {
      format_of(file).read("123456", file, small, warnings);
      ADD_FAILURE() << file;
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "the files of the survey exceed 5 bytes");
      EXPECT_EQ(error.where().file, file);
    }
}

}  // namespace
}  // namespace vug::survey
