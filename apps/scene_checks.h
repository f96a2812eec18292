// The checks between the parameters of a scene, and what follows from them: the sieve table that a
// scene names, the row of the binder table that a temperature stands for.
#pragma once

#include "apps/document.h"
#include "apps/scene.h"

namespace apps {

void check(GyratoryScene& scene, const Document& document, Mistakes& mistakes);
void check(FlowTestScene& scene, const Document& document, Mistakes& mistakes);

}  // namespace apps
