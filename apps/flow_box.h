// Whether box, strip and stones of a flow test fit each other.
#pragma once

#include "apps/mix.h"
#include "apps/scene.h"

namespace apps {

// Throws InputError with every mistake.
void check_box(const FlowTestScene& scene, const Mix& mix);

}  // namespace apps
