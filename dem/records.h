// Between records, one stone or contact after the other, and packs, one number of eight of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/pack.h"
#include "dem/particle_store.h"
#include "dem/vec3.h"

namespace dem {

// Lane k takes vectors[index[k]].
template <class T>
Vec3<T> gather(const std::vector<Vec3d>& vectors, const std::int32_t* index) {
#if defined(__AVX512F__)
  if constexpr (width<T> == lanes) {
    // Vector k below, vector k + 4 above; a load that a mask ends touches nothing behind the mask.
    const auto two = [&](int k) {
      const __m512d low = _mm512_maskz_loadu_pd(0x07, &vectors[index[k]].x);
      return _mm512_mask_loadu_pd(low, 0x70, &vectors[index[k + 4]].x - 4);
    };
    const __m512d a = two(0), b = two(1), c = two(2), d = two(3);
    const __m512d xz_ab = _mm512_unpacklo_pd(a, b), xz_cd = _mm512_unpacklo_pd(c, d);
    const __m512d y_ab = _mm512_unpackhi_pd(a, b), y_cd = _mm512_unpackhi_pd(c, d);
    const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    return {Pack((Pack::Lanes)_mm512_permutex2var_pd(xz_ab, first, xz_cd)),
            Pack((Pack::Lanes)_mm512_permutex2var_pd(y_ab, first, y_cd)),
            Pack((Pack::Lanes)_mm512_permutex2var_pd(xz_ab, second, xz_cd))};
  }
#endif
  const double* base = &vectors.front().x;
  return {gather<T>(base, index, 3), gather<T>(base + 1, index, 3), gather<T>(base + 2, index, 3)};
}

// Records k, made of lane k of each number.
inline std::array<Pack, 8> transposed(const std::array<Pack, 8>& number) {
#if defined(__AVX512F__)
  const auto row = [&](int n) { return (__m512d)number[n].value; };
  // Pairs of numbers, then fours, then all eight.
  __m512d pair[8], four[8];
  std::array<Pack, 8> record;
  for (int n = 0; n < 4; ++n) {
    pair[n] = _mm512_unpacklo_pd(row(2 * n), row(2 * n + 1));      // of records 0, 2, 4, 6
    pair[4 + n] = _mm512_unpackhi_pd(row(2 * n), row(2 * n + 1));  // of records 1, 3, 5, 7
  }
  for (int odd = 0; odd < 2; ++odd)
    for (int half = 0; half < 2; ++half) {
      const __m512d low = pair[4 * odd + 2 * half], high = pair[4 * odd + 2 * half + 1];
      four[4 * odd + half] = _mm512_shuffle_f64x2(low, high, 0x88);      // records 0, 4 (1, 5)
      four[4 * odd + 2 + half] = _mm512_shuffle_f64x2(low, high, 0xdd);  // records 2, 6 (3, 7)
    }
  for (int odd = 0; odd < 2; ++odd)
    for (int late = 0; late < 2; ++late) {
      const __m512d low = four[4 * odd + 2 * late], high = four[4 * odd + 2 * late + 1];
      const int k = odd + 2 * late;
      record[k] = Pack((Pack::Lanes)_mm512_shuffle_f64x2(low, high, 0x88));
      record[k + 4] = Pack((Pack::Lanes)_mm512_shuffle_f64x2(low, high, 0xdd));
    }
#else
  std::array<Pack, 8> record;
  for (int k = 0; k < 8; ++k)
    for (int n = 0; n < 8; ++n) record[k].value[n] = number[n][k];
#endif
  return record;
}

// The loads of T stones one by one.
template <class T>
std::array<Pack, width<T>> records(const LoadOf<T>& load) {
  static_assert(sizeof(LoadOf<T>) == 8 * sizeof(T));
  if constexpr (width<T> == 1)
    return {dem::load(&load.force.x)};
  else
    return transposed({load.force.x, load.force.y, load.force.z, load.spare, load.torque.x,
                       load.torque.y, load.torque.z, load.crush});
}

// Adds a load, one record; of crush, with `breaks`, the larger one stays.
template <bool breaks>
void add_load(const Pack& load, Load& to) {
  const Pack before = dem::load(&to.force.x);
  Pack sum = before + load;
  if constexpr (breaks) sum = select(lanes_below<Pack>(lanes - 1), sum, larger(before, load));
  store(sum, &to.force.x);
}

}  // namespace dem
