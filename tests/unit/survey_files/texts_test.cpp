// SPDX-License-Identifier: Apache-2.0
// Texts of all formats, read by Vug and by the programs that define the formats.
#include "faults.h"
#include "placed.h"
#include "programs.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>

#include <fmt/format.h>

namespace vug::survey {
namespace {

Observations read_observations(const std::filesystem::path& file) {
  Diagnostics warnings;
  return std::get<Observations>(format_of(file).read(read_text(file), file, {}, warnings));
}

/// The survey that cavern computes from a text.
Survey cavern(const ScratchFolder& folder, const std::filesystem::path& text) {
  run_in(folder.path(), fmt::format("cavern -q -q --output=a.3d '{}'", text.string()));
  return std::get<Survey>(read_bytes("3d", read_text(folder.file("a.3d"))));
}

TEST(Texts, CompassEqualsCavern) {
  VUG_REQUIRE_PROGRAM("cavern");
  const ScratchFolder folder("vug_texts");
  for (const char* extension : {".dat", ".mak"})
    for (const std::filesystem::path& text : survey_texts(extension)) {
      SCOPED_TRACE(text);
      expect_same(read_observations(text), cavern(folder, text));
    }
}

TEST(Texts, TherionEqualsTherion) {
  VUG_REQUIRE_PROGRAM("therion");
  for (const std::filesystem::path& text : survey_texts(".th")) {
    SCOPED_TRACE(text);
    const ScratchFolder folder("vug_texts");
    write_text(folder.file("thconfig"),
               fmt::format("source {}\nexport model -fmt survex -o a.3d\n", text.string()));
    run_in(folder.path(), "therion -q");
    expect_same(read_observations(text),
                std::get<Survey>(read_bytes("3d", read_text(folder.file("a.3d")))));
  }
}

TEST(Texts, PlotsOfTherionEqualItsCoordinates) {
  VUG_REQUIRE_PROGRAM("therion");
  for (const std::filesystem::path& text : survey_texts(".th")) {
    SCOPED_TRACE(text);
    const ScratchFolder folder("vug_texts");
    write_text(folder.file("thconfig"), fmt::format("source {}\nexport model -fmt survex -o a.3d\n"
                                                    "export model -fmt compass -o a.plt\n",
                                                    text.string()));
    run_in(folder.path(), "therion -q");
    const Survey plot = std::get<Survey>(read_bytes("plt", read_text(folder.file("a.plt"))));
    const Survey model = std::get<Survey>(read_bytes("3d", read_text(folder.file("a.3d"))));
    EXPECT_EQ(plot.legs.size(), model.legs.size());
    for (const Leg& leg : plot.legs) {
      bool found = false;
      const auto end = [](const Survey& survey, int station) {
        return survey.stations[static_cast<size_t>(station)].position;
      };
      for (const Leg& other : model.legs)
        found = found ||
                ((end(plot, leg.from) - end(model, other.from)).length() < 0.015 &&
                 (end(plot, leg.to) - end(model, other.to)).length() < 0.015) ||
                ((end(plot, leg.from) - end(model, other.to)).length() < 0.015 &&
                 (end(plot, leg.to) - end(model, other.from)).length() < 0.015);
      EXPECT_TRUE(found) << end(plot, leg.from) << " " << end(plot, leg.to);
    }
  }
}

}  // namespace
}  // namespace vug::survey
