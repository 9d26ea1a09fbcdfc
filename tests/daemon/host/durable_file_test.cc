// Files that survive: a save that ends anywhere, a file cut at any byte, any bit flipped.
#include "daemon/host/durable_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using ::testing::HasSubstr;

constexpr DurableKind kind{.name = "tables", .version = 1};

class DurableFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder.path() / "tables.toml"; }
  [[nodiscard]] static std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  static void put(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string text() const {
    const auto read = read_durably(file(), kind);
    if (!read) return "refused: " + read.error();
    return *read ? (*read)->text : "none";
  }

  stanok::testing::TemporaryDirectory folder;
};

TEST_F(DurableFile, ComesBackAsItWas) {
  EXPECT_EQ(text(), "none");
  ASSERT_FALSE(write_durably(file(), kind, "one\n"));
  EXPECT_EQ(text(), "one\n");
  ASSERT_FALSE(write_durably(file(), kind, "two\n"));
  EXPECT_EQ(text(), "two\n");
  EXPECT_THAT(bytes_of(previous_copy(file())), HasSubstr("one\n"));
}

// Whatever is cut off or flipped, the copy before is used and said so; without one it is refused.
TEST_F(DurableFile, DamageOfAnyKindIsFoundAndThePreviousCopyUsed) {
  ASSERT_FALSE(write_durably(file(), kind, "[[tool]]\nnumber = 1\n"));
  ASSERT_FALSE(write_durably(file(), kind, "[[tool]]\nnumber = 2\n"));
  const std::string whole = bytes_of(file());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    put(file(), whole.substr(0, length));
    EXPECT_EQ(text(), "[[tool]]\nnumber = 1\n") << length;
  }
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ static_cast<char>(1U << (bit % 8)));
    put(file(), flipped);
    const std::string read = text();
    const bool is_newer = read.starts_with("refused") && read.find("newer") != std::string::npos;
    EXPECT_TRUE(read == "[[tool]]\nnumber = 1\n" || is_newer) << bit << " " << read;
  }
  std::filesystem::remove(previous_copy(file()));
  EXPECT_THAT(text(), HasSubstr("no good previous copy"));
}

TEST_F(DurableFile, OfANewerVersionIsRefusedNotOverwritten) {
  ASSERT_FALSE(write_durably(file(), {.name = "tables", .version = 2}, "x"));
  EXPECT_THAT(text(), HasSubstr("newer"));
}

TEST_F(DurableFile, AFolderThatIsGoneIsTold) {
  const auto fault = write_durably(folder.path() / "none" / "tables.toml", kind, "x");
  ASSERT_TRUE(fault);
  EXPECT_THAT(*fault, HasSubstr("No such file"));
}

// Killed in the middle of saving, 200 times at random: what is read is always a text that was saved
// whole, and never older than the one before the last that was finished.
TEST_F(DurableFile, ASaveThatIsKilledAnywhereLeavesAGoodFile) {
  std::mt19937 random(11);
  ASSERT_FALSE(write_durably(file(), kind, "0"));
  for (int trial = 0; trial < 200; ++trial) {
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int k = 0;; ++k)
        static_cast<void>(
            write_durably(file(), kind, std::string(5000, static_cast<char>('a' + k % 26))));
    }
    ::usleep(static_cast<::useconds_t>(random() % 3000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string read = text();
    const bool is_whole = read == "0" || (read.size() == 5000 &&
                                          read.find_first_not_of(read[0]) == std::string::npos);
    ASSERT_TRUE(is_whole) << trial << " " << read.substr(0, 80);
  }
}

}  // namespace
}  // namespace stanok::daemon
