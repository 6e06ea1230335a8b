#include "Logic/IO/ImageFiles.h"

#include <gmock/gmock.h>

#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

TEST(ImageFiles, ColoursAndDepthsComeBackAsTheyWere) {
  const TemporaryFolder folder;
  const ColourImage colours = gradientImage(31, 17);
  writePng(folder / "c.png", colours, Overwrite::Refuse, {{"Comment", "gradient"}});
  const ColourImage read = readColourImage(folder / "c.png");
  EXPECT_EQ(read.width, 31);
  EXPECT_EQ(read.height, 17);
  EXPECT_EQ(read.rgb, colours.rgb);
  const DepthImage depths = slantedDepths(20, 11);
  writePng(folder / "d.png", depths, Overwrite::Refuse);
  EXPECT_EQ(readDepthImage(folder / "d.png").depth, depths.depth);
  EXPECT_TRUE(isDepthImage(folder / "d.png"));
  EXPECT_FALSE(isDepthImage(folder / "c.png"));
}

TEST(ImageFiles, JpegColoursAreReadByContent) {
  const TemporaryFolder folder;
  put(folder / "photo.png", smallJpeg());  // a wrong ending is no hindrance
  const ColourImage image = readColourImage(folder / "photo.png");
  ASSERT_EQ(image.width, 16);
  for (const auto& [channel, value] : {std::pair(0, 200), {1, 60}, {2, 40}})
    EXPECT_NEAR(image.at(8, 8)[static_cast<std::size_t>(channel)], value, 6);  // grey values: lossy
}

TEST(ImageFiles, TruncatedPicturesAreRefusedInOneLine) {
  const TemporaryFolder folder;
  writePng(folder / "good.png", gradientImage(31, 17), Overwrite::Refuse);
  for (const std::string& bytes : {readTextFile(folder / "good.png"), smallJpeg()})
    for (const std::size_t k : {1, 2, 3, 5, 8}) {
      put(folder / "cut", bytes.substr(0, bytes.size() * k / 9));
      const std::string message = refusalOf([&] { (void)readColourImage(folder / "cut"); });
      EXPECT_NE(message, "no error") << k;
      EXPECT_THAT(message, testing::Not(HasSubstr("\n")));
    }
}

TEST(ImageFiles, APictureLargerThanItsBytesIsRefusedBeforeItIsAskedFor) {
  const TemporaryFolder folder;
  writePng(folder / "good.png", gradientImage(31, 17), Overwrite::Refuse);
  std::string bytes = readTextFile(folder / "good.png");
  // Width and height of the IHDR chunk, and its check sum (of the type and 100,000 x 100,000 pixels of RGB).
  bytes.replace(16, 8, std::string("\x00\x01\x86\xA0\x00\x01\x86\xA0", 8));
  put(folder / "huge.png", bytes);
  EXPECT_NE(refusalOf([&] { (void)readColourImage(folder / "huge.png"); }), "no error");
}

TEST(ColourImages, SamplesAtPixelCentresAreThePixelsAndBetweenThemTheMean) {
  const ColourImage image = gradientImage(8, 4);
  TexturePlaces places(4, 2);
  places << 0.5F / 8, 1 - 0.5F / 4,  // centre of the upper left pixel
      6.5F / 8, 1 - 3.5F / 4,        // column 6, row 3
      3.0F / 8, 1 - 1.5F / 4,        // between columns 2 and 3 of row 1
      2.0F, -1.0F;                   // outside: the lower right corner
  const Colours colours = coloursAt(image, places);
  EXPECT_EQ(colours.row(0), (Colours(1, 3) << 0, 0, 40).finished());
  EXPECT_EQ(colours.row(1), (Colours(1, 3) << 6, 3, 40).finished());
  EXPECT_EQ(colours.row(2), (Colours(1, 3) << 3, 1, 40).finished());  // 2.5 rounds away from zero
  EXPECT_EQ(colours.row(3), (Colours(1, 3) << 7, 3, 40).finished());
}

}  // namespace
}  // namespace falciform
