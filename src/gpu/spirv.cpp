#include "gpu/spirv.hpp"

#include "core/assert.hpp"

#include <unordered_map>

namespace velarium::gpu {
namespace {

// Numbers of the SPIR-V specification, section 3 (operations, decorations, storage classes).
enum Op : std::uint32_t {
  kOpTypeImage = 25,
  kOpTypeSampler = 26,
  kOpTypeSampledImage = 27,
  kOpTypeArray = 28,
  kOpTypeStruct = 30,
  kOpTypePointer = 32,
  kOpConstant = 43,
  kOpVariable = 59,
  kOpDecorate = 71,
};
enum Decoration : std::uint32_t { kBinding = 33, kDescriptorSet = 34 };
enum StorageClass : std::uint32_t { kUniform = 2, kPushConstant = 9, kStorageBuffer = 12 };

constexpr std::size_t kHeaderWords = 5;

struct Id {
  std::uint32_t op = 0;
  std::uint32_t type = 0;  // what a pointer, array or variable is of
  std::uint32_t value =
      0;  // a constant's value, an array's length id, a variable's storage class, an image's "Sampled"
  std::uint32_t set = 0, binding = 0;
  bool bound = false;
};

using Ids = std::unordered_map<std::uint32_t, Id>;

void decorate(Id& id, std::uint32_t decoration, std::span<const std::uint32_t> words) {
  if (decoration == kDescriptorSet) id.set = words[3];
  if (decoration == kBinding) {
    id.binding = words[3];
    id.bound = true;
  }
}

void read_instruction(Ids& ids, std::uint32_t op, std::span<const std::uint32_t> words) {
  switch (op) {
    case kOpDecorate:
      decorate(ids[words[1]], words[2], words);
      break;
    case kOpTypeImage:
      ids[words[1]].op = op;
      ids[words[1]].value = words[7];
      break;
    case kOpTypeSampler:
    case kOpTypeSampledImage:
    case kOpTypeStruct:
      ids[words[1]].op = op;
      break;
    case kOpTypeArray:
      ids[words[1]].op = op;
      ids[words[1]].type = words[2];
      ids[words[1]].value = words[3];
      break;
    case kOpTypePointer:
      ids[words[1]].op = op;
      ids[words[1]].type = words[3];
      break;
    case kOpConstant:
      ids[words[2]].op = op;
      ids[words[2]].value = words[3];
      break;
    case kOpVariable:
      ids[words[2]].op = op;
      ids[words[2]].type = words[1];
      ids[words[2]].value = words[3];
      break;
    default:
      break;
  }
}

VkDescriptorType descriptor_type(const Id& type, std::uint32_t storage) {
  constexpr std::uint32_t kStored = 2;  // OpTypeImage, "Sampled": used without a sampler
  if (storage == kStorageBuffer) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  if (storage == kUniform) return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  if (type.op == kOpTypeSampler) return VK_DESCRIPTOR_TYPE_SAMPLER;
  if (type.op == kOpTypeSampledImage) return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  return type.value == kStored ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
}

ReflectedBinding describe(const Ids& ids, const Id& variable) {
  const Id* type = &ids.at(ids.at(variable.type).type);
  ReflectedBinding result{.set = variable.set, .binding = variable.binding};
  if (type->op == kOpTypeArray) {
    result.count = ids.at(type->value).value;
    type = &ids.at(type->type);
  }
  result.type = descriptor_type(*type, variable.value);
  return result;
}

}  // namespace

Reflection reflect(std::span<const std::uint32_t> spirv) {
  Ids ids;
  for (std::size_t at = kHeaderWords; at < spirv.size();) {
    const std::uint32_t words = spirv[at] >> 16u;
    VEL_ASSERT(words > 0 && at + words <= spirv.size());
    read_instruction(ids, spirv[at] & 0xffffu, spirv.subspan(at, words));
    at += words;
  }
  Reflection result;
  for (const auto& [number, id] : ids) {
    if (id.op != kOpVariable) continue;
    if (id.value == kPushConstant) result.has_push_constants = true;
    if (id.bound) result.bindings.push_back(describe(ids, id));
  }
  return result;
}

}  // namespace velarium::gpu
