// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a study on disk: one file for each process that measures, one line a row, written whole and in order, so that a
// study that was interrupted goes on where it stopped and shards of several machines can be put together.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/study_row.h"
#include "scene/result.h"

namespace psm {

class Journal {
 public:
  /// Appends to `file`, which is made if it is not there; its folder is. A half-written last line is cut off.
  static Result<Journal> open(const std::filesystem::path& file);
  ~Journal();
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;

  /// On disk when it returns. The error names the file.
  std::optional<InputError> append(const StudyRow& row);

 private:
  Journal(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// What is wrong with a row that does not belong to what is measured, and what is allowed; nothing where it does.
using RowCheck = std::function<std::optional<std::string>(const StudyRow&)>;

/// The rows of all journals (*.csv) in a folder, by run, each run once. A half-written last line is left out; any other line that
/// is no row, or that `check` refuses, is an error with its place, and so are rows of several versions or studies. No folder: no
/// rows.
Result<std::vector<StudyRow>> read_journals(const std::vector<std::filesystem::path>& folders, const RowCheck& check);

}  // namespace psm
