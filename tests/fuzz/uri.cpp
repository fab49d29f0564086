#include "support.hpp"

#include "scene/gltf_uri.hpp"

#include <nlohmann/json.hpp>

namespace velarium::fuzz {

void uri(Bytes input) {
  Budget budget("load.bytes", 1 << 16);
  // The folder holds the file itself and nothing else.
  static const InputFile file("input.gltf");
  using nlohmann::json;
  const std::string text =
      json{{"uri", text_of(input)}}.dump(-1, ' ', false, json::error_handler_t::replace);  // JSON is always UTF-8
  expect_orderly([&] {
    scene::gltf::Document document(file.write(input), text, {.depth = 8});
    static_cast<void>(scene::gltf::read_uri(scene::gltf::find_uri(document.root()["uri"], {}, budget)));
  });
}

}  // namespace velarium::fuzz
