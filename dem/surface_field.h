// The letterbox between stones and an elastic wall: a coarse grid on the wall's face, in its frame.
// Whoever bends the wall writes how its nodes move, the wall contacts write the impulse they
// receive, both through the same stencil weights: displacements are interpolated consistently,
// forces spread conservatively, each the transpose of the other.
#pragma once

#include <array>
#include <vector>

#include "dem/vec3.h"

namespace dem {

// Up to four nodes and their weights, which add up to one.
struct Stencil {
  std::array<int, 4> node;
  std::array<double, 4> weight;
};

// A disc z = 0 in triangles between homothetic polygons: linear functions are reproduced exactly,
// so that force and moment pass without loss.
struct DiscGrid {
  double radius;  // [m]
  int rings, sectors;
};

// The inside of a cylinder 0 <= z <= height, bilinear in angle and z: force passes without loss,
// the nodal moment differs by at most force x radius (1 - cos(pi / sectors)).
struct CylinderGrid {
  double radius, height;  // [m]
  int rows, sectors;      // cells along z and around
};

class SurfaceField {
 public:
  explicit SurfaceField(const DiscGrid& grid);
  explicit SurfaceField(const CylinderGrid& grid);

  std::size_t size() const { return node.size(); }
  Stencil stencil(const Vec3d& point) const;  // point on the undeformed face [m]

  Vec3d displacement_at(const Stencil& s) const { return interpolate(displacement, s); }
  Vec3d velocity_at(const Stencil& s) const { return interpolate(velocity, s); }
  void add_impulse(const Stencil& s, const Vec3d& share);
  void drift(double dt);  // displacement += velocity dt

  std::vector<Vec3d> node;   // [m]
  std::vector<double> area;  // of the face that belongs to each node [m2]

  // Written by the coupler, constant between two of its visits.
  std::vector<Vec3d> velocity;  // [m/s]
  double fastest = 0;           // largest speed of a node [m/s]

  // Written by the simulation, which moves every node with its velocity.
  std::vector<Vec3d> displacement;  // [m]

  // Written by the wall contacts, emptied by the coupler.
  std::vector<Vec3d> impulse;  // of the stones on the wall [N s]

 private:
  static Vec3d interpolate(const std::vector<Vec3d>& values, const Stencil& s);
  void start();  // zero fields on all nodes

  bool disc_;
  double radius_, height_ = 0;
  int rings_, sectors_;  // rings of a disc, rows of a cylinder
};

}  // namespace dem
