// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "draw/draw_list.h"

namespace psm {
namespace {

using glm::dvec2, glm::dvec4;

dvec2 text_size(const std::string& text, double scale, void*) { return {8.0 * scale * double(text.size()), 18.0 * scale}; }

std::vector<PlacedLabel> place(const DrawList& list, dvec2 picture = {640, 400}, double scale = 1.0) {
  return place_labels(list, glm::dmat4(1.0), picture, scale, text_size, nullptr);
}

DrawList random_list(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  auto point = [&] { return dvec4(coordinate(random), coordinate(random), 0.0, 1.0); };
  DrawList list;
  for (int i = 0, n = int(random() % 20); i < n; ++i) list.lines.push_back({point(), point()});
  for (int i = 0, n = int(random() % 25); i < n; ++i) {
    list.labels.push_back({point(), std::string(1 + random() % 24, 'a' + char(i)), Role::text, int(random() % 5)});
  }
  return list;
}

bool apart(const PlacedLabel& p, const PlacedLabel& q, double gap) {
  const dvec2 p1 = p.top_left + p.size + gap, q1 = q.top_left + q.size + gap;
  return p1.x <= q.top_left.x || q1.x <= p.top_left.x || p1.y <= q.top_left.y || q1.y <= p.top_left.y;
}

TEST(Labels, NeverOverlapAndAreNeverCut) {
  std::mt19937 random(7);
  std::size_t placed_in_all = 0;
  for (int i = 0; i < 400; ++i) {
    const double scale = i % 3 == 0 ? 1.8 : 1.0;
    const dvec2 picture = i % 2 ? dvec2(640, 400) : dvec2(300, 500);
    const auto placed = place(random_list(random), picture, scale);
    ASSERT_LE(placed.size(), 12u);
    placed_in_all += placed.size();
    for (std::size_t a = 0; a < placed.size(); ++a) {
      const dvec2 low = placed[a].top_left - label_margin * scale,
                  high = placed[a].top_left + placed[a].size + label_margin * scale;
      EXPECT_TRUE(low.x >= -1e-9 && low.y >= -1e-9 && high.x <= picture.x + 1e-9 && high.y <= picture.y + 1e-9);
      for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(apart(placed[a], placed[b], 2.0 * label_margin * scale - 1e-9));
    }
  }
  EXPECT_GT(placed_in_all, 1500u);
}

TEST(Labels, LeaveFreeWhatIsOccupied) {
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    const Occupied title{{4, 4}, {200, 60}};
    const auto placed = place_labels(random_list(random), glm::dmat4(1.0), {640, 400}, 1.0, text_size, nullptr, {title});
    for (const PlacedLabel& l : placed) EXPECT_TRUE(l.top_left.x >= 208 - 1e-9 || l.top_left.y >= 68 - 1e-9);
  }
}

TEST(Labels, StandInTheColumnsThatShow) {
  std::mt19937 random(10);
  std::size_t placed_in_all = 0;
  for (int i = 0; i < 100; ++i) {
    const auto placed = place_labels(random_list(random), glm::dmat4(1.0), {640, 400}, 1.0, text_size, nullptr, {}, {0.25, 0.75});
    placed_in_all += placed.size();
    for (const PlacedLabel& l : placed) {
      EXPECT_TRUE(l.top_left.x >= 160 && l.top_left.x + l.size.x <= 480);
      EXPECT_TRUE(l.anchor.x >= 160 && l.anchor.x <= 480) << "its leader would cross the line";
    }
  }
  EXPECT_GT(placed_in_all, 100u);
}

TEST(Labels, SameListSamePlaces) {
  std::mt19937 random(8);
  const DrawList list = random_list(random);
  const auto first = place(list), second = place(list);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].top_left, second[i].top_left);
}

TEST(Labels, WhatCannotBeSeenHasNone) {
  DrawList list;
  list.labels = {{{1.5, 0, 0, 1}, "outside"}, {{0, 0, 0, -1}, "behind"}, {{0, 0, 0, 0}, "nowhere"}, {{0, 0, 0, 1}, ""}};
  EXPECT_TRUE(place(list).empty());
}

TEST(Labels, TheLeastImportantGiveWay) {
  DrawList list;
  for (int i = 0; i < 40; ++i)
    list.labels.push_back({{0.001 * i, 0, 0, 1}, std::string(20, 'x') + char('a' + i % 26), Role::text, i});
  const auto placed = place(list);
  ASSERT_FALSE(placed.empty());
  EXPECT_EQ(placed[0].text, list.labels[39].text);
  // 300 x 60 holds one or two of these: the highest priorities.
  const auto few = place(list, {300, 80});
  ASSERT_FALSE(few.empty());
  EXPECT_EQ(few[0].text, list.labels[39].text);
}

TEST(Labels, PreferPlacesThatCoverNoLine) {
  DrawList list;
  list.labels.push_back({{0, 0, 0, 1}, "label"});
  // A fan of lines over the whole right half.
  for (int i = -10; i <= 10; ++i) list.lines.push_back({{0.01, 0.1 * i, 0, 1}, {1, 0.1 * i, 0, 1}});
  const auto placed = place(list);
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_LE(placed[0].top_left.x + placed[0].size.x, 0.505 * 640);
}

}  // namespace
}  // namespace psm
