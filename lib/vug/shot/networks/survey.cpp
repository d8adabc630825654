// SPDX-License-Identifier: Apache-2.0
// A network from the survey of a real cave.
#include <vug/network/from_survey.h>
#include <vug/shot/networks.h>
#include <vug/shot/networks/origin_parameters.h>
#include <vug/survey_files/read_survey.h>

namespace vug::shot {
namespace {

struct SurveyFile : network::FromSurveyOptions, network::OriginOptions {
  std::filesystem::path file;

  static void describe(Schema<SurveyFile>& s) {
    s.doc(
         "The network of a cave survey: a file of Survex, Therion, Compass, PocketTopo or Walls. "
         "North is -z. Measured distances to the walls become sections of passages.")
        .param("file", &SurveyFile::file, {.doc = "the survey", .required = true})
        .param("surface", &SurveyFile::surface, {.doc = "keep legs over the surface"})
        .param("duplicates", &SurveyFile::duplicates, {.doc = "keep legs that repeat a passage"});
    describe_origin(s);
  }
};

struct ReadSurvey {
  NetworkPtr network;
  Diagnostics warnings;
};

ReadSurvey read(const SurveyFile& p) {
  ReadSurvey out;
  network::FromSurveyOptions options = p;
  options.place = p;
  out.network = std::make_shared<const network::Network>(
      network::from_survey(survey::read_survey(p.file, {}, out.warnings), options));
  return out;
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(survey) {
  Kind<ReadSurvey> reader = make_kind<ReadSurvey, SurveyFile>("survey", "network", read);
  KindInfo info = reader.info;
  return {std::move(info),
          [reader = std::move(reader)](const Arguments& arguments, const SourceLocation& where,
                                       Diagnostics& diagnostics) -> std::optional<NetworkPtr> {
            const std::optional<ReadSurvey> made = reader.make(arguments, where, diagnostics);
            if (!made) return std::nullopt;
            diagnostics.append(made->warnings);
            return made->network;
          }};
}
