#include "support.hpp"

#include "scene/gltf_json.hpp"

#include <glm/glm.hpp>

#include <limits>

namespace velarium::fuzz {
namespace {

using scene::gltf::Value;

constexpr std::uint32_t kDepth = 64;

// Asks a value for everything that it could be; all but a few questions end in an Error.
void ask(const Value& value) {
  expect_orderly([&] { static_cast<void>(value.text()); });
  expect_orderly([&] { static_cast<void>(value.boolean_or(false)); });
  expect_orderly([&] { static_cast<void>(value.integer(0, std::numeric_limits<std::uint64_t>::max())); });
  expect_orderly([&] { static_cast<void>(value.number()); });
  expect_orderly([&] { static_cast<void>(value.clamped_or(0.0f, -1.0f, 1.0f)); });
  expect_orderly([&] { static_cast<void>(value.vector_or(glm::vec3(0.0f))); });
  expect_orderly([&] { static_cast<void>(value.reference(4, "nodes")); });
  expect_orderly([&] { static_cast<void>(value.require("name")); });
}

void walk(const Value& value) {
  ask(value);
  expect_orderly([&] {
    for (const auto& [key, member] : value.members()) walk(member);
  });
  expect_orderly([&] {
    for (const Value& element : value.elements()) walk(element);
  });
}

}  // namespace

void json(Bytes input) {
  // Each question that ends in an Error searches the document for its pointer: a long one would take quadratic time.
  constexpr std::size_t kLongest = 1024;
  if (input.size() > kLongest) return;
  expect_orderly([&] {
    scene::gltf::Document document("input.gltf", text_of(input), {.depth = kDepth});
    walk(document.root());
    static_cast<void>(document.warnings());
  });
}

}  // namespace velarium::fuzz
