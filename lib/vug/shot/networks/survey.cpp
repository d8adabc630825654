// SPDX-License-Identifier: Apache-2.0
// A network from the survey of a real cave.
#include <vug/network/from_survey.h>
#include <vug/shot/networks.h>
#include <vug/survey_files/read_survey.h>

namespace vug::shot {
namespace {

struct SurveyFile : network::FromSurveyOptions {
  std::filesystem::path file;

  static void describe(Schema<SurveyFile>& s) {
    s.doc(
         "The network of a cave survey: a file of Survex, Therion, Compass, PocketTopo or Walls. "
         "North is -z. Measured distances to the walls become sections of passages.")
        .param("file", &SurveyFile::file, {.doc = "the survey", .required = true})
        .param("surface", &SurveyFile::surface, {.doc = "keep legs over the surface"})
        .param("duplicates", &SurveyFile::duplicates, {.doc = "keep legs that repeat a passage"})
        .param("recenter", &SurveyFile::recenter,
               {.doc = "put the middle of the survey, rounded to metres, into the origin"});
  }
};

NetworkPtr read(const SurveyFile& p) {
  Diagnostics warnings;  // `vug survey` prints them.
  return std::make_shared<const network::Network>(
      network::from_survey(survey::read_survey(p.file, {}, warnings), p));
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(survey) { return make_kind<NetworkPtr, SurveyFile>("survey", "network", read); }
