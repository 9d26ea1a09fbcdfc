// Tables of a log whose numbers are known: rows of the process joined by cycle, and the same bits
// in the messages, in CSV and in .npz files.
#include "jobs/log_tables/log_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "jobs/log_tables/process_columns.h"
#include "recording/read/setpoint_walk.h"
#include "tests/jobs/npz/npz_reader.h"
#include "tests/recording/recorded_log.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr int period = 50;               // cycles of 1 ms between two messages
constexpr std::int64_t force_on = 1000;  // cycle

// Values that have no short text, each its own; force control comes on later, its sensor later
// still.
channels::CycleOutput cut_of(std::int64_t cycle) {
  channels::CycleOutput output = recording::output_of(cycle);
  channels::ProcessOutput& process = output.channels[0].process;
  const double t = static_cast<double>(cycle);
  process.law = motion::LawKind::interrupted;
  process.stands = cycle % (std::int64_t{2} * period) == 0;
  process.increments = 1'000'000 + static_cast<std::uint64_t>(cycle);
  process.feed_mm_per_min = 100.0 + std::sin(t);
  process.feed_mm_per_rev = 0.1 + 1e-3 * std::cos(t);
  process.spindle_rev_per_min = -1000.0 * std::sin(0.01 * t);
  process.cutting_speed_m_per_min = t / 3.0;
  process.has_force_control = true;
  if (cycle < force_on) return output;
  const double none = std::numeric_limits<double>::quiet_NaN();
  process.force = {.state = motion::ForceState::regulating,
                   .force_set_n = 1200.0,
                   .force_now_n = 1200.0 + 60.0 * std::sin(t),
                   .force_n = 1100.0 + t / 7.0,
                   .power_w = cycle < 2 * force_on ? none : 2400.0 + t / 9.0,
                   .power_idle_w = 250.0 + t / 11.0,
                   .radius_mm = 30.0,
                   .feed_per_s = t / 700.0,
                   .feed_min_per_s = 0.5,
                   .feed_max_per_s = 6.1,
                   .vibration_um = -0.0,
                   .vibration_hz = t / 13.0,
                   .oscillation_n = 60.0,
                   .oscillation_hz = 4.0};
  return output;
}

constexpr int cycles_of_cut = 3001;

std::filesystem::path recorded_cut() {
  auto file = recording::test_file("lcm");
  auto writer = recording::LogWriter::open(file);
  EXPECT_TRUE(writer);
  recording::MessageStream stream(recording::small_machine(), {writer->get()});
  for (int cycle = 0; cycle < cycles_of_cut; ++cycle) stream.cycle(cut_of(cycle));
  EXPECT_TRUE((*writer)->flush());
  return file;
}

std::vector<ProcessRow> rows_of(const std::filesystem::path& log, int channel) {
  auto rows = ProcessRows::open(log, channel);
  EXPECT_TRUE(rows);
  std::vector<ProcessRow> list;
  while (auto row = rows->next()) list.push_back(*row);
  return list;
}

using Table = std::vector<std::vector<std::string>>;

Table cells_of(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = table.emplace_back(1);
    for (const char c : line) {
      if (c == ',') {
        row.emplace_back();
      } else {
        row.back() += c;
      }
    }
  }
  return table;
}

// Nothing is not a number.
double number_of(const std::string& cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

bool has_same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

Table exported_process(const std::filesystem::path& log) {
  const auto path = recording::test_file("csv");
  std::FILE* const csv = std::fopen(path.c_str(), "w");
  const auto rows = write_process_csv(log, 1, csv);
  EXPECT_EQ(std::fclose(csv), 0);
  EXPECT_TRUE(rows);
  return cells_of(content_of(path));
}

double value_of(const ProcessRow& row, std::string_view name) {
  return columns_named(process_columns(), {name}).front().value(row);
}

TEST(ProcessRows, JoinBothMessagesOfACycle) {
  const auto rows = rows_of(recorded_cut(), 1);
  ASSERT_THAT(rows, SizeIs((cycles_of_cut - 1) / period + 1));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ProcessRow& row = rows[k];
    EXPECT_EQ(row.cycle, period * static_cast<std::int64_t>(k));
    EXPECT_NEAR(row.time_s, 1e-3 * static_cast<double>(row.cycle), 1e-9);
    EXPECT_TRUE(row.process);
    EXPECT_EQ(row.force.has_value(), row.cycle >= force_on);
    EXPECT_EQ(std::isfinite(value_of(row, "power_w")), row.cycle >= 2 * force_on);
  }
  // Units of the columns: feeds of force control are mm/s in the message.
  const ProcessRow& last = rows.back();
  EXPECT_EQ(value_of(last, "law"), 3.0);
  EXPECT_EQ(value_of(last, "increments"), 1'003'000.0);
  EXPECT_EQ(value_of(last, "force_set_n"), 1200.0 + 60.0 * std::sin(3000.0));
  EXPECT_EQ(value_of(last, "force_set_mean_n"), 1200.0);
  EXPECT_DOUBLE_EQ(value_of(last, "feed_requested_mm_min"), 60.0 * 3000.0 / 700.0);
  EXPECT_DOUBLE_EQ(value_of(last, "feed_min_mm_min"), 30.0);
  EXPECT_DOUBLE_EQ(value_of(last, "feed_max_mm_min"), 366.0);
  EXPECT_THAT(rows_of(recorded_cut(), 2), SizeIs(0));
}

TEST(ProcessRows, ALogTellsWhichChannelsHaveThem) {
  const auto contents = recording::read_contents(recorded_cut());
  ASSERT_TRUE(contents);
  EXPECT_TRUE(has_process_rows(*contents, 1));
  EXPECT_FALSE(has_process_rows(*contents, 2));
  EXPECT_FALSE(has_process_rows(*contents, 11));
}

TEST(ProcessColumns, HaveAMeaningAndEndWithTheirUnit) {
  std::set<std::string_view> names;
  for (const Column<ProcessRow>& column : process_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.meaning.empty()) << column.name;
    if (column.unit.empty()) continue;
    std::string unit(column.unit);
    for (char& c : unit) c = c == '/' ? '_' : static_cast<char>(std::tolower(c));
    EXPECT_TRUE(column.name.ends_with("_" + unit)) << column.name;
  }
}

TEST(ProcessTables, CsvAndArraysHaveTheBitsOfTheMessages) {
  const auto log = recorded_cut();
  const auto rows = rows_of(log, 1);
  const Table table = exported_process(log);
  ASSERT_THAT(table, SizeIs(rows.size() + 1));
  const auto npz = recording::test_file("npz");
  ASSERT_EQ(write_process_npz(log, 1, npz), static_cast<std::int64_t>(rows.size()));
  const NpzReader reader(content_of(npz));
  ASSERT_THAT(reader.arrays(), SizeIs(process_columns().size()));
  for (std::size_t c = 0; c < process_columns().size(); ++c) {
    const Column<ProcessRow>& column = process_columns()[c];
    ASSERT_EQ(table[0][c], column.name);
    const ReadArray& array = reader.arrays().at(std::string(column.name));
    std::vector<double> numbers = array.numbers<double>();
    if (is_cycle(column)) {
      EXPECT_THAT(array.header, HasSubstr("'<i8'"));
      const auto cycles = array.numbers<std::int64_t>();
      numbers.assign(cycles.begin(), cycles.end());
    }
    ASSERT_THAT(numbers, SizeIs(rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double value = column.value(rows[k]);
      ASSERT_EQ(table[k + 1][c].empty(), std::isnan(value)) << column.name;
      ASSERT_TRUE(has_same_bits(number_of(table[k + 1][c]), value)) << table[k + 1][c];
      ASSERT_TRUE(has_same_bits(numbers[k], value)) << column.name;
    }
  }
}

TEST(ProcessTables, CsvHasWholeNumbersWithoutAnExponent) {
  const Table table = exported_process(recorded_cut());
  EXPECT_EQ(table.back()[1], "3000");
  EXPECT_EQ(table[1][3], "1000000");  // increments
}

// What pictures show is what the table has, but for what a state or a time is.
TEST(ProcessColumns, ThinnedRowsHaveTheExtremesOfTheTable) {
  const auto rows = rows_of(recorded_cut(), 1);
  for (const std::size_t most : {1U, 7U, 60U}) {
    const NumberRows thin = thinned(rows, most, process_columns());
    ASSERT_LE(thin.size(), most);
    for (std::size_t c = 0; c < process_columns().size(); ++c) {
      const Column<ProcessRow>& column = process_columns()[c];
      if (column.together != Together::peak) continue;
      const double none = std::numeric_limits<double>::quiet_NaN();
      double of_rows = none;
      double of_thin = none;
      for (const ProcessRow& row : rows) of_rows = farther_from_zero(of_rows, column.value(row));
      for (const auto& row : thin) of_thin = farther_from_zero(of_thin, row[c]);
      EXPECT_TRUE(has_same_bits(of_thin, of_rows)) << column.name;
    }
  }
}

template <class Number, class Value>
void expect_array(const NpzReader& reader, const std::string& name,
                  const std::vector<setpoint_t>& setpoints, const Value& value) {
  std::vector<Number> expected;
  for (const setpoint_t& setpoint : setpoints) value(setpoint, expected);
  EXPECT_EQ(reader.arrays().at(name).numbers<Number>(), expected) << name;
}

TEST(SetpointNpz, HasTheNumbersOfTheMessages) {
  const auto log = recorded_cut();
  const auto contents = recording::read_contents(log);
  ASSERT_TRUE(contents);
  const auto npz = recording::test_file("npz");
  ASSERT_EQ(write_setpoints_npz(log, *contents, 1, npz), cycles_of_cut);
  std::vector<setpoint_t> setpoints;
  ASSERT_FALSE(recording::for_each_setpoint(
      log, *contents, 1, [&](const setpoint_t& setpoint) { setpoints.push_back(setpoint); }));
  const NpzReader reader(content_of(npz));
  expect_array<double>(reader, "time_s", setpoints, [&](const setpoint_t& s, auto& list) {
    list.push_back(static_cast<double>(s.utime - contents->utime_first) * 1e-6);
  });
  expect_array<std::int64_t>(reader, "cycle", setpoints,
                             [](const setpoint_t& s, auto& list) { list.push_back(s.cycle); });
  expect_array<std::int8_t>(reader, "flags", setpoints,
                            [](const setpoint_t& s, auto& list) { list.push_back(s.flags); });
  expect_array<std::int32_t>(reader, "run", setpoints,
                             [](const setpoint_t& s, auto& list) { list.push_back(s.run); });
  expect_array<std::int16_t>(reader, "file", setpoints,
                             [](const setpoint_t& s, auto& list) { list.push_back(s.file); });
  expect_array<double>(reader, "position", setpoints, [](const setpoint_t& s, auto& list) {
    list.insert(list.end(), s.position, s.position + 2);
  });
  expect_array<std::int64_t>(reader, "velocity_code", setpoints,
                             [](const setpoint_t& s, auto& list) {
                               list.insert(list.end(), s.velocity_code, s.velocity_code + 2);
                             });
  EXPECT_EQ(reader.arrays().at("position").header,
            "{'descr': '<f8', 'fortran_order': False, 'shape': (3001, 2), }");
  EXPECT_EQ(reader.arrays().at("axes").header,
            "{'descr': '<U2', 'fortran_order': False, 'shape': (2,), }");
  EXPECT_THAT(reader.arrays().at("units").numbers<char32_t>(),
              ElementsAre(U'm', U'm', 0, U'd', U'e', U'g'));
}

// As a log that somebody cuts, or goes on with, while it is exported.
TEST(SetpointNpz, KnowsThatALogHasChanged) {
  const auto log = recorded_cut();
  auto contents = recording::read_contents(log);
  ASSERT_TRUE(contents);
  const auto npz = recording::test_file("npz");
  recording::ChannelContents& told = contents->channels.at(recording::setpoint_channel);
  told.messages -= 100;
  EXPECT_EQ(write_setpoints_npz(log, *contents, 1, npz), cycles_of_cut - 100);
  told.messages += 200;
  const auto shorter = write_setpoints_npz(log, *contents, 1, npz);
  ASSERT_FALSE(shorter);
  EXPECT_THAT(shorter.error().text, HasSubstr("has changed while it was read"));
  EXPECT_FALSE(std::filesystem::exists(npz));
}

TEST(SetpointNpz, SaysThatTheDiskIsFull) {
  const auto log = recorded_cut();
  const auto contents = recording::read_contents(log);
  ASSERT_TRUE(contents);
  const auto full = write_setpoints_npz(log, *contents, 1, "/dev/full");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().text, "cannot write /dev/full: No space left on device");
  EXPECT_FALSE(write_process_npz(log, 1, "/dev/full"));
}

}  // namespace
}  // namespace stanok::jobs
