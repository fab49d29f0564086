#include "gpu/image.hpp"

#include "core/assert.hpp"
#include "gpu/check.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace velarium::gpu {
namespace {

constexpr VkImageUsageFlags kDrawnTo =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

VkImageAspectFlags sampled_aspect(VkFormat format) {
  return has_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

}  // namespace

std::uint32_t full_mip_count(std::uint32_t width, std::uint32_t height, std::uint32_t depth) {
  return static_cast<std::uint32_t>(std::bit_width(std::max({width, height, depth})));
}

VkExtent3D mip_extent(const ImageDesc& desc, std::uint32_t mip) {
  return {std::max(desc.width >> mip, 1u), std::max(desc.height >> mip, 1u), std::max(desc.depth >> mip, 1u)};
}

bool has_depth(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D32_SFLOAT_S8_UINT || format == VK_FORMAT_D16_UNORM;
}

bool has_stencil(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

VkImageAspectFlags aspects(VkFormat format) {
  VkImageAspectFlags flags = has_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  if (has_stencil(format)) flags |= VK_IMAGE_ASPECT_STENCIL_BIT;
  return flags;
}

bool can_be_linear(const Device& device, const ImageDesc& desc, VkImageUsageFlags usage) {
  VkImageFormatProperties most{};
  const VkResult result = vkGetPhysicalDeviceImageFormatProperties(device.physical(), desc.format, VK_IMAGE_TYPE_2D,
                                                                   VK_IMAGE_TILING_LINEAR, usage, 0, &most);
  VkFormatProperties format{};
  vkGetPhysicalDeviceFormatProperties(device.physical(), desc.format, &format);
  constexpr VkFormatFeatureFlags kFiltered = VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  return result == VK_SUCCESS && (format.linearTilingFeatures & kFiltered) != 0 && desc.depth == 1 &&
         desc.mips <= most.maxMipLevels && desc.layers <= most.maxArrayLayers && desc.width <= most.maxExtent.width &&
         desc.height <= most.maxExtent.height;
}

Image::Image(Device& device, const ImageDesc& desc, VkImageUsageFlags usage, Tiling tiling)
    : layout(tiling == Tiling::linear ? VK_IMAGE_LAYOUT_PREINITIALIZED : VK_IMAGE_LAYOUT_UNDEFINED),
      device_(&device),
      desc_(desc),
      usage_(usage) {
  VEL_ASSERT(desc.depth == 1 || (desc.layers == 1 && !desc.array && (usage & kDrawnTo) == 0));
  create(tiling);
  make_views();
}

void Image::create(Tiling tiling) {
  const bool linear = tiling == Tiling::linear;
  const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                               .flags = desc_.cube ? VkImageCreateFlags{VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT} : 0u,
                               .imageType = desc_.depth > 1 ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
                               .format = desc_.format,
                               .extent = {desc_.width, desc_.height, desc_.depth},
                               .mipLevels = desc_.mips,
                               .arrayLayers = desc_.layers,
                               .samples = VK_SAMPLE_COUNT_1_BIT,
                               .tiling = linear ? VK_IMAGE_TILING_LINEAR : VK_IMAGE_TILING_OPTIMAL,
                               .usage = usage_,
                               .initialLayout = layout};
  check(vkCreateImage(device_->vk(), &info, nullptr, &image_), "vkCreateImage");
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device_->vk(), image_, &needs);
  allocation_ = device_->memory().allocate(needs, linear ? MemoryUse::upload : MemoryUse::device, linear);
  check(vkBindImageMemory(device_->vk(), image_, allocation_.memory, allocation_.offset), "vkBindImageMemory");
}

void Image::make_views() {
  const auto& desc = desc_;
  const bool array = desc.array || desc.layers > 1;
  const VkImageViewType two_d = array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
  const VkImageViewType stored = desc.depth > 1 ? VK_IMAGE_VIEW_TYPE_3D : two_d;
  const VkImageViewType type = desc.cube ? VK_IMAGE_VIEW_TYPE_CUBE : stored;
  const auto whole = [&](VkImageAspectFlags aspect) { return make_view(type, aspect, 0, desc.mips, 0, desc.layers); };
  view_ = whole(aspects(desc.format));
  const bool sampled = (usage_ & VK_IMAGE_USAGE_SAMPLED_BIT) != 0, drawn = (usage_ & kDrawnTo) != 0,
             stores = (usage_ & VK_IMAGE_USAGE_STORAGE_BIT) != 0;
  if (sampled && has_depth(desc.format)) depth_view_ = whole(VK_IMAGE_ASPECT_DEPTH_BIT);
  if (sampled && has_stencil(desc.format)) stencil_view_ = whole(VK_IMAGE_ASPECT_STENCIL_BIT);
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
    if (stores) mip_views_.push_back(make_view(stored, VK_IMAGE_ASPECT_COLOR_BIT, mip, 1, 0, desc.layers));
    if (sampled && desc.mips > 1 && (stores || drawn))
      sampled_mip_views_.push_back(make_view(type, sampled_aspect(desc.format), mip, 1, 0, desc.layers));
    if (!drawn || (desc.layers == 1 && desc.mips == 1)) continue;
    for (std::uint32_t layer = 0; layer < desc.layers; ++layer)
      layer_views_.push_back(make_view(VK_IMAGE_VIEW_TYPE_2D, aspects(desc.format), mip, 1, layer, 1));
  }
}

VkImageView Image::sampled_view(std::uint32_t mip) const {
  if (mip != kAllMips && desc_.mips > 1) return sampled_mip_views_[mip];
  return has_depth(desc_.format) ? depth_view_ : view_;
}

Image::~Image() {
  if (image_ == VK_NULL_HANDLE) return;
  for (const VkImageView view : {view_, depth_view_, stencil_view_}) vkDestroyImageView(device_->vk(), view, nullptr);
  for (const auto* views : {&mip_views_, &sampled_mip_views_, &layer_views_})
    for (const VkImageView view : *views) vkDestroyImageView(device_->vk(), view, nullptr);
  vkDestroyImage(device_->vk(), image_, nullptr);
  device_->memory().free(allocation_);
}

Image::Image(Image&& other) noexcept
    : layout(other.layout),
      device_(other.device_),
      desc_(other.desc_),
      usage_(other.usage_),
      image_(std::exchange(other.image_, VK_NULL_HANDLE)),
      allocation_(other.allocation_),
      view_(other.view_),
      depth_view_(other.depth_view_),
      stencil_view_(other.stencil_view_),
      mip_views_(std::move(other.mip_views_)),
      sampled_mip_views_(std::move(other.sampled_mip_views_)),
      layer_views_(std::move(other.layer_views_)) {}

Image& Image::operator=(Image&& other) noexcept {
  Image moved(std::move(other));
  std::swap(layout, moved.layout);
  std::swap(device_, moved.device_);
  std::swap(desc_, moved.desc_);
  std::swap(usage_, moved.usage_);
  std::swap(image_, moved.image_);
  std::swap(allocation_, moved.allocation_);
  std::swap(view_, moved.view_);
  std::swap(depth_view_, moved.depth_view_);
  std::swap(stencil_view_, moved.stencil_view_);
  std::swap(mip_views_, moved.mip_views_);
  std::swap(sampled_mip_views_, moved.sampled_mip_views_);
  std::swap(layer_views_, moved.layer_views_);
  return *this;
}

Image::MappedRows Image::mapped_rows(std::uint32_t mip) const {
  VEL_ASSERT(allocation_.mapped != nullptr);
  const VkImageSubresource subresource{VK_IMAGE_ASPECT_COLOR_BIT, mip, 0};
  VkSubresourceLayout place{};
  vkGetImageSubresourceLayout(device_->vk(), image_, &subresource, &place);
  return {allocation_.mapped + place.offset, static_cast<std::size_t>(place.rowPitch)};
}

VkImageView Image::make_view(VkImageViewType type, VkImageAspectFlags aspect, std::uint32_t mip, std::uint32_t mips,
                             std::uint32_t layer, std::uint32_t layers) const {
  const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                   .image = image_,
                                   .viewType = type,
                                   .format = desc_.format,
                                   .subresourceRange = {aspect, mip, mips, layer, layers}};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(device_->vk(), &info, nullptr, &view), "vkCreateImageView");
  return view;
}

}  // namespace velarium::gpu
