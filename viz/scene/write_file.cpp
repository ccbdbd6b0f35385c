// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>

#include "scene/experiment_file.h"
#include "scene/experiment_members.h"

namespace psm {
namespace {

namespace fs = std::filesystem;

/// Short whatever the target's name is, so that a name of the greatest length still has room beside it.
fs::path temporary_beside(const fs::path& file) {
  std::random_device random;
  char name[40];
  std::snprintf(name, sizeof name, ".psmlab-%08x%08x.tmp", random(), random());
  return file.parent_path() / name;
}

/// Null on success, else the reason. Creates the file; never opens one that exists.
const char* write_new(const fs::path& file, const std::string& bytes) {
  std::FILE* stream = std::fopen(file.c_str(), "wbx");
  if (!stream) return std::strerror(errno);
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
  const bool closed = std::fclose(stream) == 0;
  return written && closed ? nullptr : std::strerror(errno ? errno : EIO);
}

}  // namespace

std::optional<InputError> write_file_atomically(const fs::path& file, const std::string& bytes) {
  const auto failure = [&](const std::string& reason) {
    return InputError{quotable(file.string()) + ": cannot be written: " + reason +
                      "; allowed: a file in an existing folder that may be written to"};
  };
  if (file.filename().empty()) return failure("it is not the name of a file");
  std::error_code error;
  // A link stays a link: what it points at is replaced.
  const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
  const fs::file_status old = fs::status(target, error);
  // Renaming over a device or a pipe would replace the device by a file.
  if (fs::exists(old) && !fs::is_regular_file(old))
    return failure(fs::is_directory(old) ? "it is a folder" : "it is not a plain file");

  const fs::path temporary = temporary_beside(target);
  const char* reason = write_new(temporary, bytes);
  const std::string reason_text = reason ? reason : "";
  if (!reason) {
    if (fs::exists(old)) fs::permissions(temporary, old.permissions(), error);
    fs::rename(temporary, target, error);
    if (!error) return std::nullopt;
  }
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return failure(reason ? reason_text : error.message());
}

}  // namespace psm
