// The analytic surfaces that walls are made of, each in its own frame (see frame.h): the distance
// of a point from the surface and the unit normal from the surface towards the point.
#pragma once

#include <variant>

#include "dem/contact.h"

namespace dem {

template <class T>
struct Nearest {
  T distance;      // [m], negative behind the surface
  Vec3<T> normal;  // [-]
};

// The plane z = 0, stones at z > 0.
struct Plane {
  template <class T>
  Nearest<T> nearest(const Vec3<T>& x) const {
    return {x.z, {T(0.0), T(0.0), T(1.0)}};
  }
  double extent() const { return 0; }
};

// The inside of an endless cylinder about z.
struct CylinderInside {
  double radius;  // [m]

  template <class T>
  Nearest<T> nearest(const Vec3<T>& x) const {
    const T square = x.x * x.x + x.y * x.y;
    const T inverse = reciprocal_root(larger(square, T(1e-300)));
    return {T(radius) - square * inverse, {-x.x * inverse, -x.y * inverse, T(0.0)}};
  }
  double extent() const { return radius; }
};

// A round plate: its face is the disc z = 0, stones lie at z < 0; beyond the rim the rim circle
// counts.
struct Disc {
  double radius;  // [m]

  template <class T>
  Nearest<T> nearest(const Vec3<T>& x) const {
    using std::sqrt;
    const T r = sqrt(x.x * x.x + x.y * x.y);
    const T beyond = r - T(radius);
    const auto outside = beyond > T(0.0);
    const T rim = larger(sqrt(beyond * beyond + x.z * x.z), T(1e-300));
    const T radial = select(outside, beyond / (rim * larger(r, T(1e-300))), T(0.0));
    return {select(outside, rim, -x.z),
            {x.x * radial, x.y * radial, select(outside, x.z / rim, T(-1.0))}};
  }
  double extent() const { return radius; }
};

// A solid block centred at the origin; a point inside is pushed out through the face z = -half.z.
struct Block {
  Vec3d half;  // half edge lengths [m]

  template <class T>
  Nearest<T> nearest(const Vec3<T>& x) const {
    using std::sqrt;
    const Vec3<T> off = {x.x - clamped(x.x, half.x), x.y - clamped(x.y, half.y),
                         x.z - clamped(x.z, half.z)};
    const T distance = sqrt(dot(off, off));
    const auto outside = distance > T(0.0);
    const T inverse = T(1.0) / larger(distance, T(1e-300));
    return {select(outside, distance, -T(half.z) - x.z),
            select(outside, off * inverse, Vec3<T>{T(0.0), T(0.0), T(-1.0)})};
  }
  double extent() const { return norm(half); }

 private:
  template <class T>
  static T clamped(T a, double limit) {
    return smaller(larger(a, T(-limit)), T(limit));
  }
};

using Surface = std::variant<Plane, CylinderInside, Disc, Block>;

}  // namespace dem
