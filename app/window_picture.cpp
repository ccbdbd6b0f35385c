// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_picture.h"

#include "app/film.h"
#include "app/numbers.h"
#include "app/picture_file.h"
#include "app/render.h"

namespace psm {

std::optional<InputError> write_shown_views(const std::filesystem::path& file, const ShownViews& shown) {
  const bool plays = is_film(file);
  if (plays && !shown.animation)
    return flag_error("name", file.string(), "a film in a lesson's step that has an animation; .png, .svg or .pdf everywhere");
  if (auto error = check_picture_name(file.string(), plays, "name")) return error;
  RenderRequest request{shown.views, shown.size, shown.scale, shown.theme, false, shown.emphasis};
  const Sheet sheet = sheet_of(shown.loaded, request, {shown.places, 0});
  SheetPainter painter;
  return write_pictures(painter, sheet, plays ? std::optional(frames_of(*shown.animation)) : std::nullopt, file);
}

}  // namespace psm
