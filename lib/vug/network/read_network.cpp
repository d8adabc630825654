// SPDX-License-Identifier: Apache-2.0
#include <vug/network/dat.h>
#include <vug/network/from_survey.h>
#include <vug/network/read_network.h>
#include <vug/survey_files/read_survey.h>

namespace vug::network {

bool is_network_file(const std::filesystem::path& file) {
  return survey::find_format(file) != nullptr;
}

Network read_network(const std::filesystem::path& file, Diagnostics& warnings) {
  if (is_dat_name(file)) return read_dat(file);
  return from_survey(survey::read_survey(file, {}, warnings));
}

}  // namespace vug::network
