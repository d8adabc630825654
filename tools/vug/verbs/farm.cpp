// SPDX-License-Identifier: Apache-2.0
// `vug farm VERB ...`: each verb is a file in farm/.
#include "verb_group.h"

namespace vug::cli {

Verb farm_plan_verb();
Verb farm_run_verb();
Verb farm_status_verb();

Verb farm_verb() {
  return verb_group("farm", "Divides the pictures of a scene among processes and machines.",
                    {farm_plan_verb(), farm_run_verb(), farm_status_verb()});
}

}  // namespace vug::cli
