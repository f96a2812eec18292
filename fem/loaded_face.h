// The loaded face of a body: integrals over it, and the place on it nearest to a point.
// Built from plain tables; quantities per face node are columns (3, face nodes).
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <functional>
#include <vector>

#include "fem/elements.h"

namespace fem {

class LoadedFace {
 public:
  explicit LoadedFace(const FaceTable& table);

  const std::vector<int>& nodes() const { return nodes_; }           // body nodes, ascending
  const Eigen::Matrix3Xd& places() const { return places_; }         // of these nodes [m]
  const Eigen::SparseMatrix<double>& mass() const { return mass_; }  // (face nodes)^2 [m2]
  double area() const;                                               // [m2]

  // Nodal forces [N] of a traction(x) [Pa].
  Eigen::Matrix3Xd load(
      const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& traction) const;

  // The part on this face of a vector over the body's unknowns, and a vector over the body's
  // unknowns that is zero off this face.
  Eigen::Matrix3Xd of_body(const Eigen::VectorXd& body) const;
  Eigen::VectorXd on_body(const Eigen::Matrix3Xd& face, Eigen::Index unknowns) const;

  // Weights (face nodes, points) with which face nodes interpolate at the places nearest to points.
  Eigen::SparseMatrix<double> interpolation(const Eigen::Matrix3Xd& points) const;

 private:
  struct Place {
    Eigen::Index quadrilateral;
    Eigen::Vector2d at;  // local coordinates in [0, 1]^2 [-]
    double distance;     // [m]
  };
  using Geometry = Eigen::Matrix<double, 3, 9>;

  Geometry geometry(Eigen::Index quadrilateral) const {
    return geometry_.middleCols<9>(9 * quadrilateral);
  }
  Place nearest_in(Eigen::Index quadrilateral, const Eigen::Vector3d& point) const;
  Place nearest(const Eigen::Vector3d& point) const;
  template <typename Visit>
  void for_each_gauss_point(Visit visit) const;

  int degree_;
  int per_quadrilateral_;  // nodes
  std::vector<int> nodes_;
  Eigen::Matrix3Xd places_;
  std::vector<int> face_node_;  // (per_quadrilateral_ each) index into nodes_
  Eigen::Matrix3Xd geometry_;   // (3, 9 each) [m]
  Eigen::Matrix3Xd centre_;     // (3, quadrilaterals) [m]
  Eigen::VectorXd reach_;       // radius about the centre that holds the quadrilateral [m]
  Eigen::SparseMatrix<double> mass_;
};

}  // namespace fem
