#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace velarium {

// Why something in the world (a file, a device, an argument) stopped the work.
// The values are the exit codes of the command line.
enum class ErrorCode : int {
  comparison_differs = 1,  // two pictures differ by more than was allowed
  usage = 2,               // an argument or option is wrong
  input_missing = 3,       // a file does not exist or cannot be opened
  input_invalid = 4,       // a file is malformed, or exceeds a limit
  unsupported = 5,         // a required feature or extension is not supported
  no_device = 6,           // no Vulkan loader, or no device that can render
  output_not_written = 7,  // a result could not be written
  internal = 70,           // a defect of Velarium itself
  temporary = 75,          // device lost or out of memory: trying again may help
};

// Thrown by the library for faults of the world, never for its own.
// `what()` is one line: "FILE: reason", or the reason alone where no file is at fault.
// The reason names the place in the file (a JSON pointer, a byte offset) and what to do, where either is known.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& reason) : std::runtime_error(reason), code_(code) {}
  Error(ErrorCode code, const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason), code_(code), file_(file) {}

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

 private:
  ErrorCode code_;
  std::filesystem::path file_;
};

}  // namespace velarium
