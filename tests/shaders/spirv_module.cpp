#include "spirv_module.hpp"

#include <cstring>

namespace velarium::test {
namespace {

// Numbers of the SPIR-V specification, section 3.
enum Op : std::uint32_t {
  kName = 5,
  kMemberName = 6,
  kTypeImage = 25,
  kTypeSampler = 26,
  kTypeSampledImage = 27,
  kTypeArray = 28,
  kTypeRuntimeArray = 29,
  kTypeStruct = 30,
  kTypePointer = 32,
  kVariable = 59,
  kDecorate = 71,
  kMemberDecorate = 72
};
enum Decoration : std::uint32_t { kSpecId = 1, kBlock = 2, kArrayStride = 6, kBinding = 33, kSet = 34, kOffset = 35 };
enum Storage : std::uint32_t { kUniform = 2, kStorageBuffer = 12 };

constexpr std::size_t kHeaderWords = 5;

struct Id {
  std::uint32_t op = 0, type = 0, storage = 0, sampled = 0, stride = 0, spec_id = 0, set = 0, binding = 0;
  bool bound = false, block = false, specialised = false;
  std::string name;
  std::map<std::uint32_t, SpirvMember> members;
  bool has_offsets = false;
};

using Ids = std::map<std::uint32_t, Id>;
using Words = std::span<const std::uint32_t>;

std::string text(Words words) {
  const auto* chars = reinterpret_cast<const char*>(words.data());
  return {chars, strnlen(chars, words.size_bytes())};
}

void decorate(Id& id, Words words) {
  const auto value = [&] { return words[3]; };
  switch (words[2]) {
    case kSpecId:
      id.spec_id = value();
      id.specialised = true;
      break;
    case kBlock:
      id.block = true;
      break;
    case kArrayStride:
      id.stride = value();
      break;
    case kBinding:
      id.binding = value();
      id.bound = true;
      break;
    case kSet:
      id.set = value();
      break;
    default:
      break;
  }
}

void read_type(Ids& ids, Words words) {
  Id& id = ids[words[1]];
  id.op = words[0] & 0xffffu;
  if (id.op == kTypeImage) id.sampled = words[7];
  if (id.op == kTypePointer) id.type = words[3];
  if (id.op == kTypeArray || id.op == kTypeRuntimeArray) id.type = words[2];
}

void read_instruction(Ids& ids, Words words) {
  switch (words[0] & 0xffffu) {
    case kName:
      ids[words[1]].name = text(words.subspan(2));
      break;
    case kMemberName:
      ids[words[1]].members[words[2]].name = text(words.subspan(3));
      break;
    case kDecorate:
      decorate(ids[words[1]], words);
      break;
    case kMemberDecorate:
      if (words[3] != kOffset) break;
      ids[words[1]].members[words[2]].offset = words[4];
      ids[words[1]].has_offsets = true;
      break;
    case kTypeImage:
    case kTypeSampler:
    case kTypeSampledImage:
    case kTypeArray:
    case kTypeRuntimeArray:
    case kTypeStruct:
    case kTypePointer:
      read_type(ids, words);
      break;
    case kVariable:
      ids[words[2]].op = kVariable;
      ids[words[2]].type = words[1];
      ids[words[2]].storage = words[3];
      break;
    default:
      break;
  }
}

SpirvBinding kind_of(const Ids& ids, const Id& variable) {
  const Id* type = &ids.at(ids.at(variable.type).type);
  while (type->op == kTypeArray || type->op == kTypeRuntimeArray) type = &ids.at(type->type);
  if (variable.storage == kStorageBuffer) return SpirvBinding::storage_buffer;
  if (variable.storage == kUniform) return SpirvBinding::uniform_buffer;
  if (type->op == kTypeSampler) return SpirvBinding::sampler;
  if (type->op == kTypeSampledImage) return SpirvBinding::combined_image_sampler;
  return type->sampled == 2 ? SpirvBinding::storage_image : SpirvBinding::sampled_image;
}

SpirvStruct struct_of(const Ids& ids, std::uint32_t number, const Id& id) {
  SpirvStruct result{.name = id.name, .is_block = id.block};
  for (const auto& [index, member] : id.members) result.members.push_back(member);
  for (const auto& [other, array] : ids)
    if ((array.op == kTypeArray || array.op == kTypeRuntimeArray) && array.type == number && array.stride != 0)
      result.array_stride = array.stride;
  return result;
}

}  // namespace

SpirvModule read_spirv(Words words) {
  SpirvModule module;
  Ids ids;
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::size_t count = words[at] >> 16u;
    read_instruction(ids, words.subspan(at, count));
    at += count;
  }
  for (const auto& [number, id] : ids) {
    if (id.op == kVariable && id.bound) module.variables.push_back({id.set, id.binding, kind_of(ids, id)});
    if (id.specialised) module.constants.push_back({id.spec_id, id.name});
    if (id.op == kTypeStruct && id.has_offsets) module.structs.push_back(struct_of(ids, number, id));
  }
  return module;
}

}  // namespace velarium::test
