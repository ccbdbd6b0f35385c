// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of glTF files: the .glb container, data URIs and external files.
#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "scene/gltf_reader.h"

namespace psm::gltf {
namespace {

constexpr std::uint32_t kChunkJson = 0x4E4F534A, kChunkBin = 0x004E4942;
constexpr std::uint64_t kLargestFile = std::uint64_t(4) << 30;

std::uint32_t little_endian_u32(const Bytes& bytes, std::size_t offset) {
  return std::uint32_t(bytes[offset]) | std::uint32_t(bytes[offset + 1]) << 8 | std::uint32_t(bytes[offset + 2]) << 16 |
         std::uint32_t(bytes[offset + 3]) << 24;
}

bool has_magic(const Bytes& bytes) { return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0; }

/// The length that the header claims, checked against what is there.
std::size_t checked_glb_length(const Bytes& bytes) {
  if (bytes.size() < 20) fail("header", "is cut off: a .glb has at least 20 bytes, this one " + std::to_string(bytes.size()));
  if (const auto version = little_endian_u32(bytes, 4); version != 2)
    fail("header", "says version " + std::to_string(version) + "; only version 2 is read");
  const std::size_t length = little_endian_u32(bytes, 8);
  if (length > bytes.size())
    fail("header", "says " + std::to_string(length) + " bytes, the file has " + std::to_string(bytes.size()) + ": it is cut off");
  if (length < 20) fail("header", "says " + std::to_string(length) + " bytes; a .glb has at least 20");
  return length;
}

Container split_glb(const Bytes& bytes) {
  const std::size_t length = checked_glb_length(bytes);
  Container container;
  std::size_t offset = 12;
  for (int chunk = 0; offset + 8 <= length; ++chunk) {
    const std::size_t size = little_endian_u32(bytes, offset);
    const std::uint32_t type = little_endian_u32(bytes, offset + 4);
    offset += 8;
    const std::string place = at("chunk", std::size_t(chunk));
    if (size > length - offset)
      fail(place, "says " + std::to_string(size) + " bytes; " + std::to_string(length - offset) + " are left in the file");
    if (chunk == 0 && type != kChunkJson) fail(place, "is not the JSON chunk, which must come first");
    const auto first = bytes.begin() + std::ptrdiff_t(offset), last = first + std::ptrdiff_t(size);
    if (chunk == 0) container.json.assign(first, last);
    if (chunk == 1 && type == kChunkBin) container.bin = std::make_shared<Bytes>(first, last);
    offset += size;
  }
  return container;
}

bool starts_with_no_case(const std::string& text, const std::string& prefix) {
  return text.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), text.begin(), [](char a, char b) {
           return a == ((b >= 'A' && b <= 'Z') ? char(b - 'A' + 'a') : b);
         });
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
    out += escape ? char(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])) : text[i];
    if (escape) i += 2;
  }
  return out;
}

std::array<std::int8_t, 256> base64_digits() {
  std::array<std::int8_t, 256> digits;
  digits.fill(-1);
  const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int i = 0; i < 64; ++i) digits[std::uint8_t(alphabet[i])] = std::int8_t(i);
  return digits;
}

Bytes base64_decoded(const std::string& text, std::size_t first, const std::string& place) {
  static const auto digits = base64_digits();
  std::size_t last = text.size();
  while (last > first && text[last - 1] == '=') --last;
  Bytes out;
  out.reserve((last - first) / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bit_count = 0;
  for (std::size_t i = first; i < last; ++i) {
    const int digit = digits[std::uint8_t(text[i])];
    if (digit < 0) fail(place, "is a data URI with a character that is not base64, " + std::to_string(i) + " bytes in");
    bits = bits << 6 | std::uint32_t(digit);
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    out.push_back(std::uint8_t(bits >> bit_count & 0xFF));
  }
  return out;
}

Bytes data_uri_bytes(const std::string& uri, const std::string& place) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos) fail(place, "is a data URI without a comma before its data");
  const std::string base64 = ";base64";
  if (comma >= base64.size() && uri.compare(comma - base64.size(), base64.size(), base64) == 0)
    return base64_decoded(uri, comma + 1, place);
  const std::string text = percent_decoded(uri.substr(comma + 1));
  return Bytes(text.begin(), text.end());
}

/// Relative paths only: neither the network nor absolute places of somebody else's machine.
void require_relative(const std::string& uri, const std::string& path, const std::string& place) {
  const std::size_t colon = uri.find(':'), slash = uri.find('/');
  const bool scheme = colon != std::string::npos && (slash == std::string::npos || colon < slash);
  if (path.empty() || scheme || path[0] == '/' || path[0] == '\\' || path.find('\0') != std::string::npos)
    fail(place, "is \"" + printable(uri) + "\"; allowed are data URIs and paths relative to the file");
}

}  // namespace

void fail(const std::string& place, const std::string& what) { throw Problem{place + " " + what}; }

std::string at(const std::string& array, std::size_t index) { return array + "[" + std::to_string(index) + "]"; }

std::string printable(const std::string& text, std::size_t limit) {
  std::string out = text.substr(0, limit);
  for (char& c : out)
    if (c < 0x20 || c > 0x7E) c = '?';
  return text.size() > limit ? out + "..." : out;
}

std::string shown(const std::filesystem::path& file) {
  std::string out = file.string();
  for (char& c : out)
    if (std::uint8_t(c) < 0x20 || c == 0x7F) c = '?';
  return out;
}

Bytes read_file(const std::filesystem::path& file, std::uint64_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw Problem{"there is no such file"};
  if (std::filesystem::is_directory(status)) throw Problem{"is a folder, not a file"};
  if (!std::filesystem::is_regular_file(status)) throw Problem{"is not a regular file"};
  const std::uint64_t size = std::filesystem::file_size(file, error);
  if (error) throw Problem{"cannot be read: " + error.message()};
  if (size == 0) throw Problem{"is empty"};
  if (size > limit) throw Problem{"has " + std::to_string(size) + " bytes; at most " + std::to_string(limit) + " are read"};
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes(size);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size))) throw Problem{"cannot be read"};
  return bytes;
}

Container open_container(Bytes bytes, const std::filesystem::path& file) {
  if (has_magic(bytes)) return split_glb(bytes);
  if (starts_with_no_case(file.extension().string(), ".glb"))
    throw Problem{"is not a binary glTF file: it does not start with \"glTF\""};
  return {std::string(bytes.begin(), bytes.end()), nullptr};
}

SharedBytes UriReader::read(const std::string& uri, const std::string& place) {
  if (starts_with_no_case(uri, "data:")) return std::make_shared<Bytes>(data_uri_bytes(uri, place));
  const std::string path = percent_decoded(uri);
  require_relative(uri, path, place);
  SharedBytes& bytes = files_[path];
  if (bytes) return bytes;
  try {
    bytes = std::make_shared<Bytes>(read_file(folder_ / std::filesystem::path(path), kLargestFile));
  } catch (const Problem& problem) {
    fail(place, "names \"" + printable(uri) + "\": " + problem.text);
  }
  return bytes;
}

}  // namespace psm::gltf
