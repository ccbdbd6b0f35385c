// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/plot_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace psm {
namespace {

using ::testing::ElementsAre;

TEST(Ticks, AreRoundAndInRange) {
  EXPECT_THAT(plot_ticks(0, 1, false, 6), ElementsAre(0, 0.2, 0.4, ::testing::DoubleNear(0.6, 1e-12), 0.8, 1));
  EXPECT_THAT(plot_ticks(-3, 98, false, 5), ElementsAre(0, 50));
  EXPECT_THAT(plot_ticks(0.5, 2000, true, 8), ElementsAre(1, 10, 100, 1000));
  EXPECT_THAT(plot_ticks(1.5, 12, true, 8), ElementsAre(2, 5, 10));
  EXPECT_TRUE(plot_ticks(0, 10, true, 5).empty());
  EXPECT_EQ(tick_text(plot_ticks(-1e-12, 1, false, 5)[0]), "0");
  for (const double high : {1e-9, 0.3, 7.0, 123.0, 1e12})
    for (const int most : {3, 6, 10}) {
      const auto ticks = plot_ticks(0, high, false, most);
      EXPECT_LE(int(ticks.size()), most) << high;
      EXPECT_GE(ticks.size(), 2u) << high;
    }
}

TEST(Ticks, OfAnglesDivideTheCircle) {
  EXPECT_THAT(angle_ticks(0, 90, 10), ElementsAre(0, 10, 20, 30, 40, 50, 60, 70, 80, 90));
  EXPECT_THAT(angle_ticks(0, 90, 5), ElementsAre(0, 30, 60, 90));
  EXPECT_THAT(angle_ticks(0, 90, 2), ElementsAre(0, 90));
}

TEST(Ticks, BetweenDecadesAreMinor) {
  EXPECT_THAT(minor_ticks(1, 10), ElementsAre(2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_TRUE(minor_ticks(1e-4, 1e4).empty());
}

TEST(PlotScale, PlaceAndValueAreInverse) {
  for (const PlotScale& scale : {PlotScale(-3, 12, false, 100, 700), PlotScale(1e-3, 1e4, true, 400, 20)}) {
    for (const double t : {0.0, 0.2, 0.5, 1.0}) {
      const double place = scale.from() + t * (scale.to() - scale.from());
      EXPECT_NEAR(scale.at(scale.value_at(place)), place, 1e-9);
    }
    EXPECT_EQ(scale.at(scale.low()), scale.from());
    EXPECT_NEAR(scale.at(scale.high()), scale.to(), 1e-9);
  }
  EXPECT_FALSE(PlotScale(1, 10, true, 0, 1).shows(0));
  EXPECT_TRUE(std::isfinite(PlotScale(3, 3, false, 0, 1).at(3)));
  EXPECT_TRUE(std::isfinite(PlotScale(INFINITY, -INFINITY, true, 0, 1).at(3)));
}

TEST(Spread, KeepsOrderDistanceAndLimit) {
  std::vector<double> places{10, 11, 12, 60, 95, 99};
  spread(places, 12, 100);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GE(places[i] - places[i - 1], 12 - 1e-9);
  EXPECT_LE(places.back(), 100);
}

}  // namespace
}  // namespace psm
