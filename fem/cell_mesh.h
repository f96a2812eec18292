// The body as linear cells for pictures (internal to this room): a quadratic element becomes eight.
#pragma once

#include "fem/elastic_body.h"
#include "fem/elements.h"

namespace fem {

CellMesh make_cells(const Elements& elements);

}  // namespace fem
