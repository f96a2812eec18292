// The finite elements of a body as plain tables: what deal.II knows about mesh, mapping and shape
// functions, written down once so that nothing else in this room has to ask again.
//
// Displacements are Lagrange polynomials of degree 1 or 2 on hexahedra whose geometry is quadratic,
// so that the round surfaces are round: an arc of 15 degrees is met to 7e-6 of its radius, one of
// 30 degrees to 1.1e-4. A mould's stiffness is integrated with two Gauss points around the circle
// and degree + 1 along the other sides: with three around, a quadratic element that is curved
// cannot bend without stretching and a 7.5 mm wall of 24 elements goes oval 5 % too little
// (membrane locking; Stolarski & Belytschko 1982). Two points keep the rank, since no quadratic has
// zero slope at both, and integrate constant stresses exactly, since every term of (shape gradient
// x volume) is cubic around the circle. Inside an element, and inside a face, nodes are numbered
// with the first local coordinate fastest.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/body.h"
#include "fem/elastic_body.h"

namespace fem {

// Shape functions at the Gauss points of every element.
struct GaussPoints {
  int per_element;
  Eigen::MatrixXd value;      // (nodes per element, per_element) [-], the same in every element
  Eigen::VectorXd weight;     // (elements * per_element) volume of each Gauss point [m3]
  Eigen::Matrix3Xd gradient;  // one column per (element, Gauss point, node of the element) [1/m]

  auto gradient_at(int element, int point) const {
    const auto nodes = value.rows();
    return gradient.middleCols((static_cast<Eigen::Index>(element) * per_element + point) * nodes,
                               nodes);
  }
};

// A face of the body as quadrilaterals.
struct FaceTable {
  int degree;
  std::vector<int> node;      // ((degree + 1)^2 per quadrilateral) body nodes
  Eigen::Matrix3Xd geometry;  // (3, 9 per quadrilateral) [m] points of the quadratic geometry
};

struct Elements {
  int degree;
  Eigen::Matrix3Xd nodes;          // (3, nodes) [m]
  std::vector<int> node;           // ((degree + 1)^3 per element)
  GaussPoints elastic;             // integrate the stiffness
  GaussPoints inertial;            // integrate the mass: degree + 1 points a side, no gradients
  GaussPoints superconvergent;     // where stresses are best: degree points a side, but degree + 1
                                   // across a mould's wall
  std::vector<int> support_nodes;  // ascending
  FaceTable face;                  // loaded
  FaceTable back;                  // of a mould, its outside

  int nodes_per_element() const { return (degree + 1) * (degree + 1) * (degree + 1); }
  int count() const { return static_cast<int>(node.size()) / nodes_per_element(); }
};

Elements make_elements(const Head& head, MeshSize size);
Elements make_elements(const Mould& mould, MeshSize size);

}  // namespace fem
