// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

namespace psm {
namespace {

namespace fs = std::filesystem;

InputError cannot(const fs::path& file, const char* what) {
  return {file.string() + ": cannot be " + what + ": " + std::strerror(errno) +
          "; allowed: a file that may be read and written, on a disk with room"};
}

Result<std::string> text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return cannot(file, "read");
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Without what follows the last newline: the line that was being written when somebody pulled the plug.
std::string whole_lines(std::string text) {
  text.resize(text.find_last_of('\n') + 1);  // npos + 1 is 0
  return text;
}

/// In one piece, but where the disk is full: the second piece says so.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written <= 0) return false;
    text.remove_prefix(std::size_t(written));
  }
  return ::fsync(descriptor) == 0;
}

std::optional<InputError> check_same(const StudyRow& first, const StudyRow& row, const std::string& place) {
  if (row.version != first.version)
    return InputError{place + ": rows of versions " + first.version + " and " + row.version +
                      " of psmlab; allowed: rows of one version"};
  if (row.study != first.study)
    return InputError{place + ": rows of different studies, " + first.study + " and " + row.study +
                      " (other scenes, experiments or runs); allowed: rows of one study"};
  return std::nullopt;
}

std::optional<InputError> read_journal(const fs::path& file, const RowCheck& check, std::vector<StudyRow>& rows) {
  const auto text = text_of(file);
  if (!text) return text.error();
  std::istringstream lines(whole_lines(*text));
  const std::string header = csv_header();
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = file.string() + ": line " + std::to_string(++number);
    if (number == 1) {
      if (line + "\n" == header) continue;
      return InputError{place + ": not the columns of this version of psmlab; allowed: a journal that this version wrote"};
    }
    const auto row = row_from_csv(line);
    if (!row) return InputError{place + ": not a row; allowed: " + std::to_string(study_columns().size()) + " values"};
    if (!rows.empty())
      if (auto error = check_same(rows[0], *row, place)) return error;
    if (const auto wrong = check(*row)) return InputError{place + ": " + *wrong};
    rows.push_back(*row);
  }
  return std::nullopt;
}

}  // namespace

Result<Journal> Journal::open(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) return cannot(file, "opened");
  Journal journal(file, descriptor);
  const auto text = text_of(file);
  if (!text) return text.error();
  const std::string kept = whole_lines(*text);
  if (::ftruncate(descriptor, off_t(kept.size())) != 0) return cannot(file, "shortened");
  if (kept.empty() && !write_all(descriptor, csv_header())) return cannot(file, "written");
  return journal;
}

Journal::Journal(Journal&& other) noexcept : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<InputError> Journal::append(const StudyRow& row) {
  if (write_all(descriptor_, csv_line(row))) return std::nullopt;
  return cannot(file_, "written");
}

Result<std::vector<StudyRow>> read_journals(const std::vector<fs::path>& folders, const RowCheck& check) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (fs::is_regular_file(entry.path(), error) && entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<StudyRow> rows;
  for (const fs::path& file : files)
    if (auto error = read_journal(file, check, rows)) return *error;
  std::map<double, StudyRow> by_run;
  for (StudyRow& row : rows) by_run.emplace(row.run, std::move(row));
  std::vector<StudyRow> ordered;
  for (auto& [run, row] : by_run) ordered.push_back(std::move(row));
  return ordered;
}

}  // namespace psm
