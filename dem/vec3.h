// A vector of three numbers of type T: a double, or a pack of them.
#pragma once

#include <cmath>

namespace dem {

template <class T>
struct Vec3 {
  T x, y, z;

  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  Vec3& operator*=(T s) { return *this = *this * s; }

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(T s, const Vec3& a) { return {a.x * s, a.y * s, a.z * s}; }
  friend T dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend T norm(const Vec3& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
  }
};

using Vec3d = Vec3<double>;

}  // namespace dem
