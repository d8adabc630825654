// SPDX-License-Identifier: Apache-2.0
#include "bench_studio.h"

namespace vug::studio {

bool BenchStudio::run(const std::string& line) {
  try {
    execute(line);
    return true;
  } catch (const Error& error) {
    show(error);
    return false;
  }
}

void BenchStudio::show(const Error& error) {
  QString text = text_of(error.what());
  if (!error.hint().empty()) text += " (" + text_of(error.hint()) + ")";
  Q_EMIT message(text, true);
  Q_EMIT changed();
}

}  // namespace vug::studio
