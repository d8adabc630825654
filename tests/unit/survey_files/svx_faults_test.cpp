// SPDX-License-Identifier: Apache-2.0
// Broken .svx texts with the line and the exact message of their error.
#include "faults.h"

namespace vug::survey {
namespace {

TEST(SvxFaults, MessagesAndLines) {
  expect_faults(
      "svx",
      {
          {"1 2 3 x 5\n", 1, "expected a number, found 'x'"},
          {"1 2 10 90\n", 1,
           "expected a gradient, 'up', 'down', 'level' or '-', found the end of the line"},
          {"1 2 10 90 0 7\n", 1, "unexpected '7' at the end of the line"},
          {"1 2 1e3 90 0\n", 1, "expected a number, found 'e3'"},
          {"1 1 10 90 0\n", 1, "both stations of the leg are '1'"},
          {"1 2 10 - 5\n", 1, "the compass reading is missing"},
          {"1 2 - 90 5\n", 1, "the leg has no length"},
          {".. . 10 90 5\n", 1, "both stations of the leg are anonymous"},
          {"1 a$ 10 90 5\n", 1, "expected a number, found '$'"},
          {"1 b. 10 90 5\n", 1, "expected a station, found 'b.'"},
          {"*foo\n", 1, "unknown command '*foo'"},
          {"*bgin x\n", 1, "unknown command '*bgin'"},
          {"*begin a\n1 2 3 4 5\n*end b\n", 3, "*end does not match '*begin a' in line 1"},
          {"*begin a\n1 2 3 4 5\n", 1, "*begin without *end in this file"},
          {"*end\n", 1, "*end without *begin in this file"},
          {"*data norml from to\n", 1, "expected a data style, found 'norml'"},
          {"*data normal from to tape compas clino\n", 1, "expected a reading, found 'compas'"},
          {"*data normal from to tape tape\n", 1, "the reading 'tape' is repeated"},
          {"*data normal from to compass clino\n", 1,
           "the style 'normal' lacks tape, backtape, or 'fromcount tocount'"},
          {"*data diving from to tape compass\n", 1,
           "the style 'diving' lacks 'fromdepth todepth', depthchange, or 'station depth newline'"},
          {"*data cartesian from to easting northing\n", 1, "the style 'cartesian' lacks altitude"},
          {"*data normal from to tape newline compass\n", 1,
           "'newline' follows the station, its depth and its count, once"},
          {"*data normal from to tape compass clino left\n", 1,
           "the style 'normal' has no reading 'left'"},
          {"*units tape furlongs\n", 1, "expected a unit, found 'furlongs'"},
          {"*units tape degrees\n", 1, "'degrees' is not a unit of this quantity"},
          {"*units tape compass metres\n", 1, "angles and lengths cannot be set by one command"},
          {"*units compass percent\n", 1, "'percent' is not a unit of this quantity"},
          {"*sd tape 0 metres\n", 1, "the standard deviation is out of range"},
          {"*sd tape 0.1\n", 1, "expected a unit, found the end of the line"},
          {"*cartesian north\n", 1, "expected 'grid', 'magnetic' or 'true', found 'north'"},
          {"*cartesian true rotation 10 degrees\n", 1,
           "the rotation of '*cartesian' is not supported"},
          {"*cs OSGB:SD\n*cs out EPSG:27700\n*cartesian true\n"
           "*data cartesian from to easting northing altitude\n1 2 3 4 5\n",
           5, "the north of '*cartesian' depends on the place, which is not known"},
          {"*calibrate tape\n", 1, "expected the zero error, found the end of the line"},
          {"*calibrate tape 0 0\n", 1, "the scale is out of range"},
          {"*calibrate declination 3 2\n", 1, "the scale of declination is not 1"},
          {"*declination 3\n", 1, "expected a unit, found the end of the line"},
          {"*declination auto 1 2 3\n", 1, "'*declination auto' without '*cs'"},
          {"*fix 1 2 3\n", 1, "expected the altitude, found the end of the line"},
          {"*fix 1 0 0 0 .1 .2 .3 .4\n", 1, "a fix has 1, 2, 3 or 6 accuracies, not 4"},
          {"*fix 1 0 0 0 -1\n", 1, "a standard deviation is out of range"},
          {"*fix 1 0 0 0 1 1 1 5 5 5\n", 1,
           "the covariances are too large for the standard deviations"},
          {"*cs nowhere\n", 1, "unknown coordinate system 'nowhere'"},
          {"*cs UTM30N\n*fix 1 0 0 0\n", 2, "*fix after '*cs' but before '*cs out'"},
          {"*cs out EPSG:4326\n", 1,
           "the coordinates of 'EPSG:4326' are degrees, but those of a survey are metres"},
          {"*cs out long-lat\n", 1,
           "the coordinates of 'long-lat' are degrees, but those of a survey are metres"},
          {"*cs out EPSG:4258\n", 1,
           "the coordinates of 'EPSG:4258' are degrees, but those of a survey are metres"},
          {"*cs out EPSG:2277\n", 1,
           "the unit of 'EPSG:2277' is 0.304801 m, but the coordinates of a survey are metres"},
          {"1 2 100000000 90 0\n", 1,
           "the leg is longer than 10000 km, or its standard deviations are too large"},
          {"1 2 10 90 0\n*data passage station left right up down\n1 1 99999 1 1\n", 3,
           "a distance to a wall exceeds 10 km"},
          {"*cs UTM30N\n*cs out UTM30N\n*declination auto 500000 5000000 0\n*date 1850.06.01\n"
           "1 2 10 90 0\n",
           5, "the magnetic declination of the year 1850 is unknown"},
          {"*date 1990.01.0\n", 1, "the day of '1990.01.0' does not exist"},
          {"*equate 1\n", 1, "*equate names one station"},
          {"*export 1\n", 1, "*export outside of a survey"},
          {"*flags splat\n", 1, "expected a flag, found 'splat'"},
          {"*infer plumbs maybe\n", 1, "expected 'on' or 'off', found 'maybe'"},
          {"*case upper\n", 1, "expected 'preserve', 'toupper' or 'tolower', found 'upper'"},
          {"*set colour x\n", 1, "expected a class of characters, found 'colour'"},
          {"*set blank abc\n", 1, "letters and digits have a fixed meaning"},
          {"*alias station . ..\n", 1, "*alias defines '-' only"},
          {"*truncate 0\n", 1, "names are truncated to 1 to 1000 characters"},
          {"*date 2001.02.30\n", 1, "the day of '2001.02.30' does not exist"},
          {"*date today\n", 1, "expected a date, found 'today'"},
          {"*title \"open\n", 1, "the text has no closing '\"'"},
          {"*title\n", 1, "*title without a text"},
          {"*require one\n", 1, "'one' is not a version of Survex"},
          {"1 2 3,5 4 999999999999999999\n", 1,
           "unexpected '999999999999999999' at the end of the line"},
          {"*include\n", 1, "expected the name of a file, found the end of the line"},
          {"*units compass quadrants\n1 2 10 X30E 0\n", 2,
           "expected a bearing in quadrants, found 'X30E'"},
          {"*data normal from to tape compass clino backclino\n1 2 3 4 up up\n", 2,
           "the clino readings contradict each other"},
          {"*data passage station left right up down\n.. 1 2 3 4\n", 2,
           "an anonymous station has no cross-section"},
          {"*entrance ..\n", 1, "expected a station, found '..'"},
      });
}

TEST(SvxFaults, Columns) {
  const auto range_of = [](const std::string& text) {
    try {
      read_bytes("svx", text);
    } catch (const Error& error) {
      return range_text(error.where());
    }
    return std::string("no error");
  };
  EXPECT_EQ(range_of("1 2 3 x 5\n"), "x.svx:1:7-1:8");
  EXPECT_EQ(range_of("; \xC3\xA9\n\t\xC3\xA9 2 3 4 5"), "x.svx:2:2-2:3");
  EXPECT_EQ(range_of("*title \"\xC3\xA9t\xC3\xA9\" rest\r\n"), "x.svx:1:14-1:18");
  EXPECT_EQ(range_of("a b 1 2\r\n"), "x.svx:1:8-1:9");
  EXPECT_EQ(range_of("a b 1 2 3\ra a 1 2 3\r"), "x.svx:2:1-2:10");
}

TEST(SvxFaults, DamagedTextsNeverCrash) {
  const std::string text =
      "*begin a\n*fix 1 0 0 0\n*data normal station newline tape compass clino\n1\n3 4 5\n2\n\n"
      "*end a\n*calibrate tape 1 feet 2\n1 . 2 N3E -\n*date 2000.01.02-2001\n";
  EXPECT_GT(read_damaged("svx", text), 5U);
}

TEST(SvxFaults, BinaryFilesAndHugeNumbersAreRejected) {
  expect_faults("svx", {{std::string("1 2 3\0 4", 8), 1, "the line contains a NUL byte"},
                        {"1 2 " + std::string(500, '9') + " 4 5", 1, "the number is too large"},
                        {"1 2 1000000001 4 5", 1, "the number is too large"}});
  Diagnostics warnings;
  const std::string tiny = "1 2 0." + std::string(400, '0') + "1 4 5";
  EXPECT_NO_THROW(format_of("x.svx").read(tiny, "x.svx", {}, warnings));
}

}  // namespace
}  // namespace vug::survey
