#include <vug/base/error.h>
#include <vug/exchange/program.h>

#include <fmt/format.h>

namespace vug::exchange {

#define VUG_KIND(name) const Program& name##_program();
#include <vug/exchange/programs_kinds.inc>
#undef VUG_KIND

const std::vector<const Program*>& programs() {
  static const std::vector<const Program*> all = {
#define VUG_KIND(name) &name##_program(),
#include <vug/exchange/programs_kinds.inc>
#undef VUG_KIND
  };
  return all;
}

const Program& program(const std::string& name) {
  std::vector<std::string> known;
  for (const Program* each : programs()) {
    if (each->info.name == name) return *each;
    known.push_back(each->info.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("nothing is known of a program '{}'", name), {},
              suggestion(name, known));
}

}  // namespace vug::exchange
