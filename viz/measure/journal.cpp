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

namespace psm {
namespace {

namespace fs = std::filesystem;

InputError cannot(const fs::path& file, const char* what) {
  return {file.string() + ": cannot be " + what + ": " + std::strerror(errno) + "; allowed: a file that may be written to"};
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Without what follows the last newline: the line that was being written when somebody pulled the plug.
std::string whole_lines(std::string text) {
  text.resize(text.find_last_of('\n') + 1);  // npos + 1 is 0
  return text;
}

bool write_all(int descriptor, const std::string& text) {
  return ::write(descriptor, text.data(), text.size()) == ssize_t(text.size()) && ::fsync(descriptor) == 0;
}

std::optional<InputError> read_journal(const fs::path& file, std::vector<StudyRow>& rows) {
  std::istringstream lines(whole_lines(text_of(file)));
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
    rows.push_back(*row);
  }
  return std::nullopt;
}

std::optional<InputError> check_same(const std::vector<StudyRow>& rows) {
  for (const StudyRow& row : rows) {
    if (row.version != rows[0].version)
      return InputError{"rows of versions " + rows[0].version + " and " + row.version +
                        " of psmlab; allowed: rows of one version"};
    if (row.study != rows[0].study)
      return InputError{"rows of different studies, " + rows[0].study + " and " + row.study +
                        " (other scenes, experiments or runs); allowed: rows of one study"};
  }
  return std::nullopt;
}

}  // namespace

Result<Journal> Journal::open(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) return cannot(file, "opened");
  Journal journal(file, descriptor);
  const std::string kept = whole_lines(text_of(file));
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

Result<std::vector<StudyRow>> read_journals(const std::vector<fs::path>& folders) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file() && entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<StudyRow> rows;
  for (const fs::path& file : files)
    if (auto error = read_journal(file, rows)) return *error;
  if (auto error = check_same(rows)) return *error;
  std::map<double, StudyRow> by_run;
  for (StudyRow& row : rows) by_run.emplace(row.run, std::move(row));
  std::vector<StudyRow> ordered;
  for (auto& [run, row] : by_run) ordered.push_back(std::move(row));
  return ordered;
}

}  // namespace psm
