#pragma once

// As much of a SPIR-V module as the tests ask about.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace velarium::test {

struct SpirvMember {
  std::string name;
  std::uint32_t offset = 0;
};

// A structure with a layout, as a block or inside one.
struct SpirvStruct {
  std::string name;
  bool is_block = false;
  std::vector<SpirvMember> members;
  std::uint32_t array_stride = 0;  // where the module has an array of it with a layout; else 0
};

enum class SpirvBinding {
  combined_image_sampler,
  sampled_image,
  sampler,
  storage_image,
  uniform_buffer,
  storage_buffer
};

struct SpirvVariable {
  std::uint32_t set = 0, binding = 0;
  SpirvBinding kind = SpirvBinding::storage_buffer;
};

struct SpirvConstant {
  std::uint32_t id = 0;
  std::string name;  // empty of the size of a group, which a compiler may write down twice
};

struct SpirvModule {
  std::vector<SpirvVariable> variables;  // that are bound
  std::vector<SpirvConstant> constants;  // specialisation constants
  std::vector<SpirvStruct> structs;      // that have offsets; of one name several where they differ
};

// Precondition: SPIR-V.
[[nodiscard]] SpirvModule read_spirv(std::span<const std::uint32_t> words);

}  // namespace velarium::test
