#include "core/budget.hpp"
#include "core/jobs.hpp"
#include "image/image.hpp"
#include "scene/gltf_parts.hpp"
#include "scene/gltf_uri.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace velarium::scene::gltf {

namespace {

// Marks the materials that primitives under the roots of the shown scene have.
std::vector<bool> materials_in_use(const Scene& scene) {
  std::vector<bool> used(scene.materials.size(), false);
  std::vector<std::uint32_t> open = scene.roots;
  while (!open.empty()) {
    const Node& node = scene.nodes[open.back()];
    open.pop_back();
    open.insert(open.end(), node.children.begin(), node.children.end());
    if (node.mesh == kNone) continue;
    for (const std::uint32_t primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      const std::int32_t material = scene.primitives[primitive].material;
      if (material != kNone) used[static_cast<std::size_t>(material)] = true;
    }
  }
  return used;
}

std::vector<bool> textures_in_use(const Scene& scene) {
  const std::vector<bool> materials = materials_in_use(scene);
  std::vector<bool> used(scene.textures.size(), false);
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (!materials[i]) continue;
    for (const TextureRef* ref : texture_refs(scene.materials[i])) {
      if (ref->present()) used[static_cast<std::size_t>(ref->texture)] = true;
    }
  }
  return used;
}

// The encoded bytes of an image: a view, or its own copy of what its URI names.
struct Source {
  Value image;
  std::uint32_t index = 0;          // in /images
  std::optional<float> glossiness;  // the factor, where it is read as roughness
  std::optional<UriData> named;
  bool missing = false;
  std::vector<std::byte> owned;
  std::span<const std::byte> bytes;
};

// Checks one element of /images, whether used or not.
void check_image(const Value& image, const Buffers& buffers) {
  const Value uri = image["uri"], view = image["bufferView"];
  if (static_cast<bool>(uri) == static_cast<bool>(view)) image.fail("must have either uri or bufferView");
  if (view) static_cast<void>(buffers.view(view));
  if (uri) static_cast<void>(uri.text());
}

// A file that is not there is missing where the reader is not strict.
void find_named(Source& source, const GltfOptions& options, Budget& bytes) {
  try {
    source.named = find_uri(source.image["uri"], options, bytes);
  } catch (const Error& error) {
    if (options.strict || error.code() != ErrorCode::input_missing) throw;
    source.missing = true;
  }
}

// All of them before any is read, so that the limit on all together holds whatever thread reads which.
void find_sources(std::vector<Source>& sources, const Buffers& buffers, const GltfOptions& options) {
  Budget bytes("load.bytes", options.limits.bytes);
  for (Source& source : sources) {
    if (const Value reference = source.image["bufferView"]) {
      const BufferView& view = buffers.view(reference);
      if (!view.data) reference.fail("lies in a buffer without data");
      source.bytes = {view.data, view.length};
    } else {
      find_named(source, options, bytes);
    }
  }
}

// The texture slots of a material, in the order of texture_refs().
constexpr std::array<std::string_view, 7> kSlots = {
    "baseColorTexture", "metallicRoughnessTexture", "normalTexture",       "occlusionTexture",
    "emissiveTexture",  "specularTexture",          "specularColorTexture"};

// "baseColorTexture of /materials/2 and 3 more", of what shows an image; empty where nothing does.
std::string uses_of(const Scene& scene, std::int32_t image) {
  std::string first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const auto refs = texture_refs(scene.materials[i]);
    for (std::size_t slot = 0; slot < refs.size(); ++slot) {
      if (!refs[slot]->present() || scene.textures[static_cast<std::size_t>(refs[slot]->texture)].image != image)
        continue;
      if (count++ == 0) first = fmt::format("{} of /materials/{}", kSlots[slot], i);
    }
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].projector.image == image && count++ == 0) first = fmt::format("the picture of light {}", i);
  return count > 1 ? fmt::format("{} and {} more", first, count - 1) : first;
}

// Scenes are drawn without what is missing: a factor alone, no bumps, a light without its picture.
void leave_out_missing(Scene& scene, const std::vector<Source>& sources) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!sources[i].missing) continue;
    const auto image = static_cast<std::int32_t>(i);
    const Value uri = sources[i].image["uri"];
    uri.warn(fmt::format("'{}' does not exist; {} is left out", uri.text(), uses_of(scene, image)));
    for (Material& material : scene.materials)
      for (TextureRef* ref : texture_refs(material))
        if (ref->present() && scene.textures[static_cast<std::size_t>(ref->texture)].image == image)
          ref->texture = kNone;
    for (Texture& texture : scene.textures)
      if (texture.image == image) texture.image = kNone;
    for (Light& light : scene.lights)
      if (light.projector.image == image) light.projector.image = kNone;
  }
}

void read_source(Source& source) {
  if (!source.named) return;
  source.owned = read_uri(*source.named);
  source.bytes = source.owned;
}

// Calls `work` and gives errors of the image library the scene's file and this image's place in it.
template <class Work>
auto at_image(const Source& source, const Work& work) {
  const Value uri = source.image["uri"];
  const bool named = uri && !is_data_uri(uri.text());
  const std::string what = fmt::format("/images/{}", source.index) + (named ? fmt::format(" ({})", uri.text()) : "");
  try {
    return work(what);
  } catch (const Error& error) { throw Error(error.code(), source.image.file(), error.what()); }
}

// The table of decoded images as it is put together.
struct Table {
  Value images;  // of the file
  std::map<std::pair<std::uint32_t, std::optional<float>>, std::int32_t> places{};
  std::vector<Source> sources{};

  // The place of an image of the file, read as it is or as roughness.
  std::int32_t place_of(std::int32_t image, std::optional<float> glossiness) {
    const auto index = static_cast<std::uint32_t>(image);
    const auto [place, added] = places.emplace(std::pair(index, glossiness), static_cast<std::int32_t>(sources.size()));
    if (added) sources.push_back({images.at(index), index, glossiness, {}, {}, {}});
    return place->second;
  }
};

void assign_textures(Context& context, Table& table) {
  Scene& scene = context.scene;
  const std::vector<bool> used = textures_in_use(scene);
  const std::uint32_t texture_count = context.root["textures"].size();
  for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
    std::int32_t& image = scene.textures[i].image;
    if (!used[i]) {
      image = kNone;
      continue;
    }
    const bool own = i >= texture_count;
    if (image == kNone && own) continue;  // the texture that it was made of has the warning
    if (image == kNone) {
      context.root["textures"].at(i).warn("has no image that can be read; it is white");
      continue;
    }
    image = table.place_of(image, own ? std::optional(context.glossiness_factors[i - texture_count]) : std::nullopt);
  }
}

// Points textures and lights at the table of decoded images, and lists the sources of those images in its order.
std::vector<Source> assign_images(Context& context, const Buffers& buffers) {
  Table table{context.root["images"]};
  for (const Value& image : table.images.elements()) check_image(image, buffers);
  assign_textures(context, table);
  for (Light& light : context.scene.lights)
    if (light.projector.present()) light.projector.image = table.place_of(light.projector.image, std::nullopt);
  return std::move(table.sources);
}

void check_sizes(const std::vector<Source>& sources, const GltfLimits& limits) {
  const Budget sides("load.image_size", limits.image_size);
  Budget pixels("load.pixels", limits.pixels);
  for (const Source& source : sources) {
    if (source.missing) continue;
    const image::Size size =
        at_image(source, [&](const std::string& what) { return image::peek_size(source.bytes, what); });
    const std::uint32_t side = std::max(size.width, size.height);
    if (!sides.fits(side)) {
      source.image.fail(fmt::format("is {} x {}: a side of {}", size.width, size.height, sides.refusal(side)));
    }
    const std::uint64_t area = std::uint64_t{size.width} * size.height;
    if (!pixels.fits(area)) {
      source.image.fail(
          fmt::format("is {} x {}: with it, the scene shows {}", size.width, size.height, pixels.refusal(area)));
    }
    pixels.spend(area);
  }
}

}  // namespace

void read_images(Context& context, const Buffers& buffers) {
  const GltfLimits& limits = context.options.limits;
  std::vector<Source> sources = assign_images(context, buffers);
  find_sources(sources, buffers, context.options);
  leave_out_missing(context.scene, sources);
  parallel_for(sources.size(), [&](std::size_t i) { read_source(sources[i]); });
  check_sizes(sources, limits);
  context.scene.images.assign(sources.size(), {.name = "", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}});
  parallel_for(sources.size(), [&](std::size_t i) {
    if (sources[i].missing) return;
    image::ByteImage decoded = at_image(sources[i], [&](const std::string& what) {
      return image::decode(sources[i].bytes, what, {limits.pixels, static_cast<std::uint32_t>(limits.image_size)});
    });
    sources[i].owned = {};
    Image& image = context.scene.images[i];
    image.name = sources[i].image["name"].text_or("");
    image.width = decoded.width;
    image.height = decoded.height;
    image.rgba = std::move(decoded.rgba);
    if (sources[i].glossiness) glossiness_to_roughness(*sources[i].glossiness, image.rgba);
  });
}

}  // namespace velarium::scene::gltf
