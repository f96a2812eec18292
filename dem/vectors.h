// Vectors of three numbers that may be read four at a time, the last one too.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "dem/vec3.h"

namespace dem {

// Leaves room for one value behind the last.
template <class T>
struct OneMore {
  using value_type = T;

  OneMore() = default;
  template <class U>
  OneMore(const OneMore<U>&) {}

  T* allocate(std::size_t count) { return std::allocator<T>().allocate(count + 1); }
  void deallocate(T* at, std::size_t count) { std::allocator<T>().deallocate(at, count + 1); }
  friend bool operator==(OneMore, OneMore) { return true; }
};

using Vectors = std::vector<Vec3d, OneMore<Vec3d>>;

}  // namespace dem
