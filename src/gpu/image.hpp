#pragma once

#include "gpu/device.hpp"

#include <vector>

namespace velarium::gpu {

struct ImageDesc {
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t width = 1, height = 1;
  std::uint32_t depth = 1;  // more than 1: a 3-D image, which has one layer and is never drawn to
  std::uint32_t layers = 1, mips = 1;
  bool cube = false;   // layers is then a multiple of 6
  bool array = false;  // an array to shaders even where it has one layer
  bool operator==(const ImageDesc&) const = default;
};

// Linear: rows as the host would lay them out, in memory that is mapped. For CPU drivers, which read it as fast.
enum class Tiling { optimal, linear };

// Can this device make such an image with linear tiling?
[[nodiscard]] bool can_be_linear(const Device& device, const ImageDesc& desc, VkImageUsageFlags usage);

// Full length of a mip chain.
[[nodiscard]] std::uint32_t full_mip_count(std::uint32_t width, std::uint32_t height, std::uint32_t depth = 1);

// Texels of one mip along x, y and z.
[[nodiscard]] VkExtent3D mip_extent(const ImageDesc& desc, std::uint32_t mip);

// In the place of a mip: every mip there is.
inline constexpr std::uint32_t kAllMips = VK_REMAINING_MIP_LEVELS;

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
  // What a shader samples: the depth of a depth image, the colour of any other; every mip, or one of an image whose
  // mips a pass can write (it has more than one, and is stored to or drawn to).
  [[nodiscard]] VkImageView sampled_view(std::uint32_t mip = kAllMips) const;
  // The layout in which the last work left every mip and layer. Whoever records work keeps it true.
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;

  // One mip, to store to: as a 3-D image, or as a 2-D array of all layers.
  [[nodiscard]] VkImageView mip_view(std::uint32_t mip) const { return mip_views_[mip]; }
  // One layer of one mip, all aspects, to draw to. Images that are attachments have them.
  [[nodiscard]] VkImageView layer_view(std::uint32_t layer, std::uint32_t mip = 0) const {
    return layer_views_.empty() ? view_ : layer_views_[std::size_t{mip} * desc_.layers + layer];
  }

  // Where the host finds a mip of a linear image.
  struct MappedRows {
    std::byte* first;
    std::size_t pitch;  // bytes from one row to the next
  };
  [[nodiscard]] MappedRows mapped_rows(std::uint32_t mip) const;

 private:
  void create(Tiling tiling);
  void make_views();
  [[nodiscard]] VkImageView make_view(VkImageViewType type, VkImageAspectFlags aspect, std::uint32_t mip,
                                      std::uint32_t mips, std::uint32_t layer, std::uint32_t layers) const;
  Device* device_ = nullptr;
  ImageDesc desc_;
  VkImageUsageFlags usage_ = 0;
  VkImage image_ = VK_NULL_HANDLE;
  Allocation allocation_;
  VkImageView view_ = VK_NULL_HANDLE, depth_view_ = VK_NULL_HANDLE, stencil_view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> mip_views_;          // empty where the image is never stored to
  std::vector<VkImageView> sampled_mip_views_;  // empty where it has one mip, or no pass writes it
  std::vector<VkImageView> layer_views_;        // empty where view_ serves, or the image is never drawn to
};

}  // namespace velarium::gpu
