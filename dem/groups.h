// Numbers grouped by a key.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dem {

// Of the numbers 0, 1, ..., those of key k, rising, are item[start[k]] to item[start[k + 1]].
struct Groups {
  std::vector<std::uint32_t> start, item;
};

inline Groups group_by(std::span<const std::uint32_t> keys, std::size_t key_count) {
  Groups groups{std::vector<std::uint32_t>(key_count + 1, 0),
                std::vector<std::uint32_t>(keys.size())};
  for (const std::uint32_t key : keys) ++groups.start[key];
  for (std::size_t k = 1; k <= key_count; ++k) groups.start[k] += groups.start[k - 1];
  for (std::size_t n = keys.size(); n-- > 0;)
    groups.item[--groups.start[keys[n]]] = static_cast<std::uint32_t>(n);
  return groups;
}

}  // namespace dem
