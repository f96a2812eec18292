// Isotropic linear elasticity in Voigt order xx, yy, zz, yz, zx, xy; shear strains are engineering
// strains (gamma). Timoshenko & Goodier (1970), section 6.
#pragma once

#include <Eigen/Dense>

#include "fem/body.h"

namespace fem {

using ElasticityMatrix = Eigen::Matrix<double, 6, 6>;             // [Pa]
using StrainOperator = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // [1/m]

inline ElasticityMatrix elasticity_matrix(const Steel& steel) {
  const double shear = steel.young / (2 * (1 + steel.poisson));             // [Pa]
  const double lame = 2 * shear * steel.poisson / (1 - 2 * steel.poisson);  // [Pa]
  ElasticityMatrix matrix = ElasticityMatrix::Zero();
  matrix.topLeftCorner<3, 3>().setConstant(lame);
  matrix.diagonal() << lame + 2 * shear, lame + 2 * shear, lame + 2 * shear, shear, shear, shear;
  return matrix;
}

// Strains from nodal displacements (x, y, z of node 0, of node 1, ...); `gradient` (3, nodes)
// [1/m].
template <typename Gradient>
StrainOperator strain_operator(const Gradient& gradient) {
  StrainOperator strain = StrainOperator::Zero(6, 3 * gradient.cols());
  for (Eigen::Index a = 0; a < gradient.cols(); ++a) {
    const double dx = gradient(0, a), dy = gradient(1, a), dz = gradient(2, a);
    strain.middleCols<3>(3 * a) << dx, 0, 0,  //
        0, dy, 0,                             //
        0, 0, dz,                             //
        0, dz, dy,                            //
        dz, 0, dx,                            //
        dy, dx, 0;
  }
  return strain;
}

}  // namespace fem
