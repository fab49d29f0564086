#include "image/codecs.hpp"
#include "image/exr_output.hpp"

#include "core/assert.hpp"
#include "core/files.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <algorithm>

namespace velarium::image {
namespace {

Imf::Header header_of(const ExrPart& part, Size size, const Attributes& attributes) {
  Imf::Header header(static_cast<int>(size.width), static_cast<int>(size.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  header.setName(part.name);
  header.setType(Imf::SCANLINEIMAGE);
  for (const std::string& channel : part.channels)
    header.channels().insert(channel, Imf::Channel(part.half ? Imf::HALF : Imf::FLOAT));
  for (const auto& [name, text] : attributes) header.insert(name, Imf::StringAttribute(text));
  return header;
}

template <class Value>
void write_pixels(Imf::OutputPart& to, const ExrPart& part, const std::vector<Value>& values, Imf::PixelType type,
                  Size size) {
  Imf::FrameBuffer source;
  const std::size_t pixel = part.channels.size() * sizeof(Value);
  for (std::size_t c = 0; c < part.channels.size(); ++c) {
    // A slice has no constant form; an output only reads through it.
    auto* base = reinterpret_cast<char*>(const_cast<Value*>(values.data() + c));
    source.insert(part.channels[c], Imf::Slice(type, base, pixel, pixel * size.width));
  }
  to.setFrameBuffer(source);
  to.writePixels(static_cast<int>(size.height));
}

void write_part(Imf::MultiPartOutputFile& file, int number, const ExrPart& part, Size size) {
  Imf::OutputPart to(file, number);
  if (!part.half) return write_pixels(to, part, part.values, Imf::FLOAT, size);
  static constexpr auto kLargest = static_cast<float>(HALF_MAX);
  std::vector<half> halves(part.values.size());
  std::transform(part.values.begin(), part.values.end(), halves.begin(),
                 [](float value) { return half(std::clamp(value, -kLargest, kLargest)); });
  write_pixels(to, part, halves, Imf::HALF, size);
}

}  // namespace

void save_exr_parts(const std::filesystem::path& file, Size size, std::span<const ExrPart> parts,
                    const Attributes& attributes) {
  const std::string what = file.string();
  std::vector<Imf::Header> headers;
  for (const ExrPart& part : parts) {
    VEL_ASSERT(part.values.size() == part.channels.size() * std::size_t{size.width} * size.height);
    headers.push_back(header_of(part, size, attributes));
  }
  MemoryOutput stream(what);
  try {
    Imf::MultiPartOutputFile out(stream, headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) write_part(out, static_cast<int>(i), parts[i], size);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::output_not_written, what, fmt::format("OpenEXR: {}", error.what()));
  }
  write_file(file, stream.take());
}

}  // namespace velarium::image
