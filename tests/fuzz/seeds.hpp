#pragma once

#include "core/files.hpp"

#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

namespace velarium::fuzz {

// A folder with a folder of seeds a target.
class Seeds {
 public:
  explicit Seeds(std::filesystem::path root) : root_(std::move(root)) {}

  void add(std::string_view target, std::string_view name, std::span<const std::byte> data) const {
    std::filesystem::create_directories(root_ / target);
    write_file(root_ / target / name, data);
  }
  void add(std::string_view target, std::string_view name, std::string_view text) const {
    add(target, name, std::as_bytes(std::span(text)));
  }

 private:
  std::filesystem::path root_;
};

// Meshes as their codecs' own encoders write them, for `draco` and `meshopt`.
void add_meshes(const Seeds& seeds);

}  // namespace velarium::fuzz
