// SPDX-License-Identifier: GPL-3.0-or-later
// Materials and their base colour textures.
#include <tiny_gltf.h>

#include <cmath>
#include <tuple>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

Wrap wrap_of(int code) {
  if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  return code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

struct ImageBytes {
  SharedBytes owner;
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

ImageBytes image_bytes(Source& source, int index) {
  const ImageSource& image = source.images[std::size_t(index)];
  const std::string place = at("images", std::size_t(index));
  if (image.uri) {
    const SharedBytes bytes = source.uris.read(*image.uri, place + ".uri");
    return {bytes, bytes->data(), bytes->size()};
  }
  if (image.buffer_view < 0) fail(place, "has neither a uri nor a bufferView");
  const auto& view = source.model.bufferViews[std::size_t(image.buffer_view)];
  const SharedBytes& buffer = source.buffers[std::size_t(view.buffer)];
  return {buffer, buffer->data() + view.byteOffset, view.byteLength};
}

/// Decodes each image once, and makes one Texture for each pair of image and sampler that materials use.
class TextureReader {
 public:
  TextureReader(Source& source, Scene& scene) : source_(source), scene_(scene) {}

  /// Index into scene.textures, -1 where the image is of no use; a note then says why.
  int texture(int gltf_texture) {
    const auto& texture = source_.model.textures[std::size_t(gltf_texture)];
    if (texture.source < 0) {
      source_.notes.add("gltf_image", at("textures", std::size_t(gltf_texture)) +
                                          " names no PNG or JPEG image; its materials are "
                                          "drawn without it.");
      return -1;
    }
    const auto key = sampler_key(texture.sampler, texture.source);
    if (const auto found = made_.find(key); found != made_.end()) return found->second;
    return made_[key] = make(key);
  }

 private:
  using Key = std::tuple<int, Wrap, Wrap, bool>;
  Source& source_;
  Scene& scene_;
  std::map<Key, int> made_;
  std::map<int, int> texture_of_image_;  // the first texture of an image has its pixels; -1: it does not decode

  Key sampler_key(int sampler, int image) const {
    if (sampler < 0) return {image, Wrap::repeat, Wrap::repeat, false};
    const auto& s = source_.model.samplers[std::size_t(sampler)];
    return {image, wrap_of(s.wrapS), wrap_of(s.wrapT), s.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST};
  }

  int make(const Key& key) {
    const auto& [image, wrap_u, wrap_v, nearest] = key;
    const auto known = texture_of_image_.find(image);
    Texture texture;
    if (known == texture_of_image_.end()) {
      texture_of_image_[image] = decode(image, texture) ? int(scene_.textures.size()) : -1;
    } else if (known->second >= 0) {
      texture = scene_.textures[std::size_t(known->second)];
      source_.budget.add_pixels(texture.rgba.size() / 4, at("images", std::size_t(image)));
    }
    if (texture_of_image_[image] < 0) return -1;
    texture.wrap_u = wrap_u;
    texture.wrap_v = wrap_v;
    texture.nearest = nearest;
    scene_.textures.push_back(std::move(texture));
    return int(scene_.textures.size()) - 1;
  }

  /// A missing or broken image costs its texture, not the scene.
  bool decode(int image, Texture& texture) {
    std::string reason;
    try {
      const ImageBytes bytes = image_bytes(source_, image);
      if (const auto size = image_size(bytes.data, bytes.size, reason)) {
        source_.budget.add_pixels(std::uint64_t(size->width) * std::uint64_t(size->height), at("images", std::size_t(image)));
        auto pixels = decode_image(bytes.data, bytes.size, reason);
        if (pixels) texture = {size->width, size->height, std::move(*pixels), Wrap::repeat, Wrap::repeat, false};
      }
    } catch (const Problem& problem) {
      reason = problem.text;
    }
    if (reason.empty()) return true;
    source_.notes.add("gltf_image", at("images", std::size_t(image)) + " is left out: " + reason + ".");
    return false;
  }
};

double number_or(const tinygltf::Value& object, const char* key, double otherwise) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : otherwise;
}

glm::dvec2 pair_or(const tinygltf::Value& object, const char* key, const glm::dvec2& otherwise) {
  if (!object.Has(key)) return otherwise;
  const tinygltf::Value& pair = object.Get(key);
  return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

/// KHR_texture_transform: translation * rotation * scale. The texture frame has v pointing down, and positive angles turn
/// counter-clockwise to the eye (the extension says so in words; its older listing had the other sign).
glm::dmat3 uv_from_texcoord(const tinygltf::Value& transform) {
  const glm::dvec2 offset = pair_or(transform, "offset", glm::dvec2(0.0)), scale = pair_or(transform, "scale", glm::dvec2(1.0));
  const double angle = number_or(transform, "rotation", 0.0), c = std::cos(angle), s = std::sin(angle);
  return {glm::dvec3(c * scale.x, -s * scale.x, 0.0), glm::dvec3(s * scale.y, c * scale.y, 0.0), glm::dvec3(offset, 1.0)};
}

TexcoordSource texcoord_source(const tinygltf::TextureInfo& info) {
  TexcoordSource source{info.texCoord, std::nullopt};
  const auto extension = info.extensions.find("KHR_texture_transform");
  if (extension == info.extensions.end()) return source;
  source.set = int(number_or(extension->second, "texCoord", source.set));
  source.uv_from_texcoord = uv_from_texcoord(extension->second);
  return source;
}

float cutoff_of(const tinygltf::Material& material, bool textured, Notes& notes) {
  if (material.alphaMode == "MASK") return float(std::min(material.alphaCutoff, 2.0));
  if (material.alphaMode != "BLEND") return 0.0f;
  notes.add("gltf_alpha_blend", textured ? "Blended materials are drawn as cut-outs: what is less than half opaque is left out."
                                         : "Blended materials without a texture are drawn opaque.");
  return textured ? 0.5f : 0.0f;
}

Material material_of(const tinygltf::Material& in, int texture, Notes& notes) {
  Material material;
  const auto& color = in.pbrMetallicRoughness.baseColorFactor;
  for (int i = 0; i < 4; ++i) material.base_color[i] = float(color[std::size_t(i)]);
  material.texture = texture;
  material.alpha_cutoff = cutoff_of(in, texture >= 0, notes);
  material.double_sided = in.doubleSided;
  return material;
}

}  // namespace

std::vector<TexcoordSource> read_materials(Source& source, Scene& scene) {
  TextureReader textures(source, scene);
  std::vector<TexcoordSource> texcoords;
  for (const auto& material : source.model.materials) {
    const auto& info = material.pbrMetallicRoughness.baseColorTexture;
    const int texture = info.index >= 0 ? textures.texture(info.index) : -1;
    texcoords.push_back(texcoord_source(info));
    scene.materials.push_back(material_of(material, texture, source.notes));
  }
  Material standard;
  standard.base_color = glm::vec4(1.0f);
  scene.materials.push_back(standard);
  texcoords.push_back({});
  return texcoords;
}

}  // namespace psm::gltf
