// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON of a glTF file, checked before tinygltf sees it. What comes out is written anew from checked members alone, so that
// neither tinygltf nor the rest of the reader meets a wrong type, an index out of range or a deeply nested "extras".
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

using nlohmann::json;

constexpr double kLargestWhole = 9007199254740991.0;  // 2^53 - 1: what JSON numbers hold exactly
constexpr double kAnyNumber = 1.7976931348623157e308;
const std::vector<std::string> kSupportedExtensions = {"KHR_lights_punctual", "KHR_materials_unlit", "KHR_mesh_quantization",
                                                       "KHR_texture_transform"};

enum class Need { optional, required };

std::string number_text(double x) {
  if (x == std::floor(x) && std::abs(x) <= kLargestWhole) return std::to_string(std::int64_t(x));
  return json(x).dump();
}

/// A value as a message shows it. Never goes into arrays and objects, which may be nested without end.
std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  return printable(value.dump(-1, ' ', true, json::error_handler_t::replace));
}

const json* find(const json& object, const char* key) {
  const auto it = object.find(key);
  return it == object.end() ? nullptr : &*it;
}

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const auto& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

/// One JSON object: `in` as read, `out` as far as checked.
struct Level {
  const json& in;
  std::string place;
  json out = json::object();

  Level(const json& object, std::string where) : in(object), place(std::move(where)) {
    if (!in.is_object()) fail(place, "is " + shown(in) + "; an object is needed");
  }
  std::string path(const std::string& key) const { return place.empty() ? printable(key) : place + "." + printable(key); }

  const json* value(const char* key, Need need) const {
    const json* found = find(in, key);
    if (!found && need == Need::required) fail(place.empty() ? "the file" : place, std::string("has no member \"") + key + "\"");
    return found;
  }

  void number(const char* key, double min, double max, Need need = Need::optional) {
    if (const json* found = value(key, need)) out[key] = number_in(*found, path(key), min, max);
  }
  void whole(const char* key, double min, double max, Need need = Need::optional) {
    if (const json* found = value(key, need)) out[key] = whole_in(*found, path(key), min, max);
  }
  void index(const char* key, std::size_t count, const char* of, Need need = Need::optional) {
    if (const json* found = value(key, need)) out[key] = index_in(*found, path(key), count, of);
  }
  void flag(const char* key) {
    const json* found = value(key, Need::optional);
    if (!found) return;
    if (!found->is_boolean()) fail(path(key), "is " + shown(*found) + "; true or false is needed");
    out[key] = *found;
  }
  void text(const char* key, Need need = Need::optional) {
    const json* found = value(key, need);
    if (!found) return;
    if (!found->is_string()) fail(path(key), "is " + shown(*found) + "; a text is needed");
    out[key] = *found;
  }
  void choice(const char* key, const std::vector<std::string>& allowed, Need need = Need::optional) {
    text(key, need);
    if (out.contains(key) && std::find(allowed.begin(), allowed.end(), out[key]) == allowed.end())
      fail(path(key), "is " + shown(out[key]) + "; allowed are " + joined(allowed));
  }
  void code(const char* key, const std::vector<int>& allowed, Need need = Need::optional) {
    whole(key, 0, kLargestWhole, need);
    if (!out.contains(key) || std::find(allowed.begin(), allowed.end(), out[key]) != allowed.end()) return;
    std::vector<std::string> names;
    for (const int c : allowed) names.push_back(std::to_string(c));
    fail(path(key), "is " + shown(out[key]) + "; allowed are " + joined(names));
  }
  void numbers(const char* key, std::size_t count, double min = -kAnyNumber, double max = kAnyNumber) {
    const json* found = value(key, Need::optional);
    if (!found) return;
    if (!found->is_array() || found->size() != count)
      fail(path(key), "is " + shown(*found) + "; an array of " + std::to_string(count) + " numbers is needed");
    json list = json::array();
    for (std::size_t i = 0; i < count; ++i) list.push_back(number_in((*found)[i], at(path(key), i), min, max));
    out[key] = std::move(list);
  }
  void indices(const char* key, std::size_t count, const char* of, Need need = Need::optional) {
    const json* found = value(key, need);
    if (!found) return;
    if (!found->is_array()) fail(path(key), "is " + shown(*found) + "; an array of indices is needed");
    json list = json::array();
    for (std::size_t i = 0; i < found->size(); ++i) list.push_back(index_in((*found)[i], at(path(key), i), count, of));
    out[key] = std::move(list);
  }
  /// A member that is an object, checked by `check`.
  template <class Check>
  void object(const char* key, Check check, Need need = Need::optional) {
    const json* found = value(key, need);
    if (!found) return;
    Level inner(*found, path(key));
    check(inner);
    out[key] = std::move(inner.out);
  }
  /// A member that is an array of objects.
  template <class Check>
  void objects(const char* key, Check check, Need need = Need::optional) {
    const json* found = value(key, need);
    if (!found) return;
    if (!found->is_array()) fail(path(key), "is " + shown(*found) + "; an array is needed");
    json list = json::array();
    for (std::size_t i = 0; i < found->size(); ++i) {
      Level inner((*found)[i], at(path(key), i));
      check(inner);
      list.push_back(std::move(inner.out));
    }
    out[key] = std::move(list);
  }

 private:
  static double number_in(const json& value, const std::string& place, double min, double max) {
    if (!value.is_number()) fail(place, "is " + shown(value) + "; a number is needed");
    const double x = value.get<double>();
    if (!(x >= min && x <= max))
      fail(place, "is " + shown(value) + "; allowed are " + number_text(min) + " to " + number_text(max));
    return x;
  }
  static std::uint64_t whole_in(const json& value, const std::string& place, double min, double max) {
    const bool is_whole = value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    if (!is_whole) fail(place, "is " + shown(value) + "; a whole number is needed");
    return std::uint64_t(number_in(value, place, min, max));
  }
  static std::uint64_t index_in(const json& value, const std::string& place, std::size_t count, const char* of) {
    if (count == 0) fail(place, "is " + shown(value) + ", but the file has no " + of);
    const bool in_range = value.is_number() && value.get<double>() >= 0 && value.get<double>() < double(count);
    if (value.is_number() && !in_range)
      fail(place, "is " + shown(value) + "; allowed are 0 to " + std::to_string(count - 1) + " (" + of + ")");
    return whole_in(value, place, 0, double(count - 1));
  }
};

std::size_t array_size(const json& object, const char* key) {
  const json* found = find(object, key);
  return found && found->is_array() ? found->size() : 0;
}

const json* lights_of(const json& root) {
  const json* extensions = find(root, "extensions");
  const json* lights = extensions && extensions->is_object() ? find(*extensions, "KHR_lights_punctual") : nullptr;
  return lights && lights->is_object() ? lights : nullptr;
}

class DocumentCheck {
 public:
  explicit DocumentCheck(const json& root) : file_(root, "") {}

  CheckedDocument run() {
    check_version();
    check_required_extensions();
    check_buffers_and_images();
    check_accessors_json();
    check_materials();
    file_.objects("meshes", [&](Level& mesh) { check_mesh(mesh); });
    file_.objects("nodes", [&](Level& node) { check_node(node); });
    check_skins_and_scenes();
    check_cameras();
    check_lights();
    document_.animated = array_size(file_.in, "animations") > 0;
    document_.json = file_.out.dump();
    return std::move(document_);
  }

 private:
  Level file_;
  CheckedDocument document_;

  std::size_t count(const char* array) const { return array_size(file_.in, array); }

  void check_version() {
    file_.object(
        "asset",
        [](Level& asset) {
          asset.text("version", Need::required);
          const std::string version = asset.out["version"];
          if (version.rfind("2.", 0) != 0) fail("asset.version", "is " + shown(asset.out["version"]) + "; only glTF 2 is read");
          asset.text("minVersion");
          if (asset.out.contains("minVersion") && asset.out["minVersion"] != "2.0")
            fail("asset.minVersion", "is " + shown(asset.out["minVersion"]) + "; what needs more than glTF 2.0 is not read");
        },
        Need::required);
  }

  void check_required_extensions() {
    const json* required = find(file_.in, "extensionsRequired");
    if (!required) return;
    if (!required->is_array()) fail("extensionsRequired", "is " + shown(*required) + "; an array of texts is needed");
    for (const json& name : *required) {
      if (!name.is_string()) fail("extensionsRequired", "holds " + shown(name) + "; texts are needed");
      if (std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), name.get<std::string>()) ==
          kSupportedExtensions.end())
        fail("extensionsRequired",
             "names " + shown(name) + ", which psmlab does not read; it reads " + joined(kSupportedExtensions));
    }
  }

  void check_buffers_and_images() {
    file_.objects("buffers", [&](Level& buffer) {
      buffer.whole("byteLength", 1, kLargestWhole, Need::required);
      buffer.text("uri");
      document_.buffers.push_back({buffer.out["byteLength"], uri_of(buffer)});
    });
    file_.objects("bufferViews", [&](Level& view) {
      view.index("buffer", count("buffers"), "buffers", Need::required);
      view.whole("byteOffset", 0, kLargestWhole);
      view.whole("byteLength", 1, kLargestWhole, Need::required);
      view.whole("byteStride", 4, 252);
      if (view.out.contains("byteStride") && std::uint64_t(view.out["byteStride"]) % 4 != 0)
        fail(view.path("byteStride"), "is " + shown(view.out["byteStride"]) + "; allowed are multiples of 4");
    });
    file_.objects("images", [&](Level& image) {
      image.text("uri");
      image.index("bufferView", count("bufferViews"), "bufferViews");
      document_.images.push_back({uri_of(image), image.out.value("bufferView", -1)});
    });
    file_.out.erase("buffers");
    file_.out.erase("images");
  }

  static std::optional<std::string> uri_of(const Level& level) {
    const json* uri = find(level.out, "uri");
    return uri ? std::optional(uri->get<std::string>()) : std::nullopt;
  }

  void check_accessors_json() {
    const std::size_t views = count("bufferViews");
    file_.objects("accessors", [&](Level& accessor) {
      accessor.index("bufferView", views, "bufferViews");
      accessor.whole("byteOffset", 0, kLargestWhole);
      accessor.code("componentType", {5120, 5121, 5122, 5123, 5125, 5126}, Need::required);
      accessor.whole("count", 1, kLargestWhole, Need::required);
      accessor.choice("type", {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}, Need::required);
      accessor.flag("normalized");
      accessor.object("sparse", [&](Level& sparse) { check_sparse(sparse, views); });
    });
  }

  static void check_sparse(Level& sparse, std::size_t views) {
    sparse.whole("count", 1, 2147483647.0, Need::required);
    const auto part = [views](Level& level) {
      level.index("bufferView", views, "bufferViews", Need::required);
      level.whole("byteOffset", 0, 2147483647.0);
    };
    sparse.object(
        "indices",
        [&](Level& indices) {
          part(indices);
          indices.code("componentType", {5121, 5123, 5125}, Need::required);
        },
        Need::required);
    sparse.object("values", part, Need::required);
  }

  void check_materials() {
    file_.objects("samplers", [](Level& sampler) {
      sampler.code("magFilter", {9728, 9729});
      sampler.code("wrapS", {10497, 33071, 33648});
      sampler.code("wrapT", {10497, 33071, 33648});
    });
    file_.objects("textures", [&](Level& texture) {
      texture.index("sampler", count("samplers"), "samplers");
      texture.index("source", count("images"), "images");
    });
    file_.objects("materials", [&](Level& material) {
      material.text("name");
      material.choice("alphaMode", {"OPAQUE", "MASK", "BLEND"});
      material.number("alphaCutoff", 0, kAnyNumber);
      material.flag("doubleSided");
      material.object("pbrMetallicRoughness", [&](Level& pbr) {
        pbr.numbers("baseColorFactor", 4, 0, 1);
        pbr.object("baseColorTexture", [&](Level& info) { check_texture_info(info); });
      });
    });
  }

  void check_texture_info(Level& info) {
    info.index("index", count("textures"), "textures", Need::required);
    info.whole("texCoord", 0, 255);
    info.object("extensions", [](Level& extensions) {
      extensions.object("KHR_texture_transform", [](Level& transform) {
        transform.numbers("offset", 2, -kLargestCoordinate, kLargestCoordinate);
        transform.numbers("scale", 2, -kLargestCoordinate, kLargestCoordinate);
        transform.number("rotation", -kLargestCoordinate, kLargestCoordinate);
        transform.whole("texCoord", 0, 255);
      });
    });
  }

  void check_mesh(Level& mesh) {
    mesh.text("name");
    mesh.objects(
        "primitives", [&](Level& primitive) { check_primitive(primitive); }, Need::required);
  }

  void check_primitive(Level& primitive) {
    const std::size_t accessors = count("accessors");
    const auto attributes = [&](Level& level) {
      for (const auto& [key, value] : level.in.items()) level.index(key.c_str(), accessors, "accessors");
    };
    primitive.object("attributes", attributes, Need::required);
    primitive.objects("targets", attributes);
    primitive.index("material", count("materials"), "materials");
    primitive.code("mode", {0, 1, 2, 3, 4, 5, 6});
    primitive.index("indices", accessors, "accessors");
    const json* indices = find(primitive.out, "indices");
    if (indices && !file_.out["accessors"][indices->get<std::size_t>()].contains("bufferView"))
      fail(primitive.path("indices"), "is " + shown(*indices) + ", but that accessor has no bufferView");
  }

  void check_node(Level& node) {
    node.text("name");
    node.indices("children", count("nodes"), "nodes");
    node.index("mesh", count("meshes"), "meshes");
    node.index("skin", count("skins"), "skins");
    node.index("camera", count("cameras"), "cameras");
    node.numbers("matrix", 16);
    node.numbers("translation", 3);
    node.numbers("rotation", 4);
    node.numbers("scale", 3);
    const json* lights = lights_of(file_.in);
    const std::size_t light_count = lights ? array_size(*lights, "lights") : 0;
    node.object("extensions", [&](Level& extensions) {
      extensions.object("KHR_lights_punctual",
                        [&](Level& light) { light.index("light", light_count, "lights", Need::required); });
    });
  }

  void check_skins_and_scenes() {
    const std::size_t nodes = count("nodes");
    file_.objects("skins", [&](Level& skin) {
      skin.indices("joints", nodes, "nodes", Need::required);
      skin.index("inverseBindMatrices", count("accessors"), "accessors");
    });
    file_.objects("scenes", [&](Level& scene) { scene.indices("nodes", nodes, "nodes"); });
    file_.index("scene", count("scenes"), "scenes");
  }

  void check_cameras() {
    const double smallest = 1e-300;
    file_.objects("cameras", [&](Level& camera) {
      camera.choice("type", {"perspective", "orthographic"}, Need::required);
      if (camera.out["type"] == "orthographic") return void(camera.out["orthographic"] = no_view());
      camera.object(
          "perspective",
          [&](Level& view) {
            view.number("yfov", 1e-6, 3.1415, Need::required);
            view.number("znear", smallest, kLargestCoordinate, Need::required);
            view.number("zfar", smallest, kAnyNumber);
            if (view.out.contains("zfar") && !(double(view.out["zfar"]) > double(view.out["znear"])))
              fail(view.path("zfar"),
                   "is " + shown(view.out["zfar"]) + "; it must be more than znear, " + shown(view.out["znear"]));
          },
          Need::required);
    });
  }

  /// What tinygltf wants to see; orthographic cameras are passed over.
  static json no_view() { return {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.0}, {"zfar", 1.0}}; }

  void check_lights() {
    const json* lights = lights_of(file_.in);
    if (!lights) return;
    Level extension(*lights, "extensions.KHR_lights_punctual");
    extension.objects("lights", [](Level& light) {
      light.choice("type", {"directional", "point", "spot"}, Need::required);
      if (light.out["type"] != "spot") return;
      light.object(
          "spot", [](Level& spot) { spot.number("outerConeAngle", 1e-6, 1.5707963267949); }, Need::required);
    });
    file_.out["extensions"]["KHR_lights_punctual"] = std::move(extension.out);
  }
};

/// Where a byte stands, for people.
std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte ? byte - 1 : 0, text.size());
  const auto stop = text.begin() + std::ptrdiff_t(end);
  const std::size_t newline = end ? text.rfind('\n', end - 1) : std::string::npos;
  const std::size_t column = newline == std::string::npos ? end : end - newline - 1;
  return "line " + std::to_string(1 + std::count(text.begin(), stop, '\n')) + ", column " + std::to_string(column + 1);
}

json parsed(const std::string& text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw Problem{"is not JSON (a .gltf is JSON, a .glb starts with \"glTF\"): syntax error in " +
                  line_and_column(text, error.byte)};
  } catch (const json::exception&) {
    throw Problem{"is not usable JSON: it holds a number beyond the range of double"};
  }
}

}  // namespace

CheckedDocument check_document(const std::string& json_text) {
  const json root = parsed(json_text);
  if (!root.is_object()) throw Problem{"is not glTF: its JSON is " + shown(root) + ", an object is needed"};
  return DocumentCheck(root).run();
}

}  // namespace psm::gltf
