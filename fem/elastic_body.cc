#include "fem/elastic_body.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Sparse>
#include <algorithm>
#include <stdexcept>

#include "fem/assembly.h"
#include "fem/cell_mesh.h"
#include "fem/elements.h"
#include "fem/loaded_face.h"
#include "fem/modal_reduction.h"
#include "fem/stress_recovery.h"

namespace fem {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;  // symmetric ones hold their lower triangle

namespace {

std::vector<int> all_unknowns_of_support(const Elements& elements) {
  std::vector<int> supported;
  for (const int node : elements.support_nodes)
    for (int direction = 0; direction < 3; ++direction) supported.push_back(3 * node + direction);
  return supported;
}

std::vector<int> supported_unknowns(const Head&, const Elements& elements) {
  return all_unknowns_of_support(elements);
}

// A guided ring slides on its base; three more unknowns, on the inner edge's points on +x, -x and
// +y, take its rigid motions and nothing else: they see no force if the load is in balance.
std::vector<int> supported_unknowns(const Mould& mould, const Elements& elements) {
  if (mould.base == BaseSupport::clamped) return all_unknowns_of_support(elements);
  const auto base_node = [&](double x, double y) {
    const Eigen::Vector3d place = Eigen::Vector3d(x, y, 0) * (mould.inner_diameter / 2);
    return *std::min_element(
        elements.support_nodes.begin(), elements.support_nodes.end(), [&](int a, int b) {
          return (elements.nodes.col(a) - place).norm() < (elements.nodes.col(b) - place).norm();
        });
  };
  std::vector<int> supported = {3 * base_node(1, 0) + 1, 3 * base_node(-1, 0) + 1,
                                3 * base_node(0, 1)};
  for (const int node : elements.support_nodes) supported.push_back(3 * node + 2);
  return supported;
}

// The rows and columns of a symmetric matrix that `number` maps to 0, 1, ... (-1: left out).
Sparse restrict(const Sparse& matrix, const std::vector<int>& number, Index size) {
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(matrix.nonZeros());
  for (Index column = 0; column < matrix.outerSize(); ++column)
    for (Sparse::InnerIterator entry(matrix, column); entry; ++entry)
      if (number[entry.row()] >= 0 && number[column] >= 0)
        triplets.emplace_back(number[entry.row()], number[column], entry.value());
  Sparse restricted(size, size);
  restricted.setFromTriplets(triplets.begin(), triplets.end());
  return restricted;
}

}  // namespace

struct ElasticBody::Implementation {
  Elements elements;
  Steel steel;
  LoadedFace face;
  CellMesh cells;
  Sparse stiffness;       // of the unsupported body [N/m]
  std::vector<int> free;  // unknowns that may move, ascending
  Eigen::CholmodSupernodalLLT<Sparse, Eigen::Lower> factor;

  template <typename Body>
  Implementation(const Body& body, MeshSize mesh)
      : elements(make_elements(body, mesh)),
        steel(body.steel),
        face(elements.face),
        cells(make_cells(elements)),
        stiffness(assemble_stiffness(elements, steel)) {
    std::vector<int> number(stiffness.rows(), 0);
    for (const int unknown : supported_unknowns(body, elements)) number[unknown] = -1;
    for (int unknown = 0; unknown < static_cast<int>(number.size()); ++unknown)
      if (number[unknown] == 0) {
        number[unknown] = static_cast<int>(free.size());
        free.push_back(unknown);
      }
    factor.compute(restrict(stiffness, number, static_cast<Index>(free.size())));
    if (factor.info() != Eigen::Success)
      throw std::runtime_error("the steel's stiffness could not be factorised");
  }

  MatrixXd solve(const MatrixXd& loads) const {
    const MatrixXd free_loads = loads(free, Eigen::all);
    MatrixXd displacement = MatrixXd::Zero(loads.rows(), loads.cols());
    displacement(free, Eigen::all) = MatrixXd(factor.solve(free_loads));
    return displacement;
  }

  ReducedBody reduce(Truncation truncation, const Matrix3Xd& points) const {
    return modal_reduction(
        face, assemble_mass(elements, steel),
        [this](const MatrixXd& loads) { return solve(loads); }, truncation, points);
  }

  double mass() const { return steel.density * elements.inertial.weight.sum(); }
};

ElasticBody::ElasticBody(const Head& head, MeshSize mesh)
    : implementation_(std::make_unique<Implementation>(head, mesh)) {}
ElasticBody::ElasticBody(const Mould& mould, MeshSize mesh)
    : implementation_(std::make_unique<Implementation>(mould, mesh)) {}
ElasticBody::~ElasticBody() = default;
ElasticBody::ElasticBody(ElasticBody&&) noexcept = default;
ElasticBody& ElasticBody::operator=(ElasticBody&&) noexcept = default;

int ElasticBody::unknowns() const {
  return static_cast<int>(implementation_->stiffness.rows());
}
double ElasticBody::mass() const {
  return implementation_->mass();
}
const Matrix3Xd& ElasticBody::nodes() const {
  return implementation_->elements.nodes;
}
const CellMesh& ElasticBody::cells() const {
  return implementation_->cells;
}

VectorXd ElasticBody::face_load(const Traction& traction) const {
  const auto& face = implementation_->face;
  return face.on_body(face.load(traction), unknowns());
}

VectorXd ElasticBody::point_load(const Eigen::Vector3d& point, const Eigen::Vector3d& force) const {
  const auto& face = implementation_->face;
  const VectorXd weight = face.interpolation(point);
  return face.on_body(force * weight.transpose(), unknowns());
}

MatrixXd ElasticBody::solve(const MatrixXd& loads) const {
  return implementation_->solve(loads);
}

Eigen::Matrix<double, 6, 1> ElasticBody::reaction(const VectorXd& displacement,
                                                  const VectorXd& load) const {
  const auto& body = *implementation_;
  const VectorXd held = body.stiffness.selfadjointView<Eigen::Lower>() * displacement - load;
  Eigen::Matrix<double, 6, 1> reaction = Eigen::Matrix<double, 6, 1>::Zero();
  for (const int node : body.elements.support_nodes) {
    const Eigen::Vector3d force = held.segment<3>(3 * node);
    reaction.head<3>() += force;
    reaction.tail<3>() += body.elements.nodes.col(node).cross(force);
  }
  return reaction;
}

Matrix3Xd ElasticBody::face_displacement(const VectorXd& displacement,
                                         const Matrix3Xd& points) const {
  return implementation_->face.of_body(displacement) * implementation_->face.interpolation(points);
}

VectorXd ElasticBody::face_values(const VectorXd& of_nodes, const Matrix3Xd& points) const {
  const auto& face = implementation_->face;
  return face.interpolation(points).transpose() * of_nodes(face.nodes());
}

VectorXd ElasticBody::gauge(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  const auto& body = *implementation_;
  if (body.elements.back.node.empty())
    throw std::invalid_argument("gauge: only a mould has an outside to glue it to");
  const LoadedFace back(body.elements.back);
  Matrix3Xd places(3, 2);
  places << a, b;
  const Eigen::SparseMatrix<double> weights = back.interpolation(places);
  const Eigen::Vector3d along = (b - a) / (b - a).squaredNorm();
  return back.on_body(along * VectorXd(weights.col(1) - weights.col(0)).transpose(), unknowns());
}

FaceMotion ElasticBody::face_motion(const VectorXd& displacement) const {
  const auto& body = *implementation_;
  const Matrix3Xd& places = body.face.places();
  MatrixXd plane(places.cols(), 3);  // u_z = plane * (axial, tilt_x, tilt_y)
  plane << VectorXd::Ones(places.cols()), places.row(1).transpose(), -places.row(0).transpose();
  const MatrixXd weighted = plane.transpose() * body.face.mass();
  const Eigen::Vector3d fit =
      (weighted * plane)
          .ldlt()
          .solve(weighted * body.face.of_body(displacement).row(2).transpose());
  return {fit[1], fit[2], fit[0]};
}

MatrixXd ElasticBody::face_compliance(const Matrix3Xd& points) const {
  constexpr Index at_once = 48;  // solutions, which share the reading of the factor
  const auto& face = implementation_->face;
  const Eigen::SparseMatrix<double> weights = face.interpolation(points);
  const Index forces = 3 * points.cols();
  MatrixXd compliance(forces, forces);
  for (Index first = 0; first < forces; first += at_once) {
    MatrixXd loads(unknowns(), std::min(at_once, forces - first));
    for (Index k = 0; k < loads.cols(); ++k) {
      const VectorXd shares = weights.col((first + k) / 3);
      loads.col(k) =
          face.on_body(Eigen::Vector3d::Unit((first + k) % 3) * shares.transpose(), unknowns());
    }
    const MatrixXd answer = solve(loads);
    for (Index k = 0; k < loads.cols(); ++k)
      compliance.col(first + k) = (face.of_body(answer.col(k)) * weights).reshaped();
  }
  return (compliance + compliance.transpose()) / 2;
}

ReducedBody ElasticBody::reduce(int modes, const Matrix3Xd& points) const {
  return implementation_->reduce({modes, 0}, points);
}

ReducedBody ElasticBody::reduce(double tolerance, const Matrix3Xd& points) const {
  if (!(tolerance > 0 && tolerance < 1))
    throw std::invalid_argument("reduce: tolerance must be in (0, 1)");
  const Index unknowns = 3 * static_cast<Index>(implementation_->face.nodes().size());
  return implementation_->reduce({unknowns - 1, tolerance}, points);
}

StressField ElasticBody::stress(const VectorXd& displacement) const {
  return recover_stress(implementation_->elements, implementation_->steel, displacement);
}

}  // namespace fem
