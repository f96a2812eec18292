#include "dem/surface_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Position around the axis as a sector number with fraction, in [0, sectors).
double sector_of(const Vec3d& point, int sectors) {
  double turn = std::atan2(point.y, point.x) / two_pi;
  if (turn < 0) turn += 1;
  return std::min(turn * sectors, std::nextafter(sectors, 0.0));
}

}  // namespace

SurfaceField::SurfaceField(const DiscGrid& grid)
    : disc_(true), radius_(grid.radius), rings_(grid.rings), sectors_(grid.sectors) {
  node.push_back({0, 0, 0});
  area.push_back(0);
  for (int ring = 1; ring <= rings_; ++ring)
    for (int sector = 0; sector < sectors_; ++sector) {
      const double r = radius_ * ring / rings_;
      const double angle = two_pi * sector / sectors_;
      node.push_back({r * std::cos(angle), r * std::sin(angle), 0});
      area.push_back(0);
    }
  // A third of each triangle's area to each of its corners, scaled to the area of the full disc.
  const auto at = [this](int ring, int sector) {
    return ring == 0 ? 0 : 1 + (ring - 1) * sectors_ + sector % sectors_;
  };
  double sum = 0;
  for (int ring = 0; ring < rings_; ++ring)
    for (int sector = 0; sector < sectors_; ++sector) {
      for (int corner : {at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)})
        area[corner] += ring + 1;
      for (int corner : {at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)})
        area[corner] += ring;
      sum += 3 * (2 * ring + 1);
    }
  const double full = std::numbers::pi * radius_ * radius_;
  for (double& a : area) a *= full / sum;
  start();
}

SurfaceField::SurfaceField(const CylinderGrid& grid)
    : disc_(false),
      radius_(grid.radius),
      height_(grid.height),
      rings_(grid.rows),
      sectors_(grid.sectors) {
  const double cell = two_pi * radius_ / sectors_ * height_ / rings_;
  for (int row = 0; row <= rings_; ++row)
    for (int sector = 0; sector < sectors_; ++sector) {
      const double angle = two_pi * sector / sectors_;
      node.push_back(
          {radius_ * std::cos(angle), radius_ * std::sin(angle), height_ * row / rings_});
      area.push_back(row == 0 || row == rings_ ? cell / 2 : cell);
    }
  start();
}

void SurfaceField::start() {
  displacement.assign(size(), Vec3d{});
  velocity.assign(size(), Vec3d{});
  impulse.assign(size(), Vec3d{});
}

Stencil SurfaceField::stencil(const Vec3d& point) const {
  const double around = sector_of(point, sectors_);
  const int s0 = static_cast<int>(around), s1 = (s0 + 1) % sectors_;
  if (!disc_) {
    const double up = std::clamp(point.z / height_ * rings_, 0.0, static_cast<double>(rings_));
    const int row = std::min(static_cast<int>(up), rings_ - 1);
    const double u = around - s0, v = up - row;
    const int below = row * sectors_, above = below + sectors_;
    return {{below + s0, below + s1, above + s0, above + s1},
            {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
  }
  // In the oblique axes of the sector, point = p e0 + q e1 with p, q in rings: p + q is the
  // polygon.
  const Vec3d& e0 = node[1 + s0];
  const Vec3d& e1 = node[1 + s1];
  const double determinant = e0.x * e1.y - e0.y * e1.x;
  const double p = (point.x * e1.y - point.y * e1.x) / determinant;
  const double q = (e0.x * point.y - e0.y * point.x) / determinant;
  const int ring =
      std::clamp(static_cast<int>(p + q), 0, rings_ - 1);  // between polygons ring, ring+1
  const auto at = [this](int k, int s) { return k == 0 ? 0 : 1 + (k - 1) * sectors_ + s; };
  if (ring == 0) return {{0, at(1, s0), at(1, s1), 0}, {1 - p - q, p, q, 0}};
  // Corners (ring, 0), (ring+1, 0), (0, ring+1), (0, ring) in (p, q); split along (ring, 0)-(0,
  // ring+1).
  const double k = ring;
  const double w_far = (p + q * k / (k + 1) - k);  // 0 on the diagonal, 1 at (ring+1, 0)
  if (w_far >= 0) {
    const double w1 = q / (k + 1);
    return {{at(ring, s0), at(ring + 1, s0), at(ring + 1, s1), 0}, {1 - w_far - w1, w_far, w1, 0}};
  }
  const double w0 = p / k;             // of (ring, 0)
  const double w1 = q - k * (1 - w0);  // of (0, ring+1)
  return {{at(ring, s0), at(ring + 1, s1), at(ring, s1), 0}, {w0, w1, 1 - w0 - w1, 0}};
}

Vec3d SurfaceField::interpolate(const std::vector<Vec3d>& values, const Stencil& s) {
  Vec3d sum = {0, 0, 0};
  for (int k = 0; k < 4; ++k) sum += values[s.node[k]] * s.weight[k];
  return sum;
}

void SurfaceField::drift(double dt) {
  for (std::size_t n = 0; n < size(); ++n) displacement[n] += velocity[n] * dt;
}

void SurfaceField::add_impulse(const Stencil& s, const Vec3d& share) {
  for (int k = 0; k < 4; ++k) impulse[s.node[k]] += share * s.weight[k];
}

}  // namespace dem
