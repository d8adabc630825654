// SPDX-License-Identifier: Apache-2.0
// https://www.gnu.org/software/parallel/man.html
#include <vug/farm/engine_files.h>

#include <fmt/format.h>

namespace vug::farm {

EngineFile parallel_file(const Job& job, const EngineOptions& options) {
  std::string text = fmt::format(
      "#!/bin/sh\n"
      "# Several machines with a shared folder, or one: list them in $HOSTS, e.g. "
      "HOSTS=node1,node2.\n"
      "# JOBS: processes at a time on each machine. Run it again after an interruption.\n"
      "cd \"$(dirname \"$0\")\" || exit 3\n"
      "run() {{\n"
      "  parallel --jobs \"${{JOBS:-1}}\" --retries 3 --halt soon,fail=3 --workdir \"$PWD\" \\\n"
      "    ${{HOSTS:+--sshlogin \"$HOSTS\"}} \"'{}' farm run . --threads {} --tasks {{}}\"\n"
      "}}\n"
      "chunks() {{  # FIRST LAST CHUNK\n"
      "  for first in $(seq \"$1\" \"$3\" \"$2\"); do\n"
      "    last=$((first + $3 - 1))\n"
      "    echo \"$first-$((last < $2 ? last : $2))\"\n"
      "  done\n"
      "}}\n",
      options.program, options.cores);
  for (const auto& level : chunked_levels(job, options.chunk)) {
    text += "{\n";
    for (const auto& [first, last, chunk] : level)
      text += fmt::format("  chunks {} {} {}\n", first, last, chunk);
    text += "} | run || exit\n";
  }
  return {"parallel.sh", std::move(text), true, "JOBS=2 ./parallel.sh"};
}

}  // namespace vug::farm
