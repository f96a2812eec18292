// Eight doubles that are worked on at once, so that a contact law written over a number type T runs
// on one contact (T = double) or on eight (T = Pack) with the same text.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

namespace dem {

inline constexpr int lanes = 8;

// A yes or no per lane.
struct Mask {
  using Lanes [[gnu::vector_size(8 * lanes)]] = long long;
  Lanes bits;

  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  friend Mask operator!(Mask a) { return {~a.bits}; }
};

struct Pack {
  using Lanes [[gnu::vector_size(8 * lanes)]] = double;
  Lanes value;

  Pack() = default;
  Pack(double all) : value(Lanes{} + all) {}
  explicit Pack(Lanes lanes) : value(lanes) {}
  double operator[](int lane) const { return value[lane]; }

  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }

  friend Pack operator+(Pack a, Pack b) { return Pack(a.value + b.value); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.value - b.value); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.value * b.value); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.value / b.value); }
  friend Pack operator-(Pack a) { return Pack(-a.value); }
  friend Mask operator<(Pack a, Pack b) { return {a.value < b.value}; }
  friend Mask operator>(Pack a, Pack b) { return {a.value > b.value}; }
  friend Mask operator<=(Pack a, Pack b) { return {a.value <= b.value}; }

  friend Pack sqrt(Pack a) {
#if defined(__AVX512F__)
    return Pack((Lanes)_mm512_sqrt_pd((__m512d)a.value));
#else
    for (int k = 0; k < lanes; ++k) a.value[k] = std::sqrt(a.value[k]);
    return a;
#endif
  }
};

inline double select(bool yes, double a, double b) {
  return yes ? a : b;
}
inline Pack select(Mask yes, Pack a, Pack b) {
  return Pack(yes.bits ? a.value : b.value);
}

inline double larger(double a, double b) {
  return a > b ? a : b;
}
inline double smaller(double a, double b) {
  return a < b ? a : b;
}
inline Pack larger(Pack a, Pack b) {
  return select(a > b, a, b);
}
inline Pack smaller(Pack a, Pack b) {
  return select(a < b, a, b);
}
template <class T>
T magnitude(T a) {
  return larger(a, -a);
}

inline bool any(bool yes) {
  return yes;
}
inline bool any(Mask yes) {
  long long found = 0;
  for (int k = 0; k < lanes; ++k) found |= yes.bits[k];
  return found != 0;
}
inline bool lane(bool yes, int) {
  return yes;
}
inline bool lane(Mask yes, int k) {
  return yes.bits[k] != 0;
}
inline double lane(double a, int) {
  return a;
}
inline double lane(Pack a, int k) {
  return a[k];
}

inline void set_lane(double& a, int, double to) {
  a = to;
}
inline void set_lane(Pack& a, int k, double to) {
  a.value[k] = to;
}

// How many contacts a number of type T holds, and the lanes below `count` as a mask.
template <class T>
inline constexpr int width = static_cast<int>(sizeof(T) / sizeof(double));

template <class T>
auto lanes_below(std::int64_t count) {
  if constexpr (width<T> == 1) {
    return count > 0;
  } else {
    Pack number;
    for (int k = 0; k < lanes; ++k) number.value[k] = k;
    return number < Pack(static_cast<double>(count));
  }
}

// Reads base[stride * index[k]] into lane k.
template <class T>
T gather(const double* base, const std::int32_t* index, int stride) {
  if constexpr (width<T> == 1) {
    return base[stride * static_cast<std::int64_t>(index[0])];
  } else {
#if defined(__AVX512F__)
    const __m256i element = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    const __m256i offset = _mm256_mullo_epi32(element, _mm256_set1_epi32(stride));
    return Pack((Pack::Lanes)_mm512_i32gather_pd(offset, base, 8));
#else
    Pack read;
    for (int k = 0; k < lanes; ++k) read.value[k] = base[stride * std::int64_t{index[k]}];
    return read;
#endif
  }
}

template <class T>
T load(const double* from) {
  if constexpr (width<T> == 1) {
    return *from;
  } else {
    Pack read;
    __builtin_memcpy(&read, from, sizeof read);
    return read;
  }
}

}  // namespace dem
