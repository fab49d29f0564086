#pragma once

#include <ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace velarium::image {

// OpenEXR writes into memory, so that files appear whole or not at all.
class MemoryOutput final : public Imf::OStream {
 public:
  explicit MemoryOutput(const std::string& what) : OStream(what.c_str()) {}

  void write(const char from[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    if (end > data_.size()) data_.resize(end);
    std::memcpy(data_.data() + position_, from, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(data_); }

 private:
  std::vector<std::byte> data_;
  std::uint64_t position_ = 0;
};

}  // namespace velarium::image
