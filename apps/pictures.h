// Pictures of a run for ParaView (VTK XML, binary, uncompressed): stones as points, steel as
// hexahedra, walls as polygons, and the series that puts them in time.
// Every file is written whole; a failure throws OutputError.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <string>
#include <vector>

namespace apps {

// A quantity at the points of a picture.
struct Array {
  std::string name;                      // with its unit, e.g. "diameter [m]"
  int components = 1;                    // per point
  std::vector<double> values;            // all components of point 0, of point 1, ...
  std::vector<std::string> labels = {};  // of the components; empty: ParaView's own (x, y, z)
};

// A surface of flat polygons; each lists its corners in order.
struct Surface {
  Eigen::Matrix3Xd points;  // (3, points) [m]
  std::vector<std::vector<int>> polygons;
};

// `points` are (3, points) [m]; in ParaView show stones with the glyph filter, scaled by an array.
void write_points(const std::string& vtp, const Eigen::Matrix3Xd& points,
                  const std::vector<Array>& arrays);
// `hexahedra` lists 8 corners per cell in VTK order.
void write_hexahedra(const std::string& vtu, const Eigen::Matrix3Xd& points,
                     const std::vector<int>& hexahedra, const std::vector<Array>& arrays);
void write_polygons(const std::string& vtp, const Surface& surface,
                    const std::vector<Array>& arrays);

// The walls of a rigid machine. `sides` is the number of edges that stand for a circle.
Surface tube(double radius, double bottom, double top, int sides);  // [m], around the z axis
Surface disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius,
             int sides);                                               // [m]
Surface box(const Eigen::Vector3d& low, const Eigen::Vector3d& high);  // [m]

// A .pvd file: which picture shows which time. It is valid after every addition.
class Series {
 public:
  // Of a file that exists already, pictures up to `continued_at` [s] stay in the series.
  explicit Series(std::string pvd, double continued_at = -std::numeric_limits<double>::infinity());
  void add(double time, const std::string& file);  // [s]; as seen from the folder of the series

 private:
  std::string path_;
  std::vector<std::string> entries_;
};

}  // namespace apps
