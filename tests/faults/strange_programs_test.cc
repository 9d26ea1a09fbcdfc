// Programs that are none, that are hostile, or that change under the machine: each is refused with
// its code or runs as it was loaded, and the daemon goes on.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <functional>

#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

std::string repeated(const std::string& text, int count) {
  std::string all;
  all.reserve(text.size() * static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) all += text;
  return all;
}

std::string utf_16_without_mark(const std::string& text) {
  std::string bytes;
  for (const char c : text) bytes += std::string{c, '\0'};
  return bytes;
}

// Every byte value, in an order without a pattern.
std::string binary(unsigned count) {
  std::string bytes;
  for (unsigned n = 0; n < count; ++n) bytes += static_cast<char>((n * 7919U + 13U) % 256U);
  return bytes;
}

constexpr int million = 1'000'000;
constexpr std::size_t ten_million = 10'000'000;

struct Strange {
  const char* name;
  const char* code;  // with which it is refused, or ends; empty: it runs
  // What stands at the path.
  std::function<void(const fs::path& file)> make;
  const char* program = "part.nc";  // as it is asked for
};

void PrintTo(const Strange& strange, std::ostream* stream) {
  *stream << strange.name;
}

// The text is made when the test runs: some of them are long.
Strange text(const char* name, const char* code, std::string (*bytes)()) {
  return {name, code,
          [bytes](const fs::path& file) { std::ofstream(file, std::ios::binary) << bytes(); }};
}

class StrangeProgram : public ::testing::TestWithParam<Strange> {};

TEST_P(StrangeProgram, IsAnsweredWithItsCodeAndTheNextOneRuns) {
  DaemonBench bench;
  if (GetParam().make) GetParam().make(bench.folder() / "part.nc");
  bench.program("sound.nc", "G90 G53 G0 X1\nM30\n");
  bench.demand("machine.on");
  bench.cycles(300);
  const auto outcome =
      bench.answer("program.run", {{"program", GetParam().program}, {"wait", "done"}});
  ASSERT_TRUE(outcome.has_value());
  const std::string code = *outcome ? "" : outcome->error().code;
  EXPECT_EQ(code, GetParam().code) << (*outcome ? "" : outcome->error().message);
  bench.demand("program.reset");
  bench.demand("program.run", {{"program", "sound.nc"}, {"wait", "done"}});
}

INSTANTIATE_TEST_SUITE_P(
    Files, StrangeProgram,
    ::testing::Values(
        Strange{"Missing", "E7001", {}},
        Strange{"Folder", "E7003", [](const fs::path& file) { fs::create_directory(file); }},
        Strange{"Fifo", "E7003",
                [](const fs::path& file) { ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0); }},
        Strange{"Device", "E7002",
                [](const fs::path& file) { fs::create_symlink("/dev/zero", file); }},
        Strange{"LinkOutOfTheRoot", "E7002",
                [](const fs::path& file) { fs::create_symlink("/etc/passwd", file); }},
        Strange{"LinkToItself", "E7002",
                [](const fs::path& file) { fs::create_symlink("part.nc", file); }},
        Strange{"WayOutOfTheRoot", "E7002", {}, "../../etc/passwd"},
        Strange{"AbsoluteName", "E7002", {}, "/etc/passwd"},
        Strange{"ControlCharacters", "E9003", {}, "part\n.nc"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Texts, StrangeProgram,
    ::testing::Values(text("Empty", "", [] { return std::string(); }),
                      text("WithByteOrderMark", "",
                           [] { return std::string("\xef\xbb\xbfG90 G53 G0 X2\nM30\n"); }),
                      text("Utf16", "E2001",
                           [] { return utf_16_without_mark("G90 G1 X1 F100\nM30\n"); }),
                      text("Binary", "E1001", [] { return binary(million); }),
                      text("LineOfTenMegabytes", "E1007",
                           [] { return "G1 X1" + std::string(ten_million, ' ') + "F100\nM30\n"; }),
                      text("CommentOfTenMegabytes", "",
                           [] { return "; " + std::string(ten_million, 'x') + "\nM30\n"; }),
                      text("NumberOfTenMegabytes", "E1002",
                           [] { return "G1 X" + std::string(ten_million, '1') + "\nM30\n"; }),
                      text("MillionParentheses", "E2030",
                           [] {
                             return "num aa = " + std::string(million, '(') + "1" +
                                    std::string(million, ')') + ";\nM30\n";
                           }),
                      text("MillionBrackets", "E2030",
                           [] {
                             return "G1 X" + std::string(million, '[') + "1" +
                                    std::string(million, ']') + "\nM30\n";
                           }),
                      text("HundredMegabytes", "",
                           [] {
                             return repeated("; " + std::string(97, 'x') + "\n", million) +
                                    "G90 G53 G0 X2\nM30\n";
                           })),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Runs, StrangeProgram,
    ::testing::Values(
        text("DivisionOfZeroByZero", "E3008",
             [] { return std::string("num zero = 0;\nG1 X=zero/zero F100\nM30\n"); }),
        text("Overflow", "E3009",
             [] { return std::string("num aa = 1e300;\nG1 X=aa*aa F100\nM30\n"); }),
        text("RootOfANegativeNumber", "E3009",
             [] { return std::string("num aa = -1;\nG1 X=sqrt(aa) F100\nM30\n"); }),
        text("RecursionWithoutEnd", "E8001",
             [] {
               return std::string(
                   "num deeper (num nn) { return deeper (nn + 1) + deeper (nn + 2); }\n"
                   "num aa = deeper (1);\nM30\n");
             }),
        text("IncludesItself", "", [] { return std::string("#include \"part.nc\"\nM30\n"); })),
    [](const auto& test) { return test.param.name; });

// A process that may open no more files has not lost the program.
TEST(ProgramWithoutADescriptor, IsToldAsWhatItIs) {
  DaemonBench bench;
  bench.program("part.nc", "G90 G53 G0 X1\nM30\n");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const auto outcome = bench.answer("program.load", {{"program", "part.nc"}});
  setrlimit(RLIMIT_NOFILE, &before);
  ASSERT_TRUE(outcome.has_value());
  ASSERT_FALSE(outcome->has_value());
  EXPECT_EQ(outcome->error().code, "E7004") << outcome->error().message;
  EXPECT_NE(outcome->error().message.find("Too many open files"), std::string::npos);
}

// An endless loop without motion is ended by a reset, at once.
TEST(EndlessProgram, IsOverWithAReset) {
  DaemonBench bench;
  bench.program("part.nc", "num aa = 0;\nwhile (true) {\naa = aa + 1;\n}\nM30\n");
  bench.demand("machine.on");
  bench.cycles(300);
  bench.demand("program.run", {{"program", "part.nc"}});
  bench.cycles(50);
  ASSERT_TRUE(bench.channel(1).running);
  EXPECT_TRUE(bench.answer("program.reset", {}, 100).has_value()) << "within 100 cycles of 1 ms";
  EXPECT_FALSE(bench.channel(1).running);
}

// The program that runs is the one that was loaded, whatever happens to its file.
TEST(ProgramFile, ThatIsChangedOrDeletedDuringTheRunChangesNothing) {
  for (const bool is_deleted : {true, false}) {
    DaemonBench bench;
    bench.program("part.nc", "G90 G53\nG0 X40\nG4 P0.2\nG0 X20\nM30\n");
    bench.demand("machine.on");
    bench.cycles(300);
    bench.demand("program.run", {{"program", "part.nc"}});
    bench.cycles(50);
    if (is_deleted) {
      fs::remove(bench.folder() / "part.nc");
    } else {
      bench.program("part.nc", "G1 X(\n");
    }
    for (int n = 0; n < 5000 && bench.channel(1).running; ++n) bench.cycle();
    EXPECT_NEAR(bench.channel(1).point_W[0].value, 20.0, 1e-9);
    EXPECT_EQ(bench.channel(1).state, channels::ChannelState::ready);
    const auto next = bench.answer("program.load", {{"program", "part.nc"}});
    ASSERT_TRUE(next.has_value() && !*next);
    EXPECT_EQ(next->error().code, is_deleted ? "E7001" : "E2001") << next->error().message;
  }
}

}  // namespace
}  // namespace stanok::daemon
