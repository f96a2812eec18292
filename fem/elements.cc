#include "fem/elements.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>

#include "fem/body_mesh.h"

namespace fem {
namespace {

constexpr int geometry_degree = 2;

Eigen::Vector3d to_eigen(const dealii::Tensor<1, 3>& v) {
  return {v[0], v[1], v[2]};
}

// Local numbers, in a hexahedron of (degree + 1)^3 points, of the points of one of its faces.
// Faces as deal.II numbers them: 0, 1 at the ends of the first local coordinate, 2, 3 of the
// second.
std::vector<int> face_points(int degree, unsigned face) {
  const int side = degree + 1;
  const int stride[3] = {1, side, side * side};
  const unsigned normal = face / 2, first = (normal + 1) % 3, second = (normal + 2) % 3;
  const int offset = face % 2 == 1 ? degree * stride[normal] : 0;
  std::vector<int> points;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      points.push_back(offset + i * stride[first] + j * stride[second]);
  return points;
}

void append(Eigen::Matrix3Xd& columns, const Eigen::Matrix3Xd& more) {
  columns.conservativeResize(3, columns.cols() + more.cols());
  columns.rightCols(more.cols()) = more;
}

GaussPoints evaluate(const dealii::DoFHandler<3>& space, const dealii::Mapping<3>& mapping,
                     const std::vector<unsigned>& local, const dealii::Quadrature<3>& quadrature,
                     dealii::UpdateFlags gradients) {
  dealii::FEValues<3> shapes(mapping, space.get_fe(), quadrature,
                             dealii::update_values | dealii::update_JxW_values | gradients);
  const auto nodes = static_cast<Eigen::Index>(local.size());
  const auto points = static_cast<Eigen::Index>(quadrature.size());
  const Eigen::Index cells = space.get_triangulation().n_active_cells();

  GaussPoints gauss{static_cast<int>(points),
                    Eigen::MatrixXd(nodes, points),
                    Eigen::VectorXd(cells * points),
                    {}};
  if (gradients) gauss.gradient.resize(3, cells * points * nodes);
  Eigen::Index at = 0;
  for (const auto& cell : space.active_cell_iterators()) {
    shapes.reinit(cell);
    for (Eigen::Index q = 0; q < points; ++q, ++at) {
      gauss.weight[at] = shapes.JxW(q);
      for (Eigen::Index a = 0; a < nodes; ++a) {
        gauss.value(a, q) = shapes.shape_value(local[a], q);
        if (gradients)
          gauss.gradient.col(at * nodes + a) = to_eigen(shapes.shape_grad(local[a], q));
      }
    }
  }
  return gauss;
}

// Gauss points: of the stiffness along the second local coordinate, of the stress along the first.
struct Rule {
  int around, across;
};

Elements tabulate(const dealii::Triangulation<3>& mesh, int degree, Rule rule) {
  const dealii::FE_Q<3> shape(degree);
  const dealii::FE_Q<3> geometry(geometry_degree);
  const dealii::MappingQ<3> mapping(geometry_degree);
  dealii::DoFHandler<3> space(mesh);
  space.distribute_dofs(shape);
  const auto local = shape.get_poly_space_numbering_inverse();
  const auto geometry_local = geometry.get_poly_space_numbering_inverse();

  Elements elements;
  elements.degree = degree;
  elements.nodes.resize(3, space.n_dofs());
  elements.face.degree = elements.back.degree = degree;
  std::vector<dealii::types::global_dof_index> dofs(shape.dofs_per_cell);
  for (const auto& cell : space.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    const auto first = elements.node.size();
    for (const unsigned i : local) {
      elements.node.push_back(static_cast<int>(dofs[i]));
      elements.nodes.col(dofs[i]) =
          to_eigen(mapping.transform_unit_to_real_cell(cell, shape.get_unit_support_points()[i]));
    }
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      const auto part = cell->face(f)->boundary_id();
      if (part == free_part) continue;
      FaceTable& table = part == back_part ? elements.back : elements.face;
      auto& list = part == support_part ? elements.support_nodes : table.node;
      for (const int i : face_points(degree, f)) list.push_back(elements.node[first + i]);
      if (part == support_part) continue;
      const auto points = face_points(geometry_degree, f);
      Eigen::Matrix3Xd places(3, points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
        places.col(static_cast<Eigen::Index>(i)) = to_eigen(mapping.transform_unit_to_real_cell(
            cell, geometry.get_unit_support_points()[geometry_local[points[i]]]));
      append(table.geometry, places);
    }
  }

  auto& support = elements.support_nodes;
  std::sort(support.begin(), support.end());
  support.erase(std::unique(support.begin(), support.end()), support.end());

  const dealii::QGauss<1> full(degree + 1), reduced(degree);
  const auto at = [&](const dealii::Quadrature<3>& quadrature, dealii::UpdateFlags gradients) {
    return evaluate(space, mapping, local, quadrature, gradients);
  };
  elements.elastic = at(dealii::QAnisotropic<3>(full, dealii::QGauss<1>(rule.around), full),
                        dealii::update_gradients);
  elements.inertial = at(dealii::Quadrature<3>(full), dealii::update_default);
  elements.superconvergent =
      at(dealii::QAnisotropic<3>(dealii::QGauss<1>(rule.across), reduced, reduced),
         dealii::update_gradients);
  return elements;
}

}  // namespace

Elements make_elements(const Head& head, MeshSize size) {
  dealii::Triangulation<3> mesh;
  make_mesh(head, size, mesh);
  return tabulate(mesh, size.degree, {.around = size.degree + 1, .across = size.degree});
}

Elements make_elements(const Mould& mould, MeshSize size) {
  dealii::Triangulation<3> mesh;
  make_mesh(mould, size, mesh);
  return tabulate(mesh, size.degree, {.around = 2, .across = size.degree + 1});
}

}  // namespace fem
