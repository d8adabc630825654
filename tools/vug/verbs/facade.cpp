// SPDX-License-Identifier: Apache-2.0
// `vug facade VERB ...`: each verb is a file in facade/ and a line in CMakeLists.txt.
#include "verb_group.h"

namespace vug::cli {

#define VUG_FACADE_VERB(name) Verb facade_##name##_verb();
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB

Verb facade_verb() {
  return verb_group("facade", "Reconstructs and models facades from pictures and scans.",
                    {
#define VUG_FACADE_VERB(name) facade_##name##_verb(),
#include <facade_verbs.inc>
#undef VUG_FACADE_VERB
                    });
}

}  // namespace vug::cli
