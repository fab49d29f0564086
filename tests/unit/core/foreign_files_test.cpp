#include "core/foreign_files.hpp"

#include <gtest/gtest.h>

#include <string>

namespace velarium {
namespace {

std::string_view kind_of(const std::string& text) {
  return foreign_kind(std::as_bytes(std::span(text)));
}

TEST(ForeignFiles, AreNamedByTheirBeginning) {
  const std::pair<std::string, const char*> cases[] = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:12", "Git LFS"},
      {"PK\3\4....", "ZIP"},
      {"\x1f\x8b....", "gzip"},
      {"#usda 1.0\n", "USD"},
      {"PXR-USDC....", "USD"},
      {"ply\nformat ascii 1.0\n", "PLY"},
      {"solid name\n  facet normal 0 0 1\n", "STL"},
      {std::string(80, 'x') + std::string("\1\0\0\0", 4) + std::string(50, 'y'), "STL"},
      {"# made by hand\nmtllib a.mtl\no thing\nv 0 0 0\n", "OBJ"},
      {"\n<!DOCTYPE html><html>", "web page"},
      {"Kaydara FBX Binary", "FBX"},
      {"BLENDER-v300", "Blender"}};
  for (const auto& [text, word] : cases)
    EXPECT_NE(kind_of(text).find(word), std::string_view::npos) << text << ": " << kind_of(text);
}

TEST(ForeignFiles, OthersHaveNoName) {
  for (const char* text : {"", "{\"asset\": {}}", "glTF", "some text\nof any kind", "vertices", "# a comment alone"})
    EXPECT_EQ(kind_of(text), "") << text;
}

}  // namespace
}  // namespace velarium
