// Linear, static, small-displacement elasticity of one steel body in its own frame:
// meshed once, assembled once, factorised once. No deal.II type leaves this room.
//
// Unknowns are nodal displacements (quadratic elements by default); vectors over the whole body
// have `unknowns()` entries, in the order of `nodes()`: (x, y, z) of node 0, of node 1, ... Calls
// on one body must not overlap in time: the factor keeps its workspace.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "fem/body.h"
#include "fem/reduced_body.h"

namespace fem {

struct MeshSize {
  int refinement = 0;  // each step halves the default elements: about 8 times the unknowns
  int degree = 2;      // polynomial degree of the displacement, 1 or 2 (1 locks in bending)
  std::vector<double> levels = {};  // heights at which elements of a mould must end, where its load
                                    // jumps [m]
  double at_centre = 0;  // size of a head's elements about the centre of its face, where a force
                         // stands on a point; 0: no smaller than elsewhere [m]
};

// A body as cells for pictures: 8-node hexahedra in VTK order over `points`.
struct CellMesh {
  Eigen::Matrix3Xd points;     // (3, points) [m], body frame
  std::vector<int> hexahedra;  // 8 per cell
  std::vector<int> node;       // (points) which node of the body each point is
};

// Stress at the cell-mesh points, Voigt order xx, yy, zz, yz, zx, xy [Pa], tension positive.
using StressField = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// How a head's loaded face moves as a whole: the plane u_z = axial + tilt_x y - tilt_y x fitted to
// the axial displacement by least squares over the face's area.
struct FaceMotion {
  double tilt_x, tilt_y;  // [rad]
  double axial;           // [m], of the disc's centre, which is the mean over the face
};

class ElasticBody {
 public:
  using Traction =
      std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;  // at a point [m] -> [Pa]

  // Throws std::invalid_argument where the lengths or the steel do not describe a body.
  ElasticBody(const Head& head, MeshSize mesh);
  ElasticBody(const Mould& mould, MeshSize mesh);
  ~ElasticBody();
  ElasticBody(ElasticBody&&) noexcept;
  ElasticBody& operator=(ElasticBody&&) noexcept;

  int unknowns() const;
  double mass() const;                    // [kg]
  const Eigen::Matrix3Xd& nodes() const;  // (3, unknowns / 3) [m]
  const CellMesh& cells() const;

  // Consistent nodal loads of a traction on the loaded face (unknowns) [N].
  Eigen::VectorXd face_load(const Traction& traction) const;
  // Nodal loads of a force [N] at the place of the loaded face nearest to `point` (unknowns) [N].
  Eigen::VectorXd point_load(const Eigen::Vector3d& point, const Eigen::Vector3d& force) const;

  // Static displacements [m] under nodal loads [N], one column per load case; supported unknowns
  // stay zero.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& loads) const;
  // What the supports answer: force [N] and moment about the origin [N m].
  Eigen::Matrix<double, 6, 1> reaction(const Eigen::VectorXd& displacement,
                                       const Eigen::VectorXd& load) const;

  // Displacement [m] at the places of the loaded face nearest to points (3, n) [m].
  Eigen::Matrix3Xd face_displacement(const Eigen::VectorXd& displacement,
                                     const Eigen::Matrix3Xd& points) const;
  // What has these values at nodes(), at the places of the loaded face nearest to points (3, n)
  // [m].
  Eigen::VectorXd face_values(const Eigen::VectorXd& of_nodes,
                              const Eigen::Matrix3Xd& points) const;
  // Weights (unknowns) [1/m] with which displacements make the strain of a gauge that is glued to
  // the outside of a mould between two places [m]: (u_b - u_a) . (b - a) / |b - a|^2.
  Eigen::VectorXd gauge(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  // Of a head's loaded face; a mould's, being no disc, has none.
  FaceMotion face_motion(const Eigen::VectorXd& displacement) const;

  // Displacements (x, y, z at point 0, at point 1, ...) of the loaded face at points (3, n) [m]
  // under unit forces at the same places [m/N], symmetric: one solution for each force.
  Eigen::MatrixXd face_compliance(const Eigen::Matrix3Xd& points) const;

  // The most compliant `modes` shapes of the loaded face (see reduced_body.h), sampled at `points`.
  // A number that parts a pair (cos, sin) keeps the one of them that moves the face's point on +x.
  ReducedBody reduce(int modes, const Eigen::Matrix3Xd& points) const;
  // The fewest modes that leave out no compliance above `tolerance` times the largest.
  ReducedBody reduce(double tolerance, const Eigen::Matrix3Xd& points) const;

  StressField stress(const Eigen::VectorXd& displacement) const;  // see stress_recovery.h

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fem
