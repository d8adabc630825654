// SPDX-License-Identifier: Apache-2.0
// Ends the program with an error if the processor lacks an instruction set that the build requires.
// The check runs before static objects are constructed, because their code may use those
// instructions. This source is compiled for plain x86-64.
#include <unistd.h>
#include <vug/base/cpu_support.h>

namespace {

void print(const char* text) {
  int length = 0;
  while (text[length] != '\0') ++length;
  (void)!write(STDERR_FILENO, text, static_cast<unsigned int>(length));
}

__attribute__((constructor(101))) void require_cpu_features() {
  const char* const missing = vug::missing_cpu_features();
  if (*missing == '\0') return;
  print("error: this processor lacks ");
  print(missing);
  print(", but this build of vug requires x86-64-v3 (processors of 2013 or later)\n");
  _exit(3);  // cli::kFailed
}

}  // namespace
