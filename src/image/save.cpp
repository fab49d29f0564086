#include "image/codecs.hpp"

#include "core/files.hpp"

namespace velarium::image {

namespace fs = std::filesystem;

void save_png(const fs::path& file, const ByteImage& image, const Attributes& attributes) {
  write_file(file, write_png(image, file.string(), attributes));
}
void save_png(const fs::path& file, const WordImage& image, const Attributes& attributes) {
  write_file(file, write_png(image, file.string(), attributes));
}
void save_jpeg(const fs::path& file, const ByteImage& image, int quality) {
  write_file(file, write_jpeg(image, quality, file.string()));
}
void save_webp(const fs::path& file, const ByteImage& image, int quality) {
  write_file(file, write_webp(image, quality, file.string()));
}
void save_exr(const fs::path& file, const FloatImage& image, bool half) {
  write_file(file, write_exr(image, half, file.string()));
}
void save_hdr(const fs::path& file, const FloatImage& image) {
  write_file(file, write_hdr(image));
}

}  // namespace velarium::image
