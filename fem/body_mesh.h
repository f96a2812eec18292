// Hexahedral meshes of the steel bodies (internal to this room: deal.II is seen here).
//
// Both bodies are a plane section of quadrilaterals swept along z. The head is one conforming mesh:
// its section is a disc of rings, one of which ends at the shaft's radius, so that the plate's
// layers use the whole section and the shaft's layers only the rings inside.
#pragma once

#include <deal.II/grid/tria.h>

#include "fem/body.h"
#include "fem/elastic_body.h"

namespace fem {

enum BoundaryPart : dealii::types::boundary_id {
  free_part,
  loaded_part,
  support_part,
  back_part,  // the outside of a mould, where gauges are glued
};

// Throws std::invalid_argument where the lengths do not describe the body.
void make_mesh(const Head& head, MeshSize size, dealii::Triangulation<3>& mesh);
void make_mesh(const Mould& mould, MeshSize size, dealii::Triangulation<3>& mesh);

}  // namespace fem
