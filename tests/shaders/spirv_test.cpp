// What every shader binds and lays out, read from its SPIR-V: numbers that two languages and many files share.

#include "host_structs.hpp"
#include "spirv_module.hpp"

#include "gpu/limits.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/spirv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace velarium::test {
namespace {

struct EmbeddedShader {
  const char* name;
  std::span<const std::uint32_t> embedded, named;
};

#include "all_shaders.inc"

void PrintTo(const EmbeddedShader& shader, std::ostream* out) {
  *out << shader.name;
}

class Spirv : public testing::TestWithParam<EmbeddedShader> {};

std::size_t count(const SpirvModule& module, std::initializer_list<SpirvBinding> kinds) {
  return static_cast<std::size_t>(std::ranges::count_if(
      module.variables, [&](const SpirvVariable& v) { return std::ranges::find(kinds, v.kind) != kinds.end(); }));
}

TEST_P(Spirv, NoTwoVariablesShareABinding) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  // Unoptimised: also those that specialisation or the optimiser leaves out.
  for (const auto& variable : read_spirv(GetParam().named).variables) {
    EXPECT_LT(variable.set, gpu::kMaxSets);
    EXPECT_TRUE(seen.emplace(variable.set, variable.binding).second)
        << "set " << variable.set << ", binding " << variable.binding;
  }
}

TEST_P(Spirv, NoTwoConstantsShareAnId) {
  std::map<std::uint32_t, std::string> names;
  for (const auto& constant : read_spirv(GetParam().named).constants) {
    const auto [known, fresh] = names.emplace(constant.id, constant.name);
    EXPECT_TRUE(fresh || (known->second.empty() && constant.name.empty()))
        << "id " << constant.id << " of " << known->second << " and " << constant.name;
  }
}

TEST_P(Spirv, FitsIntoThePoorestDriver) {
  const auto module = read_spirv(GetParam().embedded);
  // A pipeline whose shaders use one of the shared samplers has them all.
  const bool shared =
      std::ranges::any_of(module.variables, [](const auto& v) { return v.set == gpu::SharedSamplers::kSet; });
  const std::size_t samplers =
      count(module, {SpirvBinding::combined_image_sampler}) + (shared ? gpu::SharedSamplers::kCount : 0);
  EXPECT_LE(samplers, gpu::kUsedLimits.samplers);
  EXPECT_LE(count(module, {SpirvBinding::combined_image_sampler, SpirvBinding::sampled_image}),
            gpu::kUsedLimits.sampled_images);
  EXPECT_LE(count(module, {SpirvBinding::storage_buffer}), gpu::kUsedLimits.storage_buffers);
  EXPECT_LE(count(module, {SpirvBinding::storage_image}), gpu::kUsedLimits.storage_images);
}

TEST_P(Spirv, HasSamplersInTheirSetAlone) {
  for (const auto& variable : read_spirv(GetParam().named).variables)
    EXPECT_EQ(variable.kind == SpirvBinding::sampler, variable.set == gpu::SharedSamplers::kSet)
        << "set " << variable.set << ", binding " << variable.binding;
}

// The block around a table or the push constants has one member, at 0; what is inside has the layout that C++ gives it.
TEST_P(Spirv, LaysStructuresOutAsCppDoes) {
  const auto hosts = host_structs();
  for (const auto& device : read_spirv(GetParam().named).structs) {
    if (device.is_block) {
      ASSERT_EQ(device.members.size(), 1u) << device.name;
      EXPECT_EQ(device.members[0].offset, 0u) << device.name;
      continue;
    }
    const auto host = std::ranges::find(hosts, device.name, &HostStruct::name);
    ASSERT_NE(host, hosts.end()) << device.name << " is not in host_structs.cpp";
    ASSERT_EQ(device.members.size(), host->members.size()) << device.name;
    for (std::size_t i = 0; i < device.members.size(); ++i) {
      EXPECT_EQ(device.members[i].name, host->members[i].name) << device.name;
      EXPECT_EQ(device.members[i].offset, host->members[i].offset) << device.name << '.' << device.members[i].name;
    }
    EXPECT_TRUE(device.array_stride == 0 || device.array_stride == host->size) << device.name;
  }
}

// What pipelines are made by says the same as the reader of this test.
TEST_P(Spirv, IsReflectedWhole) {
  const auto module = read_spirv(GetParam().embedded);
  const auto reflection = gpu::reflect(GetParam().embedded);
  EXPECT_EQ(reflection.bindings.size(), module.variables.size());
  for (const auto& variable : module.variables)
    EXPECT_TRUE(std::ranges::any_of(
        reflection.bindings,
        [&](const gpu::ReflectedBinding& b) { return b.set == variable.set && b.binding == variable.binding; }))
        << "set " << variable.set << ", binding " << variable.binding;
}

INSTANTIATE_TEST_SUITE_P(All, Spirv, testing::ValuesIn(kAllShaders), [](const auto& shader) {
  std::string name = shader.param.name;
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '.'; }, '_');
  return name;
});

}  // namespace
}  // namespace velarium::test
