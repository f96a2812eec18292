#include "fem/cell_mesh.h"

#include <numeric>

namespace fem {

CellMesh make_cells(const Elements& elements) {
  // Corners in VTK order: around the lower face, then around the upper one.
  constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const int degree = elements.degree, side = degree + 1;
  CellMesh cells;
  cells.points = elements.nodes;
  cells.node.resize(elements.nodes.cols());
  std::iota(cells.node.begin(), cells.node.end(), 0);
  for (int e = 0; e < elements.count(); ++e) {
    const int* node = &elements.node[static_cast<std::size_t>(e) * elements.nodes_per_element()];
    for (int k = 0; k < degree; ++k)
      for (int j = 0; j < degree; ++j)
        for (int i = 0; i < degree; ++i)
          for (const auto& c : corner)
            cells.hexahedra.push_back(node[i + c[0] + side * (j + c[1] + side * (k + c[2]))]);
  }
  return cells;
}

}  // namespace fem
