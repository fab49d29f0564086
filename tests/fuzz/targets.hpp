#pragma once

// What is fuzzed: the places where bytes from anywhere enter. Each target reads its input as far as it goes. An Error
// of the world's fault is an orderly end; any other exception leaves the target and is a finding, as are whatever the
// sanitizers stop, and inputs that take long or much memory.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace velarium::fuzz {

using Bytes = std::span<const std::byte>;

void gltf(Bytes input);       // a .gltf or .glb file, read into tables and posed
void json(Bytes input);       // JSON text, walked whole with every accessor of values
void glb(Bytes input);        // the chunks of a .glb file, and what their JSON says of buffers
void draco(Bytes input);      // a primitive of Draco's: the first bytes describe it, the rest is its data
void meshopt(Bytes input);    // a view that meshoptimizer compressed, described in the same way
void accessors(Bytes input);  // accessors over a buffer: the first bytes describe them, the rest is the buffer
void uri(Bytes input);        // the text of a URI in a glTF file
void picture(Bytes input);    // PNG, JPEG or WebP
void exr(Bytes input);
void hdr(Bytes input);
void config(Bytes input);  // a TOML file of options, each of them set

struct Target {
  std::string_view name;
  void (*run)(Bytes);
};

inline constexpr Target kTargets[] = {{"gltf", gltf},       {"glb", glb},         {"draco", draco},
                                      {"meshopt", meshopt}, {"json", json},       {"accessors", accessors},
                                      {"uri", uri},         {"picture", picture}, {"exr", exr},
                                      {"hdr", hdr},         {"config", config}};

}  // namespace velarium::fuzz
