// What a variant holds reaches the overload that is made for it.
#include "base/visit_in_cycle.h"

#include <gtest/gtest.h>

#include "base/overloaded.h"

namespace stanok {
namespace {

struct First {};
struct Second {
  int number = 0;
};
struct Third {
  int number = 0;
};
using Any = std::variant<First, Second, Third>;

int number_of(const Any& any) RT_SAFE {
  return visit_in_cycle(Overloaded{[](const First&) RT_SAFE { return 1; },
                                   [](const Second& held) RT_SAFE { return held.number; },
                                   [](const Third& held) RT_SAFE { return 10 * held.number; }},
                        any);
}

TEST(VisitInCycle, EachAlternativeReachesItsOverload) {
  EXPECT_EQ(number_of(First{}), 1);
  EXPECT_EQ(number_of(Second{2}), 2);
  EXPECT_EQ(number_of(Third{3}), 30);
}

}  // namespace
}  // namespace stanok
