// Between records, one stone or contact after the other, and packs, one number of eight of them.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/pack.h"
#include "dem/particle_store.h"
#include "dem/vec3.h"

namespace dem {

#if defined(__AVX512F__)
// Lanes 0 to 2 and 4 to 6 of a register: a vector each, in the other two what lies behind it.
using TwoVectors = __m512d;

// Of vectors 0 and 4, 1 and 5, 2 and 6, 3 and 7.
inline Vec3<Pack> lined_up(TwoVectors a, TwoVectors b, TwoVectors c, TwoVectors d) {
  const __m512d xz_ab = _mm512_unpacklo_pd(a, b), xz_cd = _mm512_unpacklo_pd(c, d);
  const __m512d y_ab = _mm512_unpackhi_pd(a, b), y_cd = _mm512_unpackhi_pd(c, d);
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {Pack((Pack::Lanes)_mm512_permutex2var_pd(xz_ab, first, xz_cd)),
          Pack((Pack::Lanes)_mm512_permutex2var_pd(y_ab, first, y_cd)),
          Pack((Pack::Lanes)_mm512_permutex2var_pd(xz_ab, second, xz_cd))};
}

inline TwoVectors two_vectors(const double* low, const double* high) {
  const __m512d one = _mm512_castpd256_pd512(_mm256_loadu_pd(low));
  return _mm512_insertf64x4(one, _mm256_loadu_pd(high), 1);
}
#endif

// Lane k takes vectors[index[k]].
template <class T>
Vec3<T> gather(const Vectors& vectors, const std::int32_t* index) {
#if defined(__AVX512F__)
  if constexpr (width<T> == lanes) {
    const auto two = [&](int k) {
      return two_vectors(&vectors[index[k]].x, &vectors[index[k + 4]].x);
    };
    return lined_up(two(0), two(1), two(2), two(3));
  }
#endif
  const double* base = &vectors.front().x;
  return {gather<T>(base, index, 3), gather<T>(base + 1, index, 3), gather<T>(base + 2, index, 3)};
}

// Lane k takes vectors[i[k]] - vectors[j[k]].
template <class T>
Vec3<T> gather_difference(const Vectors& vectors, const std::int32_t* i, const std::int32_t* j) {
#if defined(__AVX512F__)
  if constexpr (width<T> == lanes) {
    const auto two = [&](int k) {
      return two_vectors(&vectors[i[k]].x, &vectors[i[k + 4]].x) -
             two_vectors(&vectors[j[k]].x, &vectors[j[k + 4]].x);
    };
    return lined_up(two(0), two(1), two(2), two(3));
  }
#endif
  return gather<T>(vectors, i) - gather<T>(vectors, j);
}

// Four numbers of one stone or contact: half of a load.
using Quad [[gnu::vector_size(4 * sizeof(double))]] = double;

// Where quads() puts that of lane k.
constexpr int quad_place(int k) {
  return 2 * (k % 4) + k / 4;
}

// Quads of x, y, z and `fourth`, one for each lane, at the places above.
inline void quads(const Vec3<Pack>& v, Pack fourth, Quad* to) {
#if defined(__AVX512F__)
  const __m512d x = (__m512d)v.x.value, y = (__m512d)v.y.value, z = (__m512d)v.z.value;
  const __m512d w = (__m512d)fourth.value;
  const __m512d xy_even = _mm512_unpacklo_pd(x, y), zw_even = _mm512_unpacklo_pd(z, w);
  const __m512d xy_odd = _mm512_unpackhi_pd(x, y), zw_odd = _mm512_unpackhi_pd(z, w);
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  double* const at = reinterpret_cast<double*>(to);
  _mm512_store_pd(at, _mm512_permutex2var_pd(xy_even, first, zw_even));
  _mm512_store_pd(at + 8, _mm512_permutex2var_pd(xy_odd, first, zw_odd));
  _mm512_store_pd(at + 16, _mm512_permutex2var_pd(xy_even, second, zw_even));
  _mm512_store_pd(at + 24, _mm512_permutex2var_pd(xy_odd, second, zw_odd));
#else
  for (int k = 0; k < lanes; ++k) to[quad_place(k)] = Quad{v.x[k], v.y[k], v.z[k], fourth[k]};
#endif
}

inline void quads(const Vec3d& v, double fourth, Quad* to) {
  *to = Quad{v.x, v.y, v.z, fourth};
}

#ifdef WATCH_RACES  // a checker of races sees accesses to numbers, not to four of them at once
inline Quad load_quad(const double* from) {
  return Quad{from[0], from[1], from[2], from[3]};
}
inline void store_quad(Quad a, double* to) {
  for (int k = 0; k < 4; ++k) to[k] = a[k];
}
inline Quad load_vector(const Vec3d& from) {
  return Quad{from.x, from.y, from.z, 0};
}
#else
inline Quad load_quad(const double* from) {
  Quad read;
  __builtin_memcpy(&read, from, sizeof read);
  return read;
}
inline void store_quad(Quad a, double* to) {
  __builtin_memcpy(to, &a, sizeof a);
}
// A vector and what lies behind it, which nobody takes: another thread may be writing it.
inline Quad load_vector(const Vec3d& from) {
  return load_quad(&from.x);
}
#endif

// Only the vector.
inline void store_vector(Quad a, Vec3d& to) {
  to = {a[0], a[1], a[2]};
}

// A torque and the moment of a force at an arm together, or with `breaks`, of the crush behind
// them, the larger one.
template <bool breaks>
Quad joined(Quad torque, Quad moment, double arm = 1) {
  Quad sum = torque + moment * arm;
  if constexpr (breaks) sum[3] = larger(torque[3], moment[3]);
  return sum;
}

}  // namespace dem
