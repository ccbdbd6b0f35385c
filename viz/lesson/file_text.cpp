// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson/file_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "scene/experiment_members.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = 1u << 20;

/// Bytes of the character that starts here; 0 where it is not UTF-8, or a control character other than tab and line ends.
std::size_t character_length(const std::string& text, std::size_t at) {
  const unsigned char first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return first >= 0x20 || first == '\n' || first == '\t' || first == '\r' ? 1 : 0;
  const std::size_t length = first >= 0xF5 ? 0 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return 0;
  return length;
}

}  // namespace

Result<std::string> read_text_file(const fs::path& file) {
  const std::string name = quotable(file.string());
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error))
    return InputError{name + ": is not a plain file; allowed: a file of a lesson"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return InputError{name + ": cannot be read: " + std::strerror(errno ? errno : EIO) + "; allowed: a file of a lesson"};
  std::string text(kMost + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > kMost) return InputError{name + ": larger than 1 MiB; allowed: up to 1 MiB"};
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // some editors' mark of UTF-8
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    if (length == 0) {
      const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
      return InputError{name + ":" + std::to_string(line) + ": a byte that is no text; allowed: UTF-8"};
    }
    at += length;
  }
  return text;
}

}  // namespace psm
