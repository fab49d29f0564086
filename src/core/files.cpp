#include "core/files.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace velarium {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return number_; }
  // Late write errors (a full quota, a network file system) are reported by close.
  [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

// The temporary files of this process that are not yet in their place.
class Unfinished {
 public:
  void add(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.insert(name);
  }
  void forget(const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.erase(name);
  }
  void remove_all() {
    const std::lock_guard lock(mutex_);
    for (const std::string& name : names_) ::unlink(name.c_str());
    names_.clear();
  }

 private:
  std::mutex mutex_;
  std::set<std::string> names_;
};

Unfinished& unfinished() {
  static Unfinished instance;
  return instance;
}

[[noreturn]] void not_written(const fs::path& file, const std::string& why) {
  throw Error(ErrorCode::output_not_written, file, "cannot be written: " + why);
}

void write_all(int descriptor, const fs::path& file, std::span<const std::byte> data) {
  while (!data.empty()) {
    const ssize_t written = ::write(descriptor, data.data(), data.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) not_written(file, reason(errno));
    data = data.subspan(static_cast<std::size_t>(written));
  }
}

// A new file beside the final one, removed unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& final_name) : final_name_(final_name) {
    static std::atomic<unsigned> serial{0};
    name_ = (final_name.parent_path() / fmt::format(".velarium-{}-{}.tmp", ::getpid(), serial++)).string();
    unfinished().add(name_);
  }
  ~Temporary() {
    if (!placed_) ::unlink(name_.c_str());
    unfinished().forget(name_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void write(std::span<const std::byte> data) const {
    Descriptor out(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.get() < 0) not_written(final_name_, reason(errno));
    write_all(out.get(), final_name_, data);
    if (!out.close()) not_written(final_name_, reason(errno));
  }

  void place() {
    if (::rename(name_.c_str(), final_name_.c_str()) != 0) not_written(final_name_, reason(errno));
    placed_ = true;
  }

 private:
  fs::path final_name_;
  std::string name_;
  bool placed_ = false;
};

bool written_in_place(const fs::file_status& status) {
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_in_place(const fs::path& file, std::span<const std::byte> data) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.get() < 0) not_written(file, reason(errno));
  write_all(out.get(), file, data);
  if (!out.close()) not_written(file, reason(errno));
}

// The file that a chain of symbolic links leads to, so that renaming replaces the file and not the link.
fs::path behind_links(const fs::path& file) {
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(file, ignored)) ? fs::weakly_canonical(file, ignored) : file;
}

// `refusal` ends a sentence about a file of so many bytes, or of that many at least.
std::vector<std::byte> read_at_most(const fs::path& file, std::uint64_t max_bytes,
                                    const std::function<std::string(std::uint64_t)>& refusal) {
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) {
    throw Error(ErrorCode::input_missing, file, "cannot be opened: " + reason(errno));
  }
  if (S_ISDIR(status.st_mode)) throw Error(ErrorCode::input_missing, file, "is a directory");

  const bool has_size = S_ISREG(status.st_mode);
  const auto check = [&](std::uint64_t bytes) {
    if (bytes > max_bytes) throw Error(ErrorCode::input_invalid, file, "is " + refusal(bytes));
  };
  if (has_size) check(static_cast<std::uint64_t>(status.st_size));

  // One byte more than the size, so that the end of a file that does not grow is seen without growing the buffer.
  constexpr std::size_t kPipeBytes = 1 << 16;
  std::vector<std::byte> data(has_size ? static_cast<std::size_t>(status.st_size) + 1 : kPipeBytes);
  std::size_t size = 0;
  while (true) {
    const ssize_t got = ::read(in.get(), data.data() + size, data.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error(ErrorCode::input_missing, file, "cannot be read: " + reason(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    check(size);
    if (size == data.size()) data.resize(2 * data.size());
  }
  data.resize(size);
  return data;
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& file, std::uint64_t max_bytes) {
  return read_at_most(file, max_bytes, [&](std::uint64_t bytes) {
    return fmt::format("{} bytes, more than the limit of {}", bytes, max_bytes);
  });
}

std::vector<std::byte> read_file(const fs::path& file, const Budget& budget) {
  return read_at_most(file, budget.left(), [&](std::uint64_t bytes) { return budget.refusal(bytes); });
}

void write_file(const fs::path& file, std::span<const std::byte> data) {
  check_writable(file);
  const fs::path target = behind_links(file);
  std::error_code ignored;
  if (written_in_place(fs::status(target, ignored))) return write_in_place(target, data);
  Temporary temporary(target);
  temporary.write(data);
  temporary.place();
}

void write_text(const fs::path& file, std::string_view text) {
  write_file(file, std::as_bytes(std::span(text)));
}

void check_writable(const fs::path& file) {
  if (file.empty()) throw Error(ErrorCode::output_not_written, "the name of the file to write is empty");
  const fs::path target = behind_links(file);
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) not_written(file, "it is a directory");
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) not_written(file, reason(errno));
  if (written_in_place(status)) return;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    not_written(file, fmt::format("there is no folder '{}'", folder.string()));
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    not_written(file, fmt::format("the folder '{}': {}", folder.string(), reason(errno)));
  }
}

void remove_unfinished_files() noexcept {
  unfinished().remove_all();
}

fs::path cache_directory() {
  // The XDG base directory specification: an unset or empty variable means its default; a relative one is ignored.
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) return fs::path(cache) / "velarium";
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home != '\0') return fs::path(home) / ".cache" / "velarium";
  return {};
}

std::uint64_t content_hash(std::span<const std::byte> data, std::uint64_t seed) {
  constexpr std::uint64_t kFnvPrime = 0x100000001b3ull;  // of 64-bit FNV-1a
  std::uint64_t hash = seed;
  for (const std::byte byte : data) hash = (hash ^ static_cast<std::uint64_t>(byte)) * kFnvPrime;
  return hash;
}

}  // namespace velarium
