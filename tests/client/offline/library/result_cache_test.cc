// Results by digest: taken while every text is what it was, and never else.
#include "client/offline/library/result_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "client/offline/library/digest.h"
#include "runtime/program_files.h"
#include "runtime/text_book.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

class ResultCacheTest : public ::testing::Test {
 protected:
  ResultCacheTest() {
    write("part.nc", "#include \"sub.nc\"\nM30\n");
    write("sub.nc", "G0 X1\n");
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  [[nodiscard]] runtime::ProgramFiles files(runtime::TextBook* book = nullptr) const {
    return {{folder_.path()}, {1U << 20U, ""}, book};
  }
  // As a check reads them: the program, what it includes, and what is not there.
  [[nodiscard]] std::vector<recording::ProgramRead> reads() const {
    runtime::TextBook book;
    const auto texts = files(&book);
    const auto part = texts.read("part.nc", "");
    EXPECT_TRUE(part);
    EXPECT_TRUE(texts.read("sub.nc", (*part)->path));
    EXPECT_FALSE(texts.read("missing.nc", (*part)->path));
    return book.take();
  }
  [[nodiscard]] std::vector<fs::path> entries() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(cache_.path())) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    return found;
  }

  testing::TemporaryDirectory folder_;
  testing::TemporaryDirectory cache_;
  ResultCache cache{cache_.path(), "machine"};
};

TEST_F(ResultCacheTest, GivesWhatItWasGiven) {
  EXPECT_FALSE(cache.find("part.nc", files()));
  const std::string result("\x00\xff bytes", 8);
  ASSERT_TRUE(cache.keep("part.nc", reads(), result));
  EXPECT_EQ(cache.find("part.nc", files()), result);
  ASSERT_TRUE(cache.keep("part.nc", reads(), "another"));
  EXPECT_EQ(cache.find("part.nc", files()), "another");
  EXPECT_EQ(entries().size(), 1U);
}

TEST_F(ResultCacheTest, IsOfOneProgramAndOneContext) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), "result"));
  EXPECT_FALSE(cache.find("sub.nc", files()));
  EXPECT_FALSE(ResultCache(cache_.path(), "another machine").find("part.nc", files()));
}

TEST_F(ResultCacheTest, IsNoneWhenATextHasChanged) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), "result"));
  write("sub.nc", "G0 X2\n");
  EXPECT_FALSE(cache.find("part.nc", files()));
  write("sub.nc", "G0 X1\n");
  EXPECT_TRUE(cache.find("part.nc", files()));
  fs::remove(folder_.path() / "sub.nc");
  EXPECT_FALSE(cache.find("part.nc", files()));
}

TEST_F(ResultCacheTest, IsNoneWhenAFileThatWasMissingIsThere) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), "result"));
  write("missing.nc", "M99\n");
  EXPECT_FALSE(cache.find("part.nc", files()));
}

TEST_F(ResultCacheTest, IsNoneWhenAnEarlierFolderHasAFileOfThatName) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), "result"));
  fs::create_directory(folder_.path() / "first");
  write("first/sub.nc", "G0 X1\n");
  const runtime::ProgramFiles other({folder_.path() / "first", folder_.path()}, {1U << 20U, ""});
  EXPECT_TRUE(cache.find("part.nc", other)) << "sub.nc is found beside part.nc";
  fs::remove(folder_.path() / "sub.nc");
  EXPECT_FALSE(cache.find("part.nc", other));
}

TEST_F(ResultCacheTest, TakesNothingThatIsDamaged) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), std::string(500, 'r')));
  const fs::path entry = entries().at(0);
  std::ifstream stream(entry, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 0x15);
    std::ofstream(entry, std::ios::binary | std::ios::trunc) << changed;
    const auto found = cache.find("part.nc", files());
    EXPECT_TRUE(!found || *found == std::string(500, 'r')) << "byte " << place;
    std::ofstream(entry, std::ios::binary | std::ios::trunc) << whole.substr(0, place);
    EXPECT_FALSE(cache.find("part.nc", files())) << "cut at " << place;
  }
}

TEST_F(ResultCacheTest, TakesNothingThatIsNestedWithoutEnd) {
  ASSERT_TRUE(cache.keep("part.nc", reads(), "result"));
  constexpr char array_of_one = static_cast<char>(0x81);
  std::ofstream(entries().at(0), std::ios::binary | std::ios::trunc)
      << std::string(10'000'000, array_of_one);
  EXPECT_FALSE(cache.find("part.nc", files()));
}

TEST_F(ResultCacheTest, SaysThatItCannotBeWritten) {
  const auto file = folder_.path() / "file";
  write("file", "");
  EXPECT_FALSE(ResultCache(file, "machine").keep("part.nc", reads(), "result"));
}

// RFC 7693 has no test of 32 bytes; these are of b2sum -l 256.
TEST(Digest, IsBlake2b) {
  const std::string empty = Digest().text();
  EXPECT_EQ(empty, "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
  EXPECT_NE(Digest().add("ab").add("c").text(), Digest().add("a").add("bc").text());
}

}  // namespace
}  // namespace stanok::client
