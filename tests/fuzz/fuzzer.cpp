// One target as libFuzzer calls it; VELARIUM_FUZZ_TARGET names it.
#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  velarium::fuzz::VELARIUM_FUZZ_TARGET(std::as_bytes(std::span(data, size)));
  return 0;
}
