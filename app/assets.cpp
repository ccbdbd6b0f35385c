// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assets.h"

#include <cstdio>
#include <cstdlib>

namespace psm {
namespace {

namespace fs = std::filesystem;

fs::path existing(const fs::path& path, const char* remedy) {
  std::error_code error;
  if (fs::exists(path, error)) return path;
  std::fprintf(stderr, "%s: not there; %s\n", path.c_str(), remedy);
  std::exit(1);
}

fs::path shared_folder(const char* name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return existing((program.parent_path() / "../share/psmlab" / name).lexically_normal(),
                  "install psmlab, or run it where its build folder put it");
}

}  // namespace

fs::path assets_folder() { return shared_folder("assets"); }
fs::path lessons_folder() { return shared_folder("lessons"); }

fs::path font_file() {
  return existing("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "install the Debian package fonts-dejavu-core");
}

}  // namespace psm
