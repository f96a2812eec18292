// Counter-based random numbers: a pure function of (seed, purpose, id, draw), so that a value
// depends neither on the order of calls nor on the number of threads.
//
// Generator: Philox4x32-10, Salmon, Moraes, Dror, Shaw (2011), "Parallel random numbers: as easy
// as 1, 2, 3".
#pragma once

#include <Random123/philox.h>

#include <cstdint>

namespace dem {

// What a number is for; numbers of two purposes never repeat each other.
enum class Purpose : std::uint32_t { size = 1, position = 2, strength = 3 };

// Uniform in the open interval (0, 1): the middle of one of 2^52 equal steps, never 0 or 1.
inline double uniform(std::uint64_t seed, Purpose purpose, std::uint32_t id,
                      std::uint32_t draw = 0) {
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const r123::Philox4x32::ctr_type counter = {{id, draw, static_cast<std::uint32_t>(purpose), 0}};
  const auto words = r123::Philox4x32{}(counter, key);
  const std::uint64_t bits = (std::uint64_t{words[1]} << 32 | words[0]) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

}  // namespace dem
