// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace vug {

uint64_t parse_bytes(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit(end);
  for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string units = "bkmgt";
  double scale = 1;
  bool fits = end != text.c_str() && std::isfinite(number) && number > 0;
  if (!unit.empty()) {
    const size_t power = units.find(unit[0]);
    fits = fits && power != std::string::npos &&
           (unit.size() == 1 || unit.substr(1) == "b" || unit.substr(1) == "ib");
    if (fits) scale = std::pow(1024.0, static_cast<double>(power));
  }
  if (!fits || number * scale > 1e18)
    throw Error(ErrorCode::bad_input, fmt::format("invalid amount of memory '{}'", text), {},
                "write e.g. 512M or 8G");
  return static_cast<uint64_t>(number * scale);
}

std::string bytes_text(double bytes) {
  constexpr const char* kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  int unit = 0;
  while (bytes >= 1024 && unit < 4) {
    bytes /= 1024;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, kUnits[unit]);
}

namespace {

/// The bytes in the line "KEY: NUMBER kB" of a file; `otherwise` if there is no such line.
uint64_t read_proc_bytes(const char* file, const char* wanted, uint64_t otherwise) {
  std::ifstream info(file);
  for (std::string line; std::getline(info, line);)
    if (line.rfind(wanted, 0) == 0)
      return std::strtoull(line.c_str() + std::strlen(wanted), nullptr, 10) * 1024;
  return otherwise;
}

}  // namespace

uint64_t available_memory() {
  return read_proc_bytes("/proc/meminfo", "MemAvailable:", uint64_t{8} << 30);
}

uint64_t resident_memory() { return read_proc_bytes("/proc/self/status", "VmRSS:", 0); }

void require_memory(double estimate, uint64_t limit, const std::string& what,
                    const std::string& remedy) {
  if (estimate <= static_cast<double>(limit)) return;
  throw Error(ErrorCode::too_large,
              fmt::format("{} would take about {} of memory, more than the limit of {}", what,
                          bytes_text(estimate), bytes_text(static_cast<double>(limit))),
              {}, remedy + ", or raise --max-memory");
}

}  // namespace vug
