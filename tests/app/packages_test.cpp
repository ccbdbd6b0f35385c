// SPDX-License-Identifier: GPL-3.0-or-later
// The README's dependency table is the list that the set-up installs from.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Rows = std::vector<std::string>;

std::ifstream open_from_root(const std::string& path) { return std::ifstream(std::string(PSMLAB_TEST_DATA) + "/../" + path); }

TEST(Packages, TheReadmeTableIsTheInstalledList) {
  Rows listed, shown;
  std::ifstream list = open_from_root("app/packages.txt"), readme = open_from_root("README.md");
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::string group, package, reason;
    std::istringstream words(line);
    std::getline(words >> group >> package >> std::ws, reason);
    EXPECT_TRUE(group == "build" || group == "run" || group == "test" || group == "deb") << line;
    listed.push_back("| " + package + " | " + reason + " |");
  }
  bool in_table = false;
  for (std::string line; std::getline(readme, line);) {
    if (in_table && line.empty()) break;
    if (in_table && line.rfind("| --- ", 0) != 0) shown.push_back(line);
    if (line == "| package | reason |") in_table = true;
  }
  EXPECT_GT(listed.size(), 10u);
  EXPECT_EQ(shown, listed);
}

}  // namespace
