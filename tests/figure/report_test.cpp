// SPDX-License-Identifier: GPL-3.0-or-later
// The report's page from rows that were not measured but made up.
#include "figure/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figure/html.h"
#include "markup.h"
#include "measure/study.h"

namespace psm::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

StudyRow made_up(const std::string& scene, const std::string& technique, double resolution, double theta_deg) {
  StudyRow row;
  row.version = "1", row.study = "abc", row.scene = scene, row.technique = row.technique_used = technique;
  row.resolution = resolution, row.theta_deg = theta_deg, row.width = 640, row.height = 360;
  row.compared = 1000, row.error_fraction = 10 / resolution, row.m_p95 = 2000 / resolution, row.texels = resolution * resolution;
  row.analysis_us = 50, row.map_us = resolution, row.eye_us = 900;
  row.cpu = "processor <A> & B", row.compiler = "compiler", row.opengl = "renderer", row.tracer = "tracer";
  return row;
}

ReportInput made_up() {
  ReportInput input;
  for (const char* scene : {"ground", "slab"})
    for (const char* technique : {"uniform", "gmnpr", "best_plane"})
      for (const double resolution : {512.0, 1024.0})
        for (const double theta : {60.0, 150.0}) input.rows.push_back(made_up(scene, technique, resolution, theta));
  for (std::size_t i = 0; i < input.rows.size(); ++i) input.rows[i].run = double(i);
  input.rows[0].equal_error_resolution = 512;
  input.planned = 99;
  input.closed_forms = compare_with_closed_forms({}, {10, 90});
  input.cited = {"Source of & numbers.", {90, 30}, {{"Somebody's <engine>", 3.5, {1.5, kNone}}}};
  return input;
}

std::string file(const std::vector<ReportFile>& files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const ReportFile& f) { return f.name == name; });
  return found == files.end() ? "" : found->bytes;
}

TEST(Report, IsOneWellFormedPageWithoutAddresses) {
  const auto files = make_report(made_up());
  const std::string page = file(files, "index.html");
  EXPECT_EQ(unclosed_tags(page), "");
  for (const char* outside : {"http", "src=", "href=", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_THAT(page, HasSubstr("24 of 99 runs"));
  EXPECT_THAT(page, HasSubstr("processor &lt;A&gt; &amp; B"));
  EXPECT_THAT(page, HasSubstr("Somebody's &lt;engine&gt;"));
  EXPECT_THAT(page, Not(HasSubstr(">nan")));
  for (const ReportFile& f : files) {
    EXPECT_EQ(f.name == "rows.csv" ? "" : unclosed_tags(f.bytes), "") << f.name;
  }
}

TEST(Report, HasEveryTechniqueBesideTheClosedForms) {
  const std::string page = file(make_report(made_up()), "index.html");
  for (const Technique technique : techniques_to_compare())
    EXPECT_THAT(page, HasSubstr(std::string("<td>") + name_of(technique) + "</td>"));
}

TEST(Report, SetsOnlyATableSmallerThatThePageHasNoRoomFor) {
  const auto page_of = [](std::size_t columns) {
    HtmlTable table{"caption", {"name"}, {{"name"}}};
    for (std::size_t i = 0; i < columns; ++i) table.head.push_back("angle"), table.rows[0].push_back("5312 (5.19)");
    HtmlPage page("title");
    page.table(table);
    return page.text();
  };
  EXPECT_THAT(page_of(6), HasSubstr("<table>"));
  EXPECT_THAT(page_of(9), HasSubstr("<table class=\"small\">"));
}

TEST(Report, KeepsEveryRow) {
  const ReportInput input = made_up();
  const std::string csv = file(make_report(input), "rows.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 25);
  for (const StudyRow& row : input.rows) EXPECT_THAT(csv, HasSubstr(csv_line(row)));
}

TEST(Report, MarksWhatWasReplaced) {
  ReportInput input = made_up();
  for (StudyRow& row : input.rows)
    if (row.technique == "gmnpr") row.technique_used = "uniform";
  EXPECT_THAT(file(make_report(input), "index.html"), HasSubstr("<td>gmnpr*</td>"));
}

TEST(Report, OfNoRowsSaysSo) {
  ReportInput input;
  input.planned = 3;
  const std::string page = file(make_report(input), "index.html");
  EXPECT_EQ(unclosed_tags(page), "");
  EXPECT_THAT(page, HasSubstr("0 of 3 runs"));
}

TEST(CitedTable, ReadsItsSourceAndItsNumbers) {
  const auto table = read_cited_table("# From\n# here.\nsetup,us,90,1\n\"a, b\",,1.5,2\nc,3,4,5\n", "x.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->source, "From here.");
  EXPECT_THAT(table->theta_deg, ::testing::ElementsAre(90, 1));
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(table->rows[0].setup, "a, b");
  EXPECT_TRUE(std::isnan(table->rows[0].microseconds));
  EXPECT_THAT(table->rows[1].m_p95, ::testing::ElementsAre(4, 5));
  const auto bad = read_cited_table("setup,us,90,1\na,1,2\n", "x.csv");
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().text, HasSubstr("x.csv: line 2"));
}

}  // namespace
}  // namespace psm::testing
