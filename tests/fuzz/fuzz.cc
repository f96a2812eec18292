// A libFuzzer program of one reader, READER: build with the preset `fuzz`, run
//   build_fuzz/tests/fuzz_scene tests/fuzz/corpus/scene apps/scenes -max_total_time=1800
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tests::Place place;
  tests::READER({reinterpret_cast<const char*>(data), size}, place);
  return 0;
}
