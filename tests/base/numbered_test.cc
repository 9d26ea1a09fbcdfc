// Arrays, lists and spans of what is numbered by int.
#include "base/numbered.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace stanok {
namespace {

static_assert(std::is_trivially_copyable_v<NumberedArray<double, 3>>, "it crosses into the cycle");
static_assert(std::is_trivially_copyable_v<NumberedSpan<double>>);
static_assert(!std::is_convertible_v<NumberedSpan<const int>, NumberedSpan<int>>);

TEST(Numbered, IsReadByNumberAndByPlace) {
  NumberedArray<int, 3> array{10, 20, 30};
  NumberedList<int> list{10, 20, 30};
  for (int number = 0; number < 3; ++number) {
    const auto place = static_cast<std::size_t>(number);
    EXPECT_EQ(array[number], 10 * (number + 1));
    EXPECT_EQ(array[number], array[place]);
    EXPECT_EQ(list[number], list[place]);
  }
  array[1] = 5;
  list[2] = 7;
  EXPECT_EQ(array, (NumberedArray<int, 3>{10, 5, 30}));
  EXPECT_EQ(list, (NumberedList<int>{10, 20, 7}));
}

TEST(NumberedSpan, LooksAtEither) {
  NumberedArray<int, 3> array{10, 20, 30};
  const NumberedList<int> list{1, 2};
  const NumberedSpan<int> of_array = array;
  of_array[2] = 33;
  EXPECT_EQ(array[2], 33);
  const NumberedSpan<const int> of_list = list;
  EXPECT_EQ(of_list.size(), 2U);
  EXPECT_EQ(of_list[1], 2);
  const NumberedSpan<const int> first = std::span(array).first(1);
  EXPECT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0], 10);
}

}  // namespace
}  // namespace stanok
