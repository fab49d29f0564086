#pragma once

// Structures that cross from C++ to the shaders, as C++ lays them out.

#include <cstddef>
#include <string>
#include <vector>

namespace velarium::test {

struct HostMember {
  std::string name;
  std::size_t offset = 0;
};

struct HostStruct {
  std::string name;  // of the structure in GLSL
  std::size_t size = 0;
  std::vector<HostMember> members;  // in order
};

[[nodiscard]] std::vector<HostStruct> host_structs();

}  // namespace velarium::test
