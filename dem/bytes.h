// How much memory arrays take.
#pragma once

#include <cstddef>

namespace dem {

// Of all entries [B].
template <class... Arrays>
std::size_t bytes_of(const Arrays&... arrays) {
  return (std::size_t{0} + ... + (arrays.size() * sizeof(typename Arrays::value_type)));
}

}  // namespace dem
