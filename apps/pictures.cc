#include "apps/pictures.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <numeric>
#include <span>
#include <string_view>

#include "apps/whole_file.h"

namespace apps {
namespace {

static_assert(std::endian::native == std::endian::little, "files are marked as little endian");

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const auto byte = [&](std::size_t j) -> std::uint32_t {
      return j < left ? static_cast<unsigned char>(bytes[i + j]) : 0;
    };
    const std::uint32_t word = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += digits[word >> 18];
    text += digits[word >> 12 & 63];
    text += left > 1 ? digits[word >> 6 & 63] : '=';
    text += left > 2 ? digits[word & 63] : '=';
  }
  return text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

constexpr const char* vtk_type(double) {
  return "Float64";
}
constexpr const char* vtk_type(std::int64_t) {
  return "Int64";
}
constexpr const char* vtk_type(std::uint8_t) {
  return "UInt8";
}

// VTK's inline binary data: the number of bytes, then the bytes, encoded as one.
template <class T>
std::string data_array(std::string_view attributes, std::span<const T> values) {
  const std::uint64_t size = values.size_bytes();
  std::string block(reinterpret_cast<const char*>(&size), sizeof size);
  block.append(reinterpret_cast<const char*>(values.data()), size);
  return fmt::format("<DataArray type=\"{}\" {} format=\"binary\">{}</DataArray>\n", vtk_type(T{}),
                     attributes, base64(block));
}

std::string index_array(const char* name, std::span<const std::int64_t> values) {
  return data_array(fmt::format("Name=\"{}\"", name), values);
}

std::string positions(const Eigen::Matrix3Xd& points) {
  const std::span<const double> values(points.data(), static_cast<std::size_t>(points.size()));
  return "<Points>\n" + data_array("Name=\"position [m]\" NumberOfComponents=\"3\"", values) +
         "</Points>\n";
}

std::string point_data(Eigen::Index points, const std::vector<Array>& arrays) {
  std::string out = "<PointData>\n";
  for (const Array& array : arrays) {
    assert(array.values.size() == static_cast<std::size_t>(points * array.components));
    std::string attributes =
        fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", escaped(array.name), array.components);
    for (std::size_t c = 0; c < array.labels.size(); ++c)
      attributes += fmt::format(" ComponentName{}=\"{}\"", c, escaped(array.labels[c]));
    out += data_array<double>(attributes, array.values);
  }
  return out + "</PointData>\n";
}

// The corners of cells one after the other, and where each cell ends.
struct Cells {
  std::vector<std::int64_t> corners, ends;

  std::string xml() const {
    return index_array("connectivity", corners) + index_array("offsets", ends);
  }
};

std::string document(const char* kind, std::string_view piece_size, std::string_view piece) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<{0}>\n<Piece {1}>\n{2}</Piece>\n</{0}>\n</VTKFile>\n",
      kind, piece_size, piece);
}

// Cells of a .vtp file are vertices ("Verts") or polygons ("Polys").
void write_poly_data(const std::string& path, const Eigen::Matrix3Xd& points, const char* kind,
                     const Cells& cells, const std::vector<Array>& arrays) {
  const std::string size = fmt::format("NumberOfPoints=\"{}\" NumberOf{}=\"{}\"", points.cols(),
                                       kind, cells.ends.size());
  const std::string piece = point_data(points.cols(), arrays) + positions(points) +
                            fmt::format("<{0}>\n{1}</{0}>\n", kind, cells.xml());
  write_whole_file(path, document("PolyData", size, piece));
}

Eigen::Vector3d on_circle(double radius, int side, int sides) {
  const double angle = 2 * std::numbers::pi * side / sides;
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

}  // namespace

void write_points(const std::string& vtp, const Eigen::Matrix3Xd& points,
                  const std::vector<Array>& arrays) {
  Cells vertices;
  vertices.corners.resize(static_cast<std::size_t>(points.cols()));
  vertices.ends.resize(vertices.corners.size());
  std::iota(vertices.corners.begin(), vertices.corners.end(), 0);
  std::iota(vertices.ends.begin(), vertices.ends.end(), 1);
  write_poly_data(vtp, points, "Verts", vertices, arrays);
}

void write_polygons(const std::string& vtp, const Surface& surface,
                    const std::vector<Array>& arrays) {
  Cells cells;
  for (const std::vector<int>& polygon : surface.polygons) {
    cells.corners.insert(cells.corners.end(), polygon.begin(), polygon.end());
    cells.ends.push_back(static_cast<std::int64_t>(cells.corners.size()));
  }
  write_poly_data(vtp, surface.points, "Polys", cells, arrays);
}

void write_hexahedra(const std::string& vtu, const Eigen::Matrix3Xd& points,
                     const std::vector<int>& hexahedra, const std::vector<Array>& arrays) {
  constexpr std::uint8_t vtk_hexahedron = 12;  // VTK file formats, cell types
  constexpr std::size_t corners = 8;
  assert(hexahedra.size() % corners == 0);
  Cells cells{{hexahedra.begin(), hexahedra.end()}, {}};
  for (std::size_t end = corners; end <= hexahedra.size(); end += corners)
    cells.ends.push_back(static_cast<std::int64_t>(end));
  const std::vector<std::uint8_t> types(cells.ends.size(), vtk_hexahedron);
  const std::string size =
      fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", points.cols(), cells.ends.size());
  const std::string piece = point_data(points.cols(), arrays) + positions(points) + "<Cells>\n" +
                            cells.xml() + data_array<std::uint8_t>("Name=\"types\"", types) +
                            "</Cells>\n";
  write_whole_file(vtu, document("UnstructuredGrid", size, piece));
}

Surface tube(double radius, double bottom, double top, int sides) {
  Surface surface{Eigen::Matrix3Xd(3, 2 * sides), {}};
  for (int i = 0; i < sides; ++i) {
    surface.points.col(2 * i) = on_circle(radius, i, sides) + bottom * Eigen::Vector3d::UnitZ();
    surface.points.col(2 * i + 1) = on_circle(radius, i, sides) + top * Eigen::Vector3d::UnitZ();
    const int next = (i + 1) % sides;
    surface.polygons.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  return surface;
}

Surface disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius,
             int sides) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
  Surface surface{Eigen::Matrix3Xd(3, sides), {std::vector<int>(static_cast<std::size_t>(sides))}};
  std::iota(surface.polygons[0].begin(), surface.polygons[0].end(), 0);
  for (int i = 0; i < sides; ++i)
    surface.points.col(i) = centre + turn * on_circle(radius, i, sides);
  return surface;
}

Surface box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  // Corner i lies high in x, y, z where bit 0, 1, 2 of i is set; polygons face outwards.
  Surface surface{
      Eigen::Matrix3Xd(3, 8),
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis)
      surface.points(axis, i) = (i >> axis & 1 ? high : low)[axis];
  return surface;
}

Series::Series(std::string pvd, double continued_at) : path_(std::move(pvd)) {
  std::ifstream earlier(path_);
  constexpr std::string_view start = "<DataSet timestep=\"";
  for (std::string line; std::getline(earlier, line);)
    if (line.starts_with(start) && std::stod(line.substr(start.size())) <= continued_at)
      entries_.push_back(line + "\n");
}

void Series::add(double time, const std::string& file) {
  entries_.push_back(
      fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escaped(file)));
  std::string content =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const std::string& entry : entries_) content += entry;
  write_whole_file(path_, content + "</Collection>\n</VTKFile>\n");
}

}  // namespace apps
