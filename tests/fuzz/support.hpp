#pragma once

#include "support/temporary_folder.hpp"
#include "targets.hpp"

#include <velarium/error.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace velarium::fuzz {

// Runs `body`; an Error that blames the world is what it is there for.
template <class Body>
void expect_orderly(const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
  }
}

inline std::string_view text_of(Bytes input) {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

// An input whose first bytes are a Description of how to read the others.
template <class Description>
struct Described {
  Description description;
  std::vector<std::byte> data;  // a copy, so that reading past its end is seen
};

// None where no data is left.
template <class Description>
std::optional<Described<Description>> described(Bytes input) {
  static_assert(alignof(Description) == 1, "any bytes are one");
  if (input.size() <= sizeof(Description)) return std::nullopt;
  Described<Description> result{{}, {input.begin() + sizeof(Description), input.end()}};
  std::memcpy(&result.description, input.data(), sizeof(Description));
  return result;
}

// A folder with one file of the input in it, gone at the end of the program. In memory where the system has a place
// for that, because a fuzzer writes thousands of files a second.
class InputFile {
 public:
  explicit InputFile(const char* name) : folder_(fast_place()), file_(folder_.path() / name) {}

  const std::filesystem::path& write(Bytes input) const {
    std::ofstream(file_, std::ios::binary) << text_of(input);
    return file_;
  }

 private:
  static std::filesystem::path fast_place() {
    const std::filesystem::path memory = "/dev/shm";
    return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_;
};

}  // namespace velarium::fuzz
