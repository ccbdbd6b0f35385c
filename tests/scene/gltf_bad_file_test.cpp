// SPDX-License-Identifier: GPL-3.0-or-later
// Bad glTF files: one line that names the file, the place, what is wrong and what is allowed; never a crash, a hang or an
// allocation that the file's size does not justify.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "gltf_test_support.h"

namespace psm {
namespace {

using nlohmann::json;
using test::TempFolder;
using testing::HasSubstr;

std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) bits = bits << 8 | (i + j < bytes.size() ? std::uint8_t(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) out += i + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return out;
}

std::string as_bytes(const std::vector<float>& values) {
  std::string out(values.size() * sizeof(float), '\0');
  std::memcpy(out.data(), values.data(), out.size());
  return out;
}

std::string data_uri(const std::string& bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

/// One triangle: positions in bytes 0 to 35, indices 0, 1, 2 as bytes 36 to 38, the tail up to 44 zero.
json triangle(const std::vector<float>& positions = {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
  json doc = json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}, {"name": "spare"}, {"name": "spare"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8}],
    "buffers": [{"byteLength": 44}]})");
  doc["buffers"][0]["uri"] = data_uri(as_bytes(positions) + std::string("\0\1\2\0\0\0\0\0", 8));
  return doc;
}

/// The message for a file with these bytes; it must be one line that starts with the file's name.
std::string error_for_bytes(const std::string& name, const std::string& bytes) {
  const TempFolder folder;
  const auto file = folder.write(name, bytes);
  const Result<Scene> scene = read_gltf(file);
  if (scene) return "no error";
  const std::string& text = scene.error().text;
  EXPECT_EQ(text.rfind(file.string() + ": ", 0), 0u) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_LT(text.size(), 600u) << text;
  for (const char c : text) EXPECT_TRUE(c >= 0x20 && c < 0x7F) << text;
  return text.substr(file.string().size() + 2);
}

std::string error_for(const json& doc) { return error_for_bytes("bad.gltf", doc.dump()); }

TEST(GltfBad, TheBaseFileIsGood) { EXPECT_EQ(error_for(triangle()), "no error"); }

struct Case {
  const char* pointer;   // where the good file is changed
  const char* value;     // to this JSON; "" removes it
  const char* expected;  // part of the message
};

class OneMember : public testing::TestWithParam<Case> {};

TEST_P(OneMember, IsRefusedByPlace) {
  json doc = triangle();
  const json::json_pointer pointer(GetParam().pointer);
  if (*GetParam().value == '\0')
    doc = doc.patch(json::array({{{"op", "remove"}, {"path", GetParam().pointer}}}));
  else
    doc[pointer] = json::parse(GetParam().value);
  EXPECT_THAT(error_for(doc), HasSubstr(GetParam().expected));
}

const Case kCases[] = {
    {"/asset/version", "\"1.0\"", "asset.version is \"1.0\"; only glTF 2 is read"},
    {"/asset", "", "has no member \"asset\""},
    {"/scene", "1", "scene is 1; allowed are 0 to 0 (scenes)"},
    {"/scenes/0/nodes/0", "7", "scenes[0].nodes[0] is 7; allowed are 0 to 2 (nodes)"},
    {"/nodes", "{}", "nodes is an object; an array is needed"},
    {"/nodes/0", "3", "nodes[0] is 3; an object is needed"},
    {"/nodes/0/mesh", "-1", "nodes[0].mesh is -1; allowed are 0 to 0 (meshes)"},
    {"/nodes/0/mesh", "0.5", "nodes[0].mesh is 0.5; a whole number is needed"},
    {"/nodes/0/mesh", "99999999999999999999", "nodes[0].mesh is"},
    {"/nodes/0/camera", "0", "nodes[0].camera is 0, but the file has no cameras"},
    {"/nodes/0/skin", "0", "but the file has no skins"},
    {"/nodes/0/matrix", "[1,2,3]", "nodes[0].matrix is an array of 3; an array of 16 numbers is needed"},
    {"/nodes/0/translation", "[1,2,\"x\"]", "nodes[0].translation[2] is \"x\"; a number is needed"},
    {"/nodes/0/translation", "[1,2,1e300]", "nodes[0] has a transformation beyond 1e30"},
    {"/nodes/0/rotation", "[0,0,0,0]", "nodes[0].rotation is zero; a unit quaternion is needed"},
    {"/nodes/0/matrix", "[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]", "nodes[0].matrix has a fourth row other than 0, 0, 0, 1"},
    {"/nodes/0/children", "[0]", "leads back to the node itself"},
    {"/nodes/0/children", "[1,1]", "a node has one parent at most"},
    {"/nodes/0/extensions", R"({"KHR_lights_punctual":{"light":0}})", "but the file has no lights"},
    {"/meshes/0/primitives", "", "meshes[0] has no member \"primitives\""},
    {"/meshes/0/primitives/0/mode", "7", "meshes[0].primitives[0].mode is 7; allowed are 0, 1, 2, 3, 4, 5, 6"},
    {"/meshes/0/primitives/0/indices", "2", "meshes[0].primitives[0].indices is 2; allowed are 0 to 1 (accessors)"},
    {"/meshes/0/primitives/0/indices", "0", "indices is accessors[0] of VEC3 FLOAT; allowed are SCALAR UNSIGNED_BYTE"},
    {"/meshes/0/primitives/0/attributes/POSITION", "1",
     "attributes.POSITION is accessors[1] of SCALAR UNSIGNED_BYTE; allowed are VEC3"},
    {"/meshes/0/primitives/0/attributes/POSITION", "-3", "attributes.POSITION is -3; allowed are 0 to 1"},
    {"/meshes/0/primitives/0/attributes", "[]", "attributes is an array of 0; an object is needed"},
    {"/meshes/0/primitives/0/material", "0", "but the file has no materials"},
    {"/accessors/0/count", "4", "accessors[0] needs 4 elements of 12 bytes from byte 0 on; bufferViews[0] has 36 bytes"},
    {"/accessors/0/count", "4294967296", "accessors[0] needs 4294967296 elements"},
    {"/accessors/0/count", "9007199254740991", "accessors[0] needs 9007199254740991 elements"},
    {"/accessors/0/count", "18446744073709551615",
     "accessors[0].count is 18446744073709551615; allowed are 1 to 9007199254740991"},
    {"/accessors/0/count", "0", "accessors[0].count is 0; allowed are 1 to"},
    {"/accessors/0/byteOffset", "4", "accessors[0] needs 3 elements of 12 bytes from byte 4 on"},
    {"/accessors/0/byteOffset", "9007199254740991", "accessors[0] needs 3 elements"},
    {"/accessors/0/componentType", "5127", "accessors[0].componentType is 5127; allowed are 5120, 5121"},
    {"/accessors/0/type", "\"VEC5\"", "accessors[0].type is \"VEC5\"; allowed are SCALAR, VEC2"},
    {"/accessors/0/bufferView", "2", "accessors[0].bufferView is 2; allowed are 0 to 1 (bufferViews)"},
    {"/accessors/1/bufferView", "", "meshes[0].primitives[0].indices is 1, but that accessor has no bufferView"},
    {"/accessors/1/byteOffset", "3", "has nothing to show"},  // the tail of zeros: a triangle of one corner
    {"/accessors/1/byteOffset", "6", "accessors[1] needs 3 elements of 1 bytes from byte 6 on; bufferViews[1] has 8 bytes"},
    {"/accessors/0/sparse", R"({"count":4,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}})",
     "accessors[0].sparse.count is 4; allowed are 1 to 3"},
    {"/accessors/0/sparse", R"({"count":3,"indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0}})",
     "accessors[0].sparse.indices needs 3 elements of 4 bytes"},
    {"/accessors/0/sparse",
     R"({"count":3,"indices":{"bufferView":0,"componentType":5121,"byteOffset":14},"values":{"bufferView":0}})",
     "accessors[0].sparse.indices holds 128; allowed are 0 to 2"},
    {"/accessors/0/sparse", R"({"count":2,"indices":{"bufferView":1,"componentType":5121}})", "has no member \"values\""},
    {"/bufferViews/0/byteLength", "45", "bufferViews[0] takes bytes 0 to 44; buffers[0] has 44 bytes"},
    {"/bufferViews/1/byteOffset", "9007199254740991", "bufferViews[1] takes bytes"},
    {"/bufferViews/0/byteStride", "8", "accessors[0] has elements of 12 bytes, more than the byteStride of its bufferView, 8"},
    {"/bufferViews/0/byteStride", "5", "bufferViews[0].byteStride is 5; allowed are multiples of 4"},
    {"/bufferViews/0/byteStride", "256", "bufferViews[0].byteStride is 256; allowed are 4 to 252"},
    {"/bufferViews/0/buffer", "1", "bufferViews[0].buffer is 1; allowed are 0 to 0 (buffers)"},
    {"/asset/minVersion", "\"2.1\"", "asset.minVersion is \"2.1\"; what needs more than glTF 2.0 is not read"},
    {"/buffers/0/byteLength", "10", "bufferViews[0] takes bytes 0 to 35; buffers[0] has 10 bytes"},
    {"/buffers/0/byteLength", "4294967296", "buffers[0].byteLength is 4294967296; the data has 44 bytes"},
    {"/buffers/0/uri", "", "buffers[0] has no uri"},
    {"/buffers/0/uri", "\"missing.bin\"", "buffers[0].uri names \"missing.bin\": there is no such file"},
    {"/buffers/0/uri", "\".\"", "buffers[0].uri names \".\": is a folder, not a file"},
    {"/buffers/0/uri", "\"/dev/zero\"", "buffers[0].uri is \"/dev/zero\"; allowed are data URIs and paths relative to the file"},
    {"/buffers/0/uri", "\"http://example.org/a.bin\"", "allowed are data URIs and paths relative to the file"},
    {"/buffers/0/uri", "\"%00\"", "allowed are data URIs and paths relative to the file"},
    {"/buffers/0/uri", "\"data:;base64,AA*A\"", "buffers[0].uri is a data URI with a character that is not base64"},
    {"/buffers/0/uri", "\"data:;base64\"", "buffers[0].uri is a data URI without a comma"},
    {"/extensionsRequired", R"(["KHR_draco_mesh_compression"])", "extensionsRequired names \"KHR_draco_mesh_compression\""},
    {"/extensionsRequired", R"(["KHR_mesh_quantization","EXT_meshopt_compression"])", "names \"EXT_meshopt_compression\""},
    {"/extensionsRequired", R"(["KHR_texture_basisu"])", "names \"KHR_texture_basisu\", which psmlab does not read"},
    {"/extensionsRequired", R"(["a\nb"])", "names"},
    {"/cameras", R"([{"type":"perspective","perspective":{"yfov":4,"znear":1}}])", "cameras[0].perspective.yfov is 4"},
    {"/cameras", R"([{"type":"perspective","perspective":{"yfov":1,"znear":0}}])", "cameras[0].perspective.znear is 0"},
    {"/cameras", R"([{"type":"perspective","perspective":{"yfov":1,"znear":2,"zfar":1}}])", "zfar is 1"},
    {"/cameras", R"([{"type":"fisheye"}])", "cameras[0].type is \"fisheye\"; allowed are perspective, orthographic"},
    {"/extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{"outerConeAngle":2}}]}})", "outerConeAngle is 2"},
    {"/skins", R"([{"joints":[5]}])", "skins[0].joints[0] is 5; allowed are 0 to 2 (nodes)"},
    {"/images", R"([{"bufferView":9}])", "images[0].bufferView is 9"},
    {"/textures", R"([{"source":0}])", "textures[0].source is 0, but the file has no images"},
    {"/materials", R"([{"alphaMode":"GLASS"}])", "materials[0].alphaMode is \"GLASS\"; allowed are OPAQUE, MASK, BLEND"},
    {"/materials", R"([{"pbrMetallicRoughness":{"baseColorFactor":[2,0,0,1]}}])", "baseColorFactor[0] is 2"},
    {"/scenes/0/nodes", "[1]", "has nothing to show"},
};
INSTANTIATE_TEST_SUITE_P(Gltf, OneMember, testing::ValuesIn(kCases));

TEST(GltfBad, IndexBeyondTheVertices) {
  json doc = triangle();
  doc["accessors"][0]["count"] = 2;
  EXPECT_THAT(error_for(doc), HasSubstr("meshes[0].primitives[0].indices holds 2 (index 2); allowed are 0 to 1"));
}

TEST(GltfBad, NamesWithLineBreaks) {
  json doc = triangle();
  doc["meshes"][0]["primitives"][0]["attributes"]["_A\nB"] = 9;
  EXPECT_THAT(error_for(doc), HasSubstr("attributes._A?B is 9"));
  EXPECT_EQ(read_gltf("no\nsuch.glb").error().text, "no?such.glb: there is no such file");
}

TEST(GltfBad, AttributesOfDifferentLengths) {
  json doc = triangle();
  doc["accessors"].push_back({{"bufferView", 0}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}});
  doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 2;
  EXPECT_THAT(error_for(doc), HasSubstr("attributes.NORMAL has 2 elements; POSITION has 3"));
}

TEST(GltfBad, PositionsThatAreNoNumbers) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e35f})
    EXPECT_THAT(error_for(triangle({0, 0, 0, 1, bad, 0, 0, 1, 0})), HasSubstr("attributes.POSITION has no usable position 1"));
  json doc = triangle({0, 0, 0, 1e20f, 0, 0, 0, 1, 0});
  doc["nodes"][0]["scale"] = {1e20, 1, 1};
  EXPECT_THAT(error_for(doc), HasSubstr("position 1 in the world"));
}

TEST(GltfBad, ZerosWithoutABufferAreNotUnlimited) {
  json doc = triangle();
  doc["accessors"].push_back({{"componentType", 5126}, {"count", 4000000000u}, {"type", "VEC3"}});
  EXPECT_THAT(error_for(doc), HasSubstr("accessors[2].count is 4000000000 without a bufferView; allowed are up to"));
}

TEST(GltfBad, InstancesBeyondTheBudget) {
  // 64 thousand vertices that take no bytes, shown by two thousand nodes.
  json doc = triangle();
  doc["accessors"].push_back({{"componentType", 5126}, {"count", 64000}, {"type", "VEC3"}});
  doc["meshes"][0]["primitives"] = json::array({{{"attributes", {{"POSITION", 2}}}, {"mode", 0}}});
  doc["scenes"][0]["nodes"] = json::array();
  doc["nodes"] = json::array();
  for (int i = 0; i < 2000; ++i) {
    doc["scenes"][0]["nodes"].push_back(i);
    doc["nodes"].push_back({{"mesh", 0}});
  }
  EXPECT_THAT(error_for(doc), HasSubstr("above 50000000 vertices, the most that is read"));
}

TEST(GltfBad, CyclesOfSeveralNodes) {
  json doc = triangle();
  doc["nodes"][0]["children"] = {1};
  doc["nodes"][1]["children"] = {2};
  doc["nodes"][2]["children"] = {0};
  EXPECT_THAT(error_for(doc), HasSubstr("leads back to the node itself"));
}

TEST(GltfBad, DeepHierarchiesAreRead) {
  json doc = triangle();
  doc["nodes"] = json::array();
  const int depth = 100000;
  for (int i = 0; i < depth; ++i) doc["nodes"].push_back({{"children", {i + 1}}, {"translation", {0, 1, 0}}});
  doc["nodes"].push_back({{"mesh", 0}});
  const TempFolder folder;
  const Result<Scene> scene = read_gltf(folder.write("deep.gltf", doc.dump()));
  ASSERT_TRUE(scene) << scene.error().text;
  EXPECT_EQ(scene->bounds.min.y, double(depth));
}

TEST(GltfBad, DeeplyNestedJson) {
  const std::string open(1000000, '['), close(1000000, ']');
  EXPECT_THAT(error_for_bytes("deep.gltf", open), HasSubstr("is not JSON"));
  EXPECT_THAT(error_for_bytes("deep.gltf", open + close), HasSubstr("an object is needed"));
  std::string text = triangle().dump();
  text.insert(1, "\"extras\":" + open + close + ",");
  EXPECT_EQ(error_for_bytes("deep.gltf", text), "no error");
  text = triangle().dump();
  text.replace(text.find("\"mesh\":0"), 8, "\"mesh\":" + open + close);
  EXPECT_THAT(error_for_bytes("deep.gltf", text), HasSubstr("nodes[0].mesh is an array of 1; a whole number is needed"));
}

TEST(GltfBad, NotJson) {
  EXPECT_THAT(error_for_bytes("a.gltf", "hello"),
              HasSubstr("is not JSON (a .gltf is JSON, a .glb starts with \"glTF\"): syntax error in line 1"));
  EXPECT_THAT(error_for_bytes("a.gltf", "{\n \"asset\": }"), HasSubstr("line 2, column"));
  EXPECT_THAT(error_for_bytes("a.gltf", "[1]"), HasSubstr("its JSON is an array of 1"));
  EXPECT_THAT(error_for_bytes("a.gltf", "{\"asset\": \"\xff\xfe\"}"), HasSubstr("is not JSON"));
  EXPECT_THAT(error_for_bytes("a.gltf", "{\"asset\": 1e999}"), HasSubstr("beyond the range of double"));
  EXPECT_THAT(error_for_bytes("a.gltf", ""), HasSubstr("is empty"));
}

TEST(GltfBad, FilesThatAreNoFiles) {
  const TempFolder folder;
  EXPECT_THAT(read_gltf(folder.path() / "none.gltf").error().text, HasSubstr("there is no such file"));
  EXPECT_THAT(read_gltf(folder.path()).error().text, HasSubstr("is a folder"));
  ASSERT_EQ(mkfifo((folder.path() / "pipe.gltf").c_str(), 0600), 0);
  EXPECT_THAT(read_gltf(folder.path() / "pipe.gltf").error().text, HasSubstr("is not a regular file"));
}

TEST(GltfBad, Images) {
  // A PNG header that claims 30000 x 30000 pixels in 33 bytes, and things that are no images: a note each, no texture.
  std::string huge("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x75\x30\0\0\x75\x30\x08\6\0\0\0\0\0\0\0", 33);
  for (const std::string& bytes : {huge, std::string("GIF89a"), std::string("\xff\xd8\xff", 3)}) {
    json doc = triangle();
    doc["images"] = json::array({{{"uri", data_uri(bytes)}}});
    doc["textures"] = json::array({{{"source", 0}}});
    doc["materials"] = json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
    doc["meshes"][0]["primitives"][0]["material"] = 0;
    const TempFolder folder;
    const Result<Scene> scene = read_gltf(folder.write("image.gltf", doc.dump()));
    ASSERT_TRUE(scene) << scene.error().text;
    EXPECT_EQ(scene->materials[0].texture, -1);
    ASSERT_TRUE(test::note_of(*scene, "gltf_image"));
    EXPECT_THAT(test::note_of(*scene, "gltf_image")->text, HasSubstr("images[0] is left out"));
  }
}

// ---- .glb ------------------------------------------------------------------------------------------------------------

std::string u32(std::uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), 4); }

std::string good_glb() {
  const TempFolder folder;
  Scene scene;
  scene.materials.push_back({});
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {0, 1, 2};
  scene.meshes.push_back(mesh);
  update_bounds(scene);
  EXPECT_FALSE(write_glb(scene, folder.path() / "good.glb"));
  return test::bytes_of(folder.path() / "good.glb");
}

TEST(GlbBad, Containers) {
  const std::string good = good_glb();
  EXPECT_EQ(error_for_bytes("good.glb", good), "no error");
  EXPECT_EQ(error_for_bytes("named_wrongly.gltf", good), "no error");
  EXPECT_THAT(error_for_bytes("a.glb", "PK" + good), HasSubstr("is not a binary glTF file: it does not start with \"glTF\""));
  EXPECT_THAT(error_for_bytes("a.glb", "glTF" + u32(1) + good.substr(8)),
              HasSubstr("header says version 1; only version 2 is read"));
  EXPECT_THAT(error_for_bytes("a.glb", good.substr(0, good.size() - 1)), HasSubstr("it is cut off"));
  EXPECT_THAT(error_for_bytes("a.glb", good.substr(0, 19)), HasSubstr("header is cut off: a .glb has at least 20 bytes"));
  EXPECT_THAT(error_for_bytes("a.glb", good.substr(0, 12) + u32(0xFFFFFFFF) + good.substr(16)),
              HasSubstr("chunk[0] says 4294967295 bytes"));
  EXPECT_THAT(error_for_bytes("a.glb", good.substr(0, 16) + "NOPE" + good.substr(20)), HasSubstr("is not the JSON chunk"));
  const std::size_t json_end = 20 + std::uint8_t(good[12]) + 256 * std::uint8_t(good[13]);
  EXPECT_THAT(error_for_bytes("a.glb", "glTF" + u32(2) + u32(std::uint32_t(json_end)) + good.substr(12, json_end - 12)),
              HasSubstr("buffers[0] has no uri; only the first buffer of a .glb with a binary chunk may lack one"));
}

TEST(GlbBad, EveryTruncationIsRefused) {
  const std::string good = good_glb();
  const TempFolder folder;
  for (std::size_t size = 0; size < good.size(); size += size < 64 ? 1 : 7)
    EXPECT_FALSE(read_gltf(folder.write("a.glb", good.substr(0, size)))) << size;
}

}  // namespace
}  // namespace psm
