// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of what is on the screen, by its keys.
#include "../app/picture.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "harness.h"

namespace psm::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Key P with this name instead of the suggested one.
void save_as(Bench& bench, const std::filesystem::path& file) {
  bench.key('P');
  bench.type(file.string());
  bench.key(key::enter);
}

TEST(SavedPicture, TheScreenIsSavedAtOnceUnderAFreeName) {
  Bench bench;
  bench.key(key::f12);
  EXPECT_EQ(bench.work().last_picture(), bench.folder() / "psmlab-ground-1.png");
  EXPECT_NE(bench.work().message().find("psmlab-ground-1.png"), std::string::npos);
  bench.key('3');
  bench.key(key::f12);
  EXPECT_TRUE(std::filesystem::exists(bench.folder() / "psmlab-ground-2.png"));
}

TEST(SavedPicture, AFreeNameIsSuggestedWithTheLastEnding) {
  Bench bench;
  save_as(bench, bench.folder() / "a.svg");
  bench.key('P');
  bench.key(key::enter);
  EXPECT_EQ(bench.work().last_picture(), bench.folder() / "psmlab-ground-1.svg");
}

TEST(SavedPicture, OneViewAloneIsThePictureOnTheScreen) {
  Bench bench("ground", {"view.maximised=world"});
  bench.drag({300, 400}, {360, 380});
  bench.move({1, 767});
  save_as(bench, bench.folder() / "world.png");
  const auto saved = testing::read_png(bench.folder() / "world.png");
  ASSERT_TRUE(saved);
  EXPECT_EQ(differing_pixels(*saved, bench.view(ViewId::world)), 0u);
}

TEST(SavedPicture, TheTilesStandAsOnTheScreen) {
  Bench bench("ground", {"view.tiles=world,curves,map"});
  save_as(bench, bench.folder() / "tiles.svg");
  const std::string svg = text_of(bench.folder() / "tiles.svg");
  const Rect first = bench.work_places().at("view.world"), last = bench.work_places().at("view.map");
  EXPECT_THAT(svg, HasSubstr("width=\"" + std::to_string(last.max.x - first.min.x) + "\" height=\"" +
                             std::to_string(last.max.y - first.min.y) + "\""));
  for (const char* title : {">World<", ">Curves", ">Shadow map"}) EXPECT_THAT(svg, HasSubstr(title));
  EXPECT_THAT(svg, Not(HasSubstr(">Unit cube<")));
}

TEST(SavedPicture, ANameThatIsNotAllowedIsAskedForAgain) {
  Bench bench;
  for (const char* name : {"x.bmp", "x.mp4", "no/such/folder/x.svg"}) {
    save_as(bench, bench.folder() / name);
    ASSERT_EQ(bench.work().dialog(), Dialogs::Kind::error) << name;
    bench.key(key::enter);
    EXPECT_EQ(bench.work().dialog(), Dialogs::Kind::picture) << name;
    bench.key(key::escape);
  }
}

}  // namespace
}  // namespace psm::test
