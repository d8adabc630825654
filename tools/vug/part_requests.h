// SPDX-License-Identifier: Apache-2.0
// Requests for parts of a picture, which `vug farm run` sends to a `vug render` that stays open.
#pragma once

#include <string>

namespace vug::cli {

/// A part to render: a line of JSON on the standard input. The answer is a line with its exit code.
struct PartRequest {
  std::string part;        ///< File of the partial render.
  std::string samples;     ///< "A..B", see --samples.
  std::string checkpoint;  ///< Continued if it exists; empty: none.
  std::string log;         ///< File for the messages from now on; empty: as before.
};

std::string to_line(const PartRequest& request);
/// Error(bad_input) for other texts.
PartRequest part_request(const std::string& line);

std::string answer_line(int exit);
/// Error(io) for other texts.
int exit_of_answer(const std::string& line);

}  // namespace vug::cli
