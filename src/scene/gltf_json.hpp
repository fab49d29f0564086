#pragma once

// JSON text as glTF needs it: bounded in depth and size, no duplicate keys, typed access, and errors that name the
// JSON pointer at fault. Pointers are found by search when an error is raised, so that reading costs nothing for them.

#include "scene/gltf.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace velarium::scene::gltf {

class Value;

// A glTF file being read: its JSON, and what was found wrong with it. Values refer to it: it must outlive them.
class Document {
 public:
  // Throws Error(input_invalid) with line, column and byte offset where `text` is not JSON, or where it repeats a key
  // of an object, nests deeper than `limits.depth`, or has more values than fit `limits.bytes` of memory.
  // strict: repairs are errors.
  Document(std::filesystem::path file, std::string_view text, const GltfLimits& limits, bool strict = false);
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] Value root();

  // The remarks so far, each reason once, at the first place where it was made and with the number of others.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  friend class Value;
  struct Warning {
    std::string first_place;
    std::uint64_t count = 0;
  };
  [[nodiscard]] std::string pointer_to(const nlohmann::json& value) const;

  std::filesystem::path file_;
  bool strict_;
  std::unique_ptr<nlohmann::json> json_;
  std::map<std::string, Warning> warnings_;  // by reason
  std::vector<std::string> warning_order_;
};

// A value in the document, or the absence of one: members that are not there convert to false.
// Every accessor throws Error(input_invalid) "POINTER: reason" where the value is not of the type asked for.
class Value {
 public:
  Value() = default;

  [[nodiscard]] explicit operator bool() const { return json_ != nullptr; }

  // Objects. An absent value has no members.
  [[nodiscard]] Value operator[](std::string_view key) const;
  [[nodiscard]] Value require(std::string_view key) const;
  [[nodiscard]] std::vector<std::pair<std::string_view, Value>> members() const;

  // Arrays. An absent value has no elements.
  [[nodiscard]] std::uint32_t size() const;
  [[nodiscard]] Value at(std::uint32_t index) const;
  [[nodiscard]] std::vector<Value> elements() const;

  // Scalars. The value must be present, but for the forms with a fallback.
  [[nodiscard]] std::string_view text() const;
  [[nodiscard]] std::string text_or(std::string_view fallback) const;
  [[nodiscard]] bool boolean_or(bool fallback) const;
  [[nodiscard]] std::uint64_t integer(std::uint64_t lowest, std::uint64_t highest) const;
  [[nodiscard]] std::uint64_t integer_or(std::uint64_t fallback, std::uint64_t lowest, std::uint64_t highest) const;
  [[nodiscard]] float number() const;  // finite, also as a float
  [[nodiscard]] float number_or(float fallback) const;
  // As the file writes it, where two numbers are to be told apart that are equal as floats.
  [[nodiscard]] double double_or(double fallback) const;
  // A factor out of its range has one plausible reading: the nearest value in the range, with a warning.
  [[nodiscard]] float clamped_or(float fallback, float lowest, float highest) const;

  // What applications put beside glTF may be anything, so it is asked before it is read: a member of the object's
  // extras, absent where the extras are no object or have none of this name.
  [[nodiscard]] Value extra_member(std::string_view name) const;
  [[nodiscard]] bool is_object() const;
  [[nodiscard]] bool is_array() const;
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_boolean() const;
  [[nodiscard]] bool is_number() const;  // that number() takes

  // An array of exactly as many numbers as the glm type has.
  template <class Vector>
  [[nodiscard]] Vector vector_or(Vector fallback) const {
    using Number = typename Vector::value_type;
    if (*this) read_numbers(std::span<Number>(glm::value_ptr(fallback), sizeof(Vector) / sizeof(Number)));
    return fallback;
  }
  template <class Vector>
  [[nodiscard]] Vector clamped_vector_or(Vector fallback, float lowest, float highest) const {
    if (*this) read_clamped_numbers({glm::value_ptr(fallback), sizeof(Vector) / sizeof(float)}, lowest, highest);
    return fallback;
  }

  // The index of an element of a table of this size; `table_name` ("meshes") is for the error.
  [[nodiscard]] std::uint32_t reference(std::uint32_t table_size, std::string_view table_name) const;
  // The same for a reference that may be absent: kNone then.
  [[nodiscard]] std::int32_t reference_or_none(std::uint32_t table_size, std::string_view table_name) const;

  [[nodiscard]] std::string pointer() const;
  [[nodiscard]] const std::filesystem::path& file() const { return document_->file(); }
  [[noreturn]] void fail(const std::string& reason) const;
  void warn(const std::string& reason) const;
  // For a breach of the specification that has one plausible reading, which the caller takes: warn(), or fail() where
  // the document is strict.
  void repair(const std::string& reason) const;

 private:
  friend class Document;
  Value(Document& document, const nlohmann::json* json) : document_(&document), json_(json) {}
  [[nodiscard]] std::string shown() const;
  void read_numbers(std::span<float> out) const;
  void read_numbers(std::span<double> out) const;
  void read_clamped_numbers(std::span<float> out, float lowest, float highest) const;

  Document* document_ = nullptr;
  const nlohmann::json* json_ = nullptr;
};

}  // namespace velarium::scene::gltf
