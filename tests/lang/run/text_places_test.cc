// Places of a text: contours, entries, and where a search stops.
#include "lang/run/text_places.h"

#include "tests/lang/run/run_parts.h"

namespace stanok::lang::testing {
namespace {

class TextPlacesTest : public ::testing::Test, protected RunParts {
 protected:
  TextPlaces texts{vm, state, parameters};
};

TEST_F(TextPlacesTest, AContourHasItsBlocksWithTheirLines) {
  load("G0 X0\nN10 G1 X5 F100\nY5\nN20 X0\nM30\n");
  const Contour contour = texts.contour(10, 20);
  EXPECT_EQ(contour.problem, "");
  ASSERT_EQ(contour.blocks.size(), 3u);
  EXPECT_EQ(contour.blocks[1].origin.line, 3u);
  EXPECT_EQ(texts.contour(10, 30).problem, "the contour has no end N30");
  EXPECT_EQ(texts.contour(11, 20).problem, "the program has no block N11");
}

TEST_F(TextPlacesTest, AContourIsRunAndTheToolGoesBackToItsStart) {
  load("N10 G1 X5 F100\nN20 X0\nM30\n");
  vm.step();
  state.modal.position_W = {};
  texts.run_contour(1, 2);
  EXPECT_TRUE(texts.in_contour());
  EXPECT_EQ(vm.plain().line, 1u);
  state.modal.position_W[2] = -4.0;
  texts.leave_contour();
  EXPECT_FALSE(texts.in_contour());
  EXPECT_EQ(std::get<Move>(emitted()).end[2], 0.0);
}

TEST_F(TextPlacesTest, LinesInsideBracesCannotBeEntered) {
  load("num side = 5;\nif (side > 1) {\nG0 X=side\n}\nG0 X1\n");
  EXPECT_FALSE(texts.enter(3));
  EXPECT_TRUE(texts.enter(2));
  EXPECT_TRUE(texts.enter(5));
  EXPECT_EQ(vm.origin().line, 5u);
}

TEST_F(TextPlacesTest, ASearchStopsWhenTheLineIsReachedForTheWantedTime) {
  load("num side = 5;\nside = 6;\n");
  SearchStop stop;
  StopPlace place;
  place.line = 2;
  stop.set(place);
  EXPECT_FALSE(stop.is_reached(vm, texts));
  ASSERT_TRUE(texts.enter(2));
  EXPECT_TRUE(stop.is_reached(vm, texts));
  EXPECT_FALSE(stop.active()) << "once";
  place.passes = 2;
  stop.set(place);
  EXPECT_FALSE(stop.is_reached(vm, texts));
  EXPECT_FALSE(stop.is_reached(vm, texts)) << "the same visit";
  ASSERT_TRUE(texts.enter(1));
  EXPECT_FALSE(stop.is_reached(vm, texts));
  ASSERT_TRUE(texts.enter(2));
  EXPECT_TRUE(stop.is_reached(vm, texts));
}

}  // namespace
}  // namespace stanok::lang::testing
