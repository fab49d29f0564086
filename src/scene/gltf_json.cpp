#include "scene/gltf_json.hpp"

#include "core/assert.hpp"
#include "core/budget.hpp"
#include "scene/scene.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace velarium::scene::gltf {

using Json = nlohmann::json;

namespace {

// Two bytes of text may be a value that takes far more memory. The dearest is a member that is an empty object: 96
// bytes for the node of the map that names it and 64 for its own map, as glibc's allocator rounds the sizes of
// libstdc++.
constexpr std::uint64_t kBytesAValue = 160;
// 10 MiB: a limit for small files is not one for their syntax. At most, so that an index of 32 bits reaches each value.
constexpr std::uint64_t kLeastValues = 1ull << 16, kMostValues = 1ull << 31;

// Messages quote text of the file, which may be long and may hold line breaks or terminal controls.
constexpr std::size_t kMaxMessage = 600;
constexpr std::size_t kMaxQuoted = 48;

std::string shortened(std::string text, std::size_t limit) {
  if (text.size() > limit) {
    while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xc0u) == 0x80u) --limit;  // whole UTF-8 characters
    text.resize(limit);
    text += "...";
  }
  return text;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return shortened(std::move(text), kMaxMessage);
}

void append_token(std::string& pointer, std::string_view key) {
  pointer += '/';
  for (const char c : key) {
    switch (c) {  // RFC 6901, 3
      case '~':
        pointer += "~0";
        break;
      case '/':
        pointer += "~1";
        break;
      default:
        pointer += c;
    }
  }
}

// Depth is bounded by the parser, so recursion is safe.
bool find(const Json& tree, const Json& wanted, std::string& pointer) {
  if (&tree == &wanted) return true;
  const std::size_t length = pointer.size();
  std::size_t index = 0;
  for (auto it = tree.begin(); tree.is_structured() && it != tree.end(); ++it, ++index) {
    append_token(pointer, tree.is_object() ? it.key() : std::to_string(index));
    if (find(*it, wanted, pointer)) return true;
    pointer.resize(length);
  }
  return false;
}

// Builds the tree from the parser's events, and refuses what would be unsafe or ambiguous.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(const std::filesystem::path& file, std::string_view text, const GltfLimits& limits, Json& root)
      : file_(file),
        text_(text),
        levels_("load.depth", limits.depth),
        max_bytes_(limits.bytes),
        max_values_(std::clamp(limits.bytes / kBytesAValue, kLeastValues, kMostValues)),
        root_(root) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const auto [place, is_new] = open_.back()->get_ref<Json::object_t&>().emplace(std::move(name), nullptr);
    if (!is_new) {
      std::string pointer;
      find(root_, place->second, pointer);
      throw Error(ErrorCode::input_invalid, file_, one_line(pointer + ": this property is given twice; remove one"));
    }
    member_ = &place->second;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    const std::size_t byte = position > 0 ? position - 1 : 0;  // the parser counts from one
    const std::string_view before = text_.substr(0, byte);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column = byte - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0: the first line
    std::string reason = error.what();
    // Drop the library's own prefix: "[json.exception.NAME.NUMBER] parse error at line 1, column 2: ".
    if (const auto start = reason.find("] "); start != std::string::npos) reason.erase(0, start + 2);
    if (const auto start = reason.find("syntax error"); start != std::string::npos) reason.erase(0, start);
    if (const auto quote = reason.find("; last read"); quote != std::string::npos) reason.resize(quote);
    throw Error(ErrorCode::input_invalid, file_,
                one_line(fmt::format("the JSON is not valid at its byte {} (line {}, column {}): {}", byte, line,
                                     column, reason)));
  }

 private:
  Json* place(Json&& value) {
    if (++values_ > max_values_) {
      throw Error(ErrorCode::input_invalid, file_,
                  fmt::format("the JSON has more than {} values, which is as many as load.bytes={} allows; a larger "
                              "load.bytes allows more, up to {}",
                              max_values_, max_bytes_, kMostValues));
    }
    if (open_.empty()) return &(root_ = std::move(value));
    if (open_.back()->is_array()) return &open_.back()->get_ref<Json::array_t&>().emplace_back(std::move(value));
    return &(*member_ = std::move(value));
  }

  bool add(Json&& value) {
    place(std::move(value));
    return true;
  }

  bool open(Json&& value) {
    const std::size_t depth = open_.size() + 1;
    if (!levels_.fits(depth)) {
      throw Error(ErrorCode::input_invalid, file_, "the JSON nests to a depth of " + levels_.refusal(depth));
    }
    open_.push_back(place(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  const Budget levels_;
  const std::uint64_t max_bytes_, max_values_;
  Json& root_;
  std::vector<Json*> open_;  // stable: an array grows only while none of its elements is open
  Json* member_ = nullptr;   // the value of the key read last
  std::uint64_t values_ = 0;
};

// JSON writes 3 also as 3.0; both are whole numbers to glTF's schema.
std::optional<std::uint64_t> whole_number(const Json& json) {
  if (json.is_number_unsigned()) return json.get<std::uint64_t>();
  if (!json.is_number_float()) return std::nullopt;
  const double value = json.get<double>();
  constexpr double kExact = 9007199254740992.0;  // 2^53: beyond it doubles skip integers
  if (value >= 0.0 && value <= kExact && value == std::trunc(value)) return static_cast<std::uint64_t>(value);
  return std::nullopt;
}

}  // namespace

// --- Document ---------------------------------------------------------------------------------------------------

Document::Document(std::filesystem::path file, std::string_view text, const GltfLimits& limits, bool strict)
    : file_(std::move(file)), strict_(strict), json_(std::make_unique<Json>()) {
  Builder builder(file_, text, limits, *json_);
  Json::sax_parse(text.begin(), text.end(), &builder);
}

Document::~Document() = default;

Value Document::root() {
  return {*this, json_.get()};
}

std::vector<std::string> Document::warnings() const {
  std::vector<std::string> lines;
  for (const std::string& reason : warning_order_) {
    const Warning& warning = warnings_.at(reason);
    std::string line = warning.first_place + ": " + reason;
    if (warning.count > 1) line += fmt::format(" (and {} more)", warning.count - 1);
    lines.push_back(one_line(std::move(line)));
  }
  return lines;
}

std::string Document::pointer_to(const Json& value) const {
  std::string pointer;
  find(*json_, value, pointer);
  return pointer.empty() ? "/" : pointer;
}

// --- Value ------------------------------------------------------------------------------------------------------

Value Value::operator[](std::string_view key) const {
  if (!json_) return {};
  if (!json_->is_object()) fail(fmt::format("is {}, must be an object", shown()));
  const auto& members = json_->get_ref<const Json::object_t&>();
  const auto found = members.find(key);
  return {*document_, found == members.end() ? nullptr : &found->second};
}

Value Value::require(std::string_view key) const {
  const Value member = (*this)[key];
  if (!member) fail(fmt::format("has no property '{}', which it must have", key));
  return member;
}

std::vector<std::pair<std::string_view, Value>> Value::members() const {
  std::vector<std::pair<std::string_view, Value>> list;
  if (!json_) return list;
  if (!json_->is_object()) fail(fmt::format("is {}, must be an object", shown()));
  for (const auto& [key, member] : json_->get_ref<const Json::object_t&>()) {
    list.push_back({key, {*document_, &member}});
  }
  return list;
}

std::uint32_t Value::size() const {
  if (!json_) return 0;
  if (!json_->is_array()) fail(fmt::format("is {}, must be an array", shown()));
  return static_cast<std::uint32_t>(json_->size());  // the parser's limit on values fits
}

Value Value::at(std::uint32_t index) const {
  VEL_ASSERT(index < size());
  return {*document_, &json_->get_ref<const Json::array_t&>()[index]};
}

std::vector<Value> Value::elements() const {
  std::vector<Value> list;
  const std::uint32_t count = size();
  list.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) list.push_back(at(i));
  return list;
}

std::string_view Value::text() const {
  VEL_ASSERT(json_);
  if (!json_->is_string()) fail(fmt::format("is {}, must be a string", shown()));
  return json_->get_ref<const std::string&>();
}

std::string Value::text_or(std::string_view fallback) const {
  return std::string(json_ ? text() : fallback);
}

bool Value::boolean_or(bool fallback) const {
  if (!json_) return fallback;
  if (!json_->is_boolean()) fail(fmt::format("is {}, must be true or false", shown()));
  return json_->get<bool>();
}

std::uint64_t Value::integer(std::uint64_t lowest, std::uint64_t highest) const {
  VEL_ASSERT(json_);
  const std::optional<std::uint64_t> value = whole_number(*json_);
  if (!value || *value < lowest || *value > highest) {
    fail(fmt::format("is {}, must be a whole number from {} to {}", shown(), lowest, highest));
  }
  return *value;
}

std::uint64_t Value::integer_or(std::uint64_t fallback, std::uint64_t lowest, std::uint64_t highest) const {
  return json_ ? integer(lowest, highest) : fallback;
}

float Value::number() const {
  VEL_ASSERT(json_);
  if (!json_->is_number()) fail(fmt::format("is {}, must be a number", shown()));
  const double value = json_->get<double>();
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) {
    fail(fmt::format("is {}, which exceeds a 32-bit float", shown()));
  }
  return static_cast<float>(value);
}

float Value::number_or(float fallback) const {
  return json_ ? number() : fallback;
}

double Value::double_or(double fallback) const {
  return json_ ? (static_cast<void>(number()), json_->get<double>()) : fallback;
}

float Value::clamped_or(float fallback, float lowest, float highest) const {
  if (!json_) return fallback;
  const float value = number();
  if (value >= lowest && value <= highest) return value;
  const float nearest = std::clamp(value, lowest, highest);
  repair(fmt::format("is {}, outside its range; {} is used instead", shown(), nearest));
  return nearest;
}

Value Value::extra_member(std::string_view name) const {
  const Value extras = is_object() ? (*this)["extras"] : Value();
  return extras.is_object() ? extras[name] : Value();
}

bool Value::is_object() const {
  return json_ != nullptr && json_->is_object();
}

bool Value::is_array() const {
  return json_ != nullptr && json_->is_array();
}

bool Value::is_text() const {
  return json_ != nullptr && json_->is_string();
}

bool Value::is_boolean() const {
  return json_ != nullptr && json_->is_boolean();
}

bool Value::is_number() const {
  return json_ != nullptr && json_->is_number() && std::abs(json_->get<double>()) <= std::numeric_limits<float>::max();
}

void Value::read_numbers(std::span<float> out) const {
  if (size() != out.size()) fail(fmt::format("has {} numbers, must have {}", size(), out.size()));
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = at(i).number();
}

void Value::read_numbers(std::span<double> out) const {
  if (size() != out.size()) fail(fmt::format("has {} numbers, must have {}", size(), out.size()));
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = at(i).double_or(0.0);
}

void Value::read_clamped_numbers(std::span<float> out, float lowest, float highest) const {
  if (size() != out.size()) fail(fmt::format("has {} numbers, must have {}", size(), out.size()));
  for (std::uint32_t i = 0; i < out.size(); ++i) out[i] = at(i).clamped_or(0.0f, lowest, highest);
}

std::uint32_t Value::reference(std::uint32_t table_size, std::string_view table_name) const {
  const std::uint64_t index = integer(0, std::numeric_limits<std::uint32_t>::max());
  if (index >= table_size) fail(fmt::format("is {}, but there are {} {}", index, table_size, table_name));
  return static_cast<std::uint32_t>(index);
}

std::int32_t Value::reference_or_none(std::uint32_t table_size, std::string_view table_name) const {
  return json_ ? static_cast<std::int32_t>(reference(table_size, table_name)) : kNone;
}

std::string Value::pointer() const {
  VEL_ASSERT(json_);
  return document_->pointer_to(*json_);
}

void Value::fail(const std::string& reason) const {
  throw Error(ErrorCode::input_invalid, document_->file_, one_line(pointer() + ": " + reason));
}

void Value::warn(const std::string& reason) const {
  Document::Warning& warning = document_->warnings_[reason];
  if (warning.count++ > 0) return;
  warning.first_place = pointer();
  document_->warning_order_.push_back(reason);
}

void Value::repair(const std::string& reason) const {
  if (document_->strict_) fail(reason);
  warn(reason);
}

// What the value is, for error messages: scalars as written, containers by type.
std::string Value::shown() const {
  if (json_->is_structured()) return fmt::format("an {}", json_->type_name());
  return shortened(json_->dump(-1, ' ', false, Json::error_handler_t::replace), kMaxQuoted);
}

}  // namespace velarium::scene::gltf
