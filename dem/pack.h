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
#if defined(__AVX512F__)
struct Mask {
  __mmask8 bits;

  friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
  friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
  friend Mask operator!(Mask a) { return {static_cast<__mmask8>(~a.bits)}; }
};
#else
struct Mask {
  using Lanes [[gnu::vector_size(8 * lanes)]] = long long;
  Lanes bits;

  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  friend Mask operator!(Mask a) { return {~a.bits}; }
};
#endif

struct Pack {
  using Lanes [[gnu::vector_size(8 * lanes)]] = double;
  Lanes value;

  Pack() = default;
  Pack(double all) : value(Lanes{} + all) {}
  explicit Pack(Lanes lanes) : value(lanes) {}
  double operator[](int lane) const { return value[lane]; }

  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }

  friend Pack operator+(Pack a, Pack b) { return Pack(a.value + b.value); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.value - b.value); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.value * b.value); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.value / b.value); }
  friend Pack operator-(Pack a) { return Pack(-a.value); }
  friend Mask operator>(Pack a, Pack b) { return b < a; }
#if defined(__AVX512F__)
  friend Mask operator<(Pack a, Pack b) {
    return {_mm512_cmp_pd_mask((__m512d)a.value, (__m512d)b.value, _CMP_LT_OQ)};
  }
  friend Mask operator<=(Pack a, Pack b) {
    return {_mm512_cmp_pd_mask((__m512d)a.value, (__m512d)b.value, _CMP_LE_OQ)};
  }
#else
  friend Mask operator<(Pack a, Pack b) {
    return {a.value < b.value};
  }
  friend Mask operator<=(Pack a, Pack b) {
    return {a.value <= b.value};
  }
#endif

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
#if defined(__AVX512F__)
  return Pack((Pack::Lanes)_mm512_mask_blend_pd(yes.bits, (__m512d)b.value, (__m512d)a.value));
#else
  return Pack(yes.bits ? a.value : b.value);
#endif
}

inline double larger(double a, double b) {
  return a > b ? a : b;
}
inline double smaller(double a, double b) {
  return a < b ? a : b;
}
// As above, what is not a number included: then b.
inline Pack larger(Pack a, Pack b) {
#if defined(__AVX512F__)
  return Pack((Pack::Lanes)_mm512_max_pd((__m512d)a.value, (__m512d)b.value));
#else
  return select(a > b, a, b);
#endif
}
inline Pack smaller(Pack a, Pack b) {
#if defined(__AVX512F__)
  return Pack((Pack::Lanes)_mm512_min_pd((__m512d)a.value, (__m512d)b.value));
#else
  return select(a < b, a, b);
#endif
}
template <class T>
T magnitude(T a) {
  return larger(a, -a);
}

inline bool any(bool yes) {
  return yes;
}
inline bool lane(bool yes, int) {
  return yes;
}
#if defined(__AVX512F__)
inline bool any(Mask yes) {
  return yes.bits != 0;
}
inline bool lane(Mask yes, int k) {
  return yes.bits >> k & 1;
}
#else
inline bool any(Mask yes) {
  long long found = 0;
  for (int k = 0; k < lanes; ++k) found |= yes.bits[k];
  return found != 0;
}
inline bool lane(Mask yes, int k) {
  return yes.bits[k] != 0;
}
#endif
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
T lane_numbers() {
  if constexpr (width<T> == 1)
    return 0.0;
  else
    return Pack(Pack::Lanes{0, 1, 2, 3, 4, 5, 6, 7});
}

template <class T>
auto lanes_below(std::int64_t count) {
  return lane_numbers<T>() < T(static_cast<double>(count));
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

inline Pack load(const double* from) {
  Pack read;
  __builtin_memcpy(&read, from, sizeof read);
  return read;
}

inline void store(Pack a, double* to) {
  __builtin_memcpy(to, &a, sizeof a);
}

inline void store(double a, double* to) {
  *to = a;
}

// 1 / sqrt(a) of a in 1e-300 to 1e300, to the last bit or two: the processor's estimate y, 14 bits,
// where it has one, times the series of (1 - miss)^(-1/2), miss = 1 - a y^2, whose first term left
// out is below 2^-53. Much faster than a root and a division.
template <class T>
T reciprocal_root(T a) {
#if defined(__AVX512F__)
  T root;
  if constexpr (width<T> == 1)
    root = _mm_cvtsd_f64(_mm_rsqrt14_sd(_mm_setzero_pd(), _mm_set_sd(a)));
  else
    root = Pack((Pack::Lanes)_mm512_rsqrt14_pd((__m512d)a.value));
  const T miss = T(1.0) - a * (root * root);
  const T series = T(0.5) + miss * (T(3.0 / 8.0) + miss * T(5.0 / 16.0));
  return root + root * miss * series;
#else
  using std::sqrt;
  return T(1.0) / sqrt(a);
#endif
}

// The square root of a in 0 to 1e300, by the reciprocal one.
template <class T>
T fast_root(T a) {
  return a * reciprocal_root(larger(a, T(1e-300)));
}

}  // namespace dem
