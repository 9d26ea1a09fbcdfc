#include "base/text_bounds.h"

#include <gtest/gtest.h>

#include <string>

namespace stanok {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

TEST(TextBounds, LetWhatMachineFilesHoldPass) {
  const std::string text =
      "[machine]\nname = \"a.b.c\" # a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s.t\n"
      "limits = [[1.5, 2.5], [3.0e-4, 1979-05-27T07:32:00.999999-07:00]]\n"
      "axis.\"x.y\".start = 1.0\n[[tool]]\nname = '[[[[[[[[[[[[[[[[[[[['\n"
      "long = \"\"\"\n\"\"[[[[[[[[[[[[[[[[[[[[[[[[[\\\"\"\"\"\"\nlast = 1\n";
  EXPECT_FALSE(toml_excess(text));
}

TEST(TextBounds, RefuseAKeyOfVeryManyParts) {
  const std::string key = "a" + repeated(".a", 49'999);
  for (const std::string& text :
       {key + " = 1\n", "[" + key + "]\n", "[[" + key + "]]\n", "x = {" + key + " = 1}\n",
        repeated("\"a\" . 'b'.", 9) + "c = 1\n"}) {
    const auto excess = toml_excess("first = 1\n" + text);
    ASSERT_TRUE(excess) << text.substr(0, 20);
    EXPECT_EQ(excess->line, 2U);
    EXPECT_EQ(excess->text, "a key of more than 16 parts");
  }
}

TEST(TextBounds, CountThePartsOfAKeyExactly) {
  EXPECT_FALSE(toml_excess("a" + repeated(".a", 15) + " = 1"));
  EXPECT_TRUE(toml_excess("a" + repeated(".a", 16) + " = 1"));
  EXPECT_FALSE(toml_excess(repeated("[", 16)));
  EXPECT_TRUE(toml_excess(repeated("[", 17)));
  EXPECT_FALSE(json_excess(repeated("[", 64)));
  EXPECT_TRUE(json_excess(repeated("[{\"\":", 33)));
}

TEST(TextBounds, RefuseNestingBehindStringsThatLookOpen) {
  const std::string deep = repeated("[", 100'000);
  for (const std::string& before :
       {std::string("a = \"\"\n"), std::string("a = ''\n"), std::string("a = \"\\\"\"\n"),
        std::string("a = \"\"\"\"\"\"\n"), std::string("a = \"\"\"x\"\"\"\"\"\n"),
        std::string("a = '''x''''\n"), std::string("a = 'x\\'\n"), std::string("# \"\n"),
        std::string("a = \"\"\"\\\"\"\"\"\n"), std::string("a = \"x\n")}) {
    const auto excess = toml_excess(before + "b = " + deep);
    ASSERT_TRUE(excess) << before;
    EXPECT_EQ(excess->line, 2U) << before;
    EXPECT_EQ(excess->column, 21U) << before;
  }
}

TEST(TextBounds, RefuseDeepJsonButNotItsStrings) {
  EXPECT_FALSE(json_excess(R"({"a":"[[[[\"[[[[","b":[1,2]})", {.bytes = 1000, .nesting = 2}));
  EXPECT_TRUE(json_excess(R"({"a":"\\","b":[[1]]})", {.bytes = 1000, .nesting = 2}));
}

TEST(TextBounds, RefuseTextThatIsTooLong) {
  EXPECT_EQ(toml_excess(std::string((2U << 20U) + 1, '\n'), {.bytes = 2U << 20U})->text,
            "longer than 2 MiB");
  EXPECT_FALSE(toml_excess(std::string(toml_bounds.bytes, '\n')));
  EXPECT_TRUE(toml_excess(std::string(toml_bounds.bytes + 1, '\n')));
}

}  // namespace
}  // namespace stanok
