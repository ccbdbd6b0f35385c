// SPDX-License-Identifier: GPL-3.0-or-later
// Accessors: checked against their buffer views once, then read without further checks.
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

std::size_t component_size(int type) { return std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(type))); }

std::size_t component_count(const tinygltf::Accessor& accessor) {
  return std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
}

/// Columns of small matrices start at multiples of four bytes; such accessors are not read here, so that they only need a bound.
std::size_t element_size(const tinygltf::Accessor& accessor) {
  return component_size(accessor.componentType) * component_count(accessor);
}

std::string range_text(std::uint64_t offset, std::uint64_t size) {
  return "bytes " + std::to_string(offset) + " to " + std::to_string(offset + size - 1);
}

void check_views(const Source& source) {
  for (std::size_t i = 0; i < source.model.bufferViews.size(); ++i) {
    const auto& view = source.model.bufferViews[i];
    const std::uint64_t size = source.buffers[std::size_t(view.buffer)]->size();
    if (view.byteLength > size || view.byteOffset > size - view.byteLength)
      fail(at("bufferViews", i), "takes " + range_text(view.byteOffset, view.byteLength) + "; " +
                                     at("buffers", std::size_t(view.buffer)) + " has " + std::to_string(size) + " bytes");
  }
}

/// `count` elements of `size` bytes, `stride` apart, from `offset` on.
void check_within_view(const Source& source, int view_index, std::uint64_t offset, std::uint64_t count, std::uint64_t size,
                       std::uint64_t stride, const std::string& place) {
  const std::uint64_t available = source.model.bufferViews[std::size_t(view_index)].byteLength;
  const bool fits = offset <= available && size <= available - offset && (count - 1) <= (available - offset - size) / stride;
  if (!fits)
    fail(place, "needs " + std::to_string(count) + " elements of " + std::to_string(size) + " bytes from byte " +
                    std::to_string(offset) + " on; " + at("bufferViews", std::size_t(view_index)) + " has " +
                    std::to_string(available) + " bytes");
}

std::size_t stride_of(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  const std::size_t stride = model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
  return stride ? stride : element_size(accessor);
}

void check_sparse(const Source& source, const tinygltf::Accessor& accessor, const std::string& place) {
  const auto& sparse = accessor.sparse;
  if (std::uint64_t(sparse.count) > accessor.count)
    fail(place + ".sparse.count", "is " + std::to_string(sparse.count) + "; allowed are 1 to " + std::to_string(accessor.count));
  const std::size_t index_size = component_size(sparse.indices.componentType), value_size = element_size(accessor);
  check_within_view(source, sparse.indices.bufferView, std::uint64_t(sparse.indices.byteOffset), std::uint64_t(sparse.count),
                    index_size, index_size, place + ".sparse.indices");
  check_within_view(source, sparse.values.bufferView, std::uint64_t(sparse.values.byteOffset), std::uint64_t(sparse.count),
                    value_size, value_size, place + ".sparse.values");
}

/// Zeros take no bytes in the file, so that a short file could ask for any number of them.
void check_zeros(const Source& source, const tinygltf::Accessor& accessor, const std::string& place) {
  std::uint64_t limit = 65536;
  for (const auto& buffer : source.buffers) limit += buffer->size();
  if (accessor.count > limit)
    fail(place + ".count",
         "is " + std::to_string(accessor.count) + " without a bufferView; allowed are up to " + std::to_string(limit));
}

const std::uint8_t* view_bytes(const Source& source, int view_index, std::size_t offset) {
  const auto& view = source.model.bufferViews[std::size_t(view_index)];
  return source.buffers[std::size_t(view.buffer)]->data() + view.byteOffset + offset;
}

template <class T>
T load(const std::uint8_t* p) {
  T value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

double load_component(const std::uint8_t* p, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return load<std::int8_t>(p);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *p;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return load<std::int16_t>(p);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(p);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(p);
    default:
      return load<float>(p);
  }
}

/// glTF 2.0, section 3.6.2.2: what an integer component is divided by.
double normalization(const tinygltf::Accessor& accessor) {
  if (!accessor.normalized) return 1.0;
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255.0;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535.0;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return 4294967295.0;
    default:
      return 1.0;
  }
}

void load_element(const std::uint8_t* p, const tinygltf::Accessor& accessor, double* out) {
  const std::size_t size = component_size(accessor.componentType), n = component_count(accessor);
  const double divisor = normalization(accessor);
  for (std::size_t c = 0; c < n; ++c) {
    const double value = load_component(p + c * size, accessor.componentType) / divisor;
    out[c] = divisor > 1.0 ? std::max(value, -1.0) : value;  // -128 / 127 counts as -1
  }
}

void put_sparse_values(const Source& source, int index, std::vector<double>& values) {
  const auto& accessor = source.model.accessors[std::size_t(index)];
  const auto& sparse = accessor.sparse;
  const std::uint8_t* indices = view_bytes(source, sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset));
  const std::uint8_t* elements = view_bytes(source, sparse.values.bufferView, std::size_t(sparse.values.byteOffset));
  const std::size_t index_size = component_size(sparse.indices.componentType);
  for (std::size_t i = 0; i < std::size_t(sparse.count); ++i) {
    const auto target = std::size_t(load_component(indices + i * index_size, sparse.indices.componentType));
    if (target >= accessor.count)
      fail(at("accessors", std::size_t(index)) + ".sparse.indices",
           "holds " + std::to_string(target) + "; allowed are 0 to " + std::to_string(accessor.count - 1));
    load_element(elements + i * element_size(accessor), accessor, &values[target * component_count(accessor)]);
  }
}

std::string format_of(const tinygltf::Accessor& accessor) {
  static const std::map<int, const char*> types = {
      {TINYGLTF_TYPE_SCALAR, "SCALAR"}, {TINYGLTF_TYPE_VEC2, "VEC2"}, {TINYGLTF_TYPE_VEC3, "VEC3"}, {TINYGLTF_TYPE_VEC4, "VEC4"},
      {TINYGLTF_TYPE_MAT2, "MAT2"},     {TINYGLTF_TYPE_MAT3, "MAT3"}, {TINYGLTF_TYPE_MAT4, "MAT4"}};
  static const std::map<int, const char*> components = {
      {TINYGLTF_COMPONENT_TYPE_BYTE, "BYTE"},   {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, "UNSIGNED_BYTE"},
      {TINYGLTF_COMPONENT_TYPE_SHORT, "SHORT"}, {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, "UNSIGNED_SHORT"},
      {TINYGLTF_COMPONENT_TYPE_FLOAT, "FLOAT"}, {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, "UNSIGNED_INT"}};
  const bool integer = accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT;
  return std::string(types.at(accessor.type)) + " " + components.at(accessor.componentType) +
         (accessor.normalized && integer ? " normalized" : "");
}

}  // namespace

void check_accessors(const Source& source) {
  check_views(source);
  for (std::size_t i = 0; i < source.model.accessors.size(); ++i) {
    const auto& accessor = source.model.accessors[i];
    const std::string place = at("accessors", i);
    if (accessor.bufferView < 0) {
      check_zeros(source, accessor, place);
    } else {
      const std::size_t size = element_size(accessor), stride = stride_of(source.model, accessor);
      if (stride < size)
        fail(place, "has elements of " + std::to_string(size) + " bytes, more than the byteStride of its bufferView, " +
                        std::to_string(stride));
      check_within_view(source, accessor.bufferView, accessor.byteOffset, accessor.count, size, stride, place);
    }
    if (accessor.sparse.isSparse) check_sparse(source, accessor, place);
  }
}

std::size_t accessor_count(const Source& source, int accessor) { return source.model.accessors[std::size_t(accessor)].count; }

void require_format(const Source& source, int accessor, const std::string& place, const std::vector<std::string>& allowed) {
  const std::string format = format_of(source.model.accessors[std::size_t(accessor)]);
  if (std::find(allowed.begin(), allowed.end(), format) != allowed.end()) return;
  std::string names;
  for (const auto& name : allowed) names += (names.empty() ? "" : ", ") + name;
  fail(place, "is " + at("accessors", std::size_t(accessor)) + " of " + format + "; allowed are " + names);
}

std::vector<double> read_numbers(const Source& source, int index) {
  const auto& accessor = source.model.accessors[std::size_t(index)];
  const std::size_t components = component_count(accessor);
  std::vector<double> values(accessor.count * components, 0.0);
  if (accessor.bufferView >= 0) {
    const std::uint8_t* bytes = view_bytes(source, accessor.bufferView, accessor.byteOffset);
    const std::size_t stride = stride_of(source.model, accessor);
    for (std::size_t i = 0; i < accessor.count; ++i) load_element(bytes + i * stride, accessor, &values[i * components]);
  }
  if (accessor.sparse.isSparse) put_sparse_values(source, index, values);
  return values;
}

std::vector<std::uint32_t> read_indices(const Source& source, int index) {
  const auto& accessor = source.model.accessors[std::size_t(index)];
  if (accessor.sparse.isSparse) {
    const std::vector<double> numbers = read_numbers(source, index);  // exact: 32 bits fit a double
    return std::vector<std::uint32_t>(numbers.begin(), numbers.end());
  }
  const std::uint8_t* bytes = view_bytes(source, accessor.bufferView, accessor.byteOffset);
  const std::size_t stride = stride_of(source.model, accessor);
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = std::uint32_t(load_component(bytes + i * stride, accessor.componentType));
  return indices;
}

}  // namespace psm::gltf
