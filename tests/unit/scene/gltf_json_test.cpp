#include "gltf_model.hpp"
#include "scene/gltf_json.hpp"

namespace velarium::scene::test {
namespace {

using gltf::Document;
using gltf::Value;

void refuse(const std::string& text, const std::string& part, const GltfLimits& limits = {}) {
  expect_error(ErrorCode::input_invalid, part, [&] { Document document("file", text, limits); });
}

void refuse_value(const std::string& text, const std::string& part, const std::function<void(const Value&)>& use) {
  Document document("file", text, {});
  expect_error(ErrorCode::input_invalid, "file: " + part, [&] { use(document.root()["a"]); });
}

TEST(GltfJson, SyntaxErrorsNameByteLineAndColumn) {
  refuse("{\n  \"a\": ]\n}", "at its byte 9 (line 2, column 8)");
  refuse("{\"a\": 1", "at its byte 7");
  refuse("{\"a\": tru}", "syntax error");
  refuse("{\"a\": 1e999}", "number overflow");
}

TEST(GltfJson, InvalidUtf8IsRefused) {
  refuse("{\"a\": \"\xff\xfe\"}", "invalid");
}

TEST(GltfJson, DepthIsBounded) {
  const auto nested = [](std::size_t levels) {
    return "{\"a\":" + std::string(levels - 1, '[') + std::string(levels - 1, ']') + "}";
  };
  EXPECT_NO_THROW(Document("file", nested(8), {.depth = 8}));
  refuse(nested(9), "the JSON nests to a depth of 9 levels, more than load.depth=8 allows", {.depth = 8});
  refuse("{\"a\":" + std::string(1'000'000, '['), "load.depth=256");
}

// Values of the text {"a":[0,...,0]} besides the elements: the object and the array.
TEST(GltfJson, ValuesTogetherAreBounded) {
  const auto zeros = [](std::size_t count) {
    std::string text = "{\"a\":[0";
    for (std::size_t i = 1; i < count; ++i) text += ",0";
    return text + "]}";
  };
  constexpr std::size_t kAlways = 1 << 16;
  EXPECT_NO_THROW(Document("file", zeros(kAlways - 2), {.bytes = 1}));
  refuse(zeros(kAlways - 1), "has more than 65536 values, which is as many as load.bytes=1 allows", {.bytes = 1});
  constexpr std::uint64_t kBytes = 160 * 100'000;
  EXPECT_NO_THROW(Document("file", zeros(100'000 - 2), {.bytes = kBytes}));
  refuse(zeros(100'000 - 1), "has more than 100000 values", {.bytes = kBytes});
}

TEST(GltfJson, DuplicateKeysAreRefusedByPointer) {
  refuse(R"({"a": [{"b": 1, "b": 2}]})", "/a/0/b: ");
}

TEST(GltfJson, PointersEscapeTheirTokens) {
  Document document("file", R"({"a": {"x~y/z": [1, {"q": true}]}})", {});
  EXPECT_EQ(document.root()["a"]["x~y/z"].at(1)["q"].pointer(), "/a/x~0y~1z/1/q");
  EXPECT_EQ(document.root().pointer(), "/");
}

TEST(GltfJson, WholeNumbersAreStrict) {
  const auto integer = [](const Value& value) { static_cast<void>(value.integer(1, 10)); };
  for (const char* wrong :
       {"0", "11", "-1", "1.5", "\"3\"", "null", "true", "[]", "{}", "1e20", "18446744073709551616"}) {
    refuse_value(std::string("{\"a\": ") + wrong + "}", "/a: is ", integer);
  }
  Document document("file", R"({"a": 3.0, "b": 10})", {});
  EXPECT_EQ(document.root()["a"].integer(1, 10), 3u);  // the same JSON number as 3
  EXPECT_EQ(document.root()["b"].integer(1, 10), 10u);
}

TEST(GltfJson, NumbersFitFloats) {
  refuse_value(R"({"a": 1e300})", "/a: is 1e+300", [](const Value& value) { static_cast<void>(value.number()); });
  refuse_value(R"({"a": "1"})", "/a: is \"1\", must be a number",
               [](const Value& value) { static_cast<void>(value.number()); });
}

TEST(GltfJson, VectorsHaveTheirLength) {
  const auto vector = [](const Value& value) { static_cast<void>(value.vector_or(glm::vec3(0.0f))); };
  refuse_value(R"({"a": [1, 2]})", "/a: has 2 numbers, must have 3", vector);
  refuse_value(R"({"a": [1, 2, "x"]})", "/a/2: ", vector);
  refuse_value(R"({"a": 1})", "/a: is 1, must be an array", vector);
}

TEST(GltfJson, OtherTypesAreStrict) {
  refuse_value(R"({"a": 1})", "/a: is 1, must be a string",
               [](const Value& value) { static_cast<void>(value.text()); });
  refuse_value(R"({"a": 1})", "/a: is 1, must be true or false",
               [](const Value& value) { static_cast<void>(value.boolean_or(false)); });
  refuse_value(R"({"a": []})", "/a: is an array, must be an object",
               [](const Value& value) { static_cast<void>(value["b"]); });
  refuse_value(R"({"a": {}})", "/a: has no property 'b'",
               [](const Value& value) { static_cast<void>(value.require("b")); });
}

TEST(GltfJson, WarningsOfOneReasonAreCounted) {
  Document document("file", R"({"a": [2, 3, 2], "b": 2})", {});
  for (const Value& value : document.root()["a"].elements()) static_cast<void>(value.clamped_or(0.0f, 0.0f, 1.0f));
  document.root()["b"].warn("is odd");
  EXPECT_EQ(document.warnings(),
            (std::vector<std::string>{"/a/0: is 2, outside its range; 1 is used instead (and 1 more)",
                                      "/a/1: is 3, outside its range; 1 is used instead", "/b: is odd"}));
}

TEST(GltfJson, MessagesAreShortAndHoldNoControls) {
  const std::string longest(100'000, 'x');
  try {
    Document document("file", "{\"a\": \"\\n\\u001b[2J" + longest + "\"}", {});
    static_cast<void>(document.root()["a"].number());
    FAIL();
  } catch (const Error& error) {
    EXPECT_LT(std::string_view(error.what()).size(), 700u);
    EXPECT_EQ(std::string_view(error.what()).find('\x1b'), std::string_view::npos);
  }
}

}  // namespace
}  // namespace velarium::scene::test
