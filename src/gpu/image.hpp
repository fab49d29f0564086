#pragma once

#include "gpu/device.hpp"

#include <vector>

namespace velarium::gpu {

struct ImageDesc {
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t width = 1, height = 1, layers = 1, mips = 1;
  bool cube = false;   // layers is then a multiple of 6
  bool array = false;  // an array to shaders even where it has one layer
  bool operator==(const ImageDesc&) const = default;
};

// Linear: rows as the host would lay them out, in memory that is mapped. For CPU drivers, which read it as fast.
enum class Tiling { optimal, linear };

// Can this device make such an image with linear tiling?
[[nodiscard]] bool can_be_linear(const Device& device, const ImageDesc& desc, VkImageUsageFlags usage);

// Full length of a mip chain.
[[nodiscard]] std::uint32_t full_mip_count(std::uint32_t width, std::uint32_t height);

[[nodiscard]] bool has_depth(VkFormat format);
[[nodiscard]] bool has_stencil(VkFormat format);

// All aspects of the format.
[[nodiscard]] VkImageAspectFlags aspects(VkFormat format);

// An image, its memory and its views. Moves, never copies.
class Image {
 public:
  Image() = default;
  // Precondition of linear tiling: can_be_linear(), and one layer. Its layout begins as PREINITIALIZED.
  Image(Device& device, const ImageDesc& desc, VkImageUsageFlags usage, Tiling tiling = Tiling::optimal);
  ~Image();
  Image(Image&& other) noexcept;
  Image& operator=(Image&& other) noexcept;

  [[nodiscard]] VkImage vk() const { return image_; }
  [[nodiscard]] const ImageDesc& desc() const { return desc_; }
  [[nodiscard]] VkImageUsageFlags usage() const { return usage_; }
  // Of device memory, 0 of none.
  [[nodiscard]] std::uint64_t bytes() const { return image_ != VK_NULL_HANDLE ? allocation_.size : 0; }
  [[nodiscard]] explicit operator bool() const { return image_ != VK_NULL_HANDLE; }

  // Every mip and layer: colour, or depth and stencil, to draw to; the depth of a depth image where it is sampled.
  [[nodiscard]] VkImageView view() const { return view_; }
  [[nodiscard]] VkImageView depth_view() const { return depth_view_; }
  [[nodiscard]] VkImageView stencil_view() const { return stencil_view_; }
  // The layout in which the last work left every mip and layer. Whoever records work keeps it true.
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;

  // One mip as a 2-D array of all layers, to store to.
  [[nodiscard]] VkImageView mip_view(std::uint32_t mip) const { return mip_views_[mip]; }
  // One layer of the full size, all aspects, to draw to. Images that are attachments have them.
  [[nodiscard]] VkImageView layer_view(std::uint32_t layer) const {
    return desc_.layers > 1 ? layer_views_[layer] : view_;
  }

  // Where the host finds a mip of a linear image.
  struct MappedRows {
    std::byte* first;
    std::size_t pitch;  // bytes from one row to the next
  };
  [[nodiscard]] MappedRows mapped_rows(std::uint32_t mip) const;

 private:
  [[nodiscard]] VkImageView make_view(VkImageViewType type, VkImageAspectFlags aspect, std::uint32_t mip,
                                      std::uint32_t mips, std::uint32_t layer, std::uint32_t layers) const;
  Device* device_ = nullptr;
  ImageDesc desc_;
  VkImageUsageFlags usage_ = 0;
  VkImage image_ = VK_NULL_HANDLE;
  Allocation allocation_;
  VkImageView view_ = VK_NULL_HANDLE, depth_view_ = VK_NULL_HANDLE, stencil_view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> mip_views_;    // empty where the image is never stored to
  std::vector<VkImageView> layer_views_;  // empty where the image has one layer, or is never drawn to
};

}  // namespace velarium::gpu
