// Files for NumPy: fixed bytes of their records, numbers that come back with their bits, and what
// happens where nothing can be written.
#include "jobs/npz/npz_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <random>

#include "jobs/npz/npy_texts.h"
#include "tests/jobs/npz/npz_reader.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::string_literals;

std::filesystem::path npz_path(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(::testing::TempDir()) / (test->name() + ("." + name));
}

// As numpy.save of NumPy 1.24 writes it.
TEST(NpyHeader, HasTheBytesOfNumPy) {
  const std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }";
  const std::array<std::int64_t, 1> row{3};
  EXPECT_EQ(npy_header("<f8", row),
            "\x93NUMPY\x01\x00\x76\x00"s + text + std::string(118 - text.size() - 1, ' ') + "\n");
  const std::array<std::int64_t, 2> matrix{3, 5};
  EXPECT_THAT(npy_header("<i8", matrix), HasSubstr("'shape': (3, 5), }"));
}

TEST(NpyHeader, EndsAtAMultipleOf64Bytes) {
  for (std::int64_t size = 1; size < std::int64_t{1} << 56; size *= 10) {
    const std::array<std::int64_t, 2> shape{size, 8};
    EXPECT_EQ(npy_header("|i1", shape).size() % 64, 0U) << size;
  }
}

TEST(NpyHeader, NamesTheTypesOfNumbers) {
  EXPECT_EQ(npy_type<double>(), "<f8");
  EXPECT_EQ(npy_type<std::int64_t>(), "<i8");
  EXPECT_EQ(npy_type<std::int32_t>(), "<i4");
  EXPECT_EQ(npy_type<std::int16_t>(), "<i2");
  EXPECT_EQ(npy_type<std::int8_t>(), "|i1");
}

// APPNOTE, 4.3.7: signature, version 2.0, no flags, stored, 1980-01-01 00:00, sum, sizes, name.
TEST(ZipRecords, LocalHeaderHasItsFixedBytes) {
  EXPECT_EQ(zip_local_header({.name = "a.npy", .offset = 7, .bytes = 0x1234, .sum = 0xCBF43926}),
            "PK\x03\x04\x14\x00\x00\x00\x00\x00\x00\x00\x21\x00\x26\x39\xF4\xCB"
            "\x34\x12\x00\x00\x34\x12\x00\x00\x05\x00\x00\x00"
            "a.npy"s);
}

TEST(ZipRecords, DirectoryHasItsFixedBytes) {
  const std::vector<ZipMember> members{
      {.name = "a.npy", .offset = 7, .bytes = 0x1234, .sum = 0xCBF43926}};
  EXPECT_EQ(zip_directory(members, 0x2000),
            "PK\x01\x02\x14\x00\x14\x00\x00\x00\x00\x00\x00\x00\x21\x00\x26\x39\xF4\xCB"
            "\x34\x12\x00\x00\x34\x12\x00\x00\x05\x00\x00\x00\x00\x00\x00\x00\x00\x00"
            "\x00\x00\x00\x00\x07\x00\x00\x00"
            "a.npy"
            "PK\x05\x06\x00\x00\x00\x00\x01\x00\x01\x00\x33\x00\x00\x00\x00\x20\x00\x00\x00\x00"s);
}

// APPNOTE, 4.5.3: both sizes stand in the extra field 1, and where the member begins.
TEST(ZipRecords, LargeSizesStandInFieldsOfZip64) {
  const std::int64_t large = std::int64_t{5} << 32;
  const std::string header = zip_local_header({.name = "a", .offset = 0, .bytes = large, .sum = 0});
  EXPECT_EQ(header.substr(4, 2), "\x2D\x00"s);
  EXPECT_EQ(header.substr(18),
            "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x01\x00\x14\x00"
            "a\x01\x00\x10\x00"
            "\x00\x00\x00\x00\x05\x00\x00\x00\x00\x00\x00\x00\x05\x00\x00\x00"s);
  const std::vector<ZipMember> members{{.name = "a", .offset = large, .bytes = 3, .sum = 0}};
  EXPECT_THAT(zip_directory(members, 0),
              HasSubstr("a\x01\x00\x08\x00\x00\x00\x00\x00\x05\x00\x00\x00"s));
}

struct Numbers {
  std::vector<double> doubles;
  std::vector<std::int8_t> bytes;
  std::vector<std::int64_t> matrix;  // rows of three
};

Numbers random_numbers(std::size_t rows, unsigned seed) {
  std::mt19937_64 random(seed);
  Numbers numbers;
  for (std::size_t k = 0; k < rows; ++k) {
    numbers.doubles.push_back(std::bit_cast<double>(random()));
    numbers.bytes.push_back(static_cast<std::int8_t>(random() % 256));
    for (int i = 0; i < 3; ++i) numbers.matrix.push_back(static_cast<std::int64_t>(random()));
  }
  return numbers;
}

void write_numbers(const Numbers& numbers, const std::filesystem::path& path,
                   std::int64_t plain_max) {
  const auto rows = static_cast<std::int64_t>(numbers.doubles.size());
  auto file = NpzFile::create(
      path,
      {npy_array<double>("doubles", {rows}), npy_array<std::int8_t>("bytes", {rows}),
       npy_array<std::int64_t>("matrix", {rows, 3})},
      plain_max);
  ASSERT_TRUE(file);
  for (std::size_t k = 0; k < numbers.doubles.size(); ++k) {  // row by row, as a log gives them
    (*file)->add(0, numbers.doubles[k]);
    (*file)->add(1, numbers.bytes[k]);
    for (std::size_t i = 0; i < 3; ++i) (*file)->add(2, numbers.matrix[3 * k + i]);
  }
  ASSERT_FALSE((*file)->finish());
}

void expect_numbers(const NpzReader& reader, const Numbers& numbers) {
  ASSERT_THAT(reader.arrays(), SizeIs(3));
  const std::string rows = std::to_string(numbers.doubles.size());
  const ReadArray& doubles = reader.arrays().at("doubles");
  EXPECT_EQ(doubles.header, "{'descr': '<f8', 'fortran_order': False, 'shape': (" + rows + ",), }");
  const std::size_t bytes = numbers.doubles.size() * sizeof(double);
  ASSERT_EQ(doubles.bytes.size(), bytes);
  EXPECT_TRUE(bytes == 0 || std::memcmp(doubles.bytes.data(), numbers.doubles.data(), bytes) == 0);
  EXPECT_EQ(reader.arrays().at("bytes").numbers<std::int8_t>(), numbers.bytes);
  EXPECT_EQ(reader.arrays().at("matrix").header,
            "{'descr': '<i8', 'fortran_order': False, 'shape': (" + rows + ", 3), }");
  EXPECT_EQ(reader.arrays().at("matrix").numbers<std::int64_t>(), numbers.matrix);
}

// Fewer and more rows than are held at a time; also those that no number has.
TEST(NpzFile, GivesNumbersBackWithTheirBits) {
  for (const std::size_t rows : {0U, 1U, 63U, 5000U, 40'000U}) {
    const Numbers numbers = random_numbers(rows, 1);
    const auto path = npz_path("npz");
    write_numbers(numbers, path, zip_plain_max);
    const NpzReader reader(content_of(path));
    EXPECT_FALSE(reader.has_zip64());
    expect_numbers(reader, numbers);
  }
}

// As if 4 GiB were so few bytes: the directory, places, or sizes are above.
TEST(NpzFile, IsReadWithFieldsOfZip64) {
  const Numbers numbers = random_numbers(20, 2);
  const auto path = npz_path("npz");
  write_numbers(numbers, path, zip_plain_max);
  const auto size = static_cast<std::int64_t>(content_of(path).size());
  for (std::int64_t plain_max = 0; plain_max < size; plain_max += 13) {
    write_numbers(numbers, path, plain_max);
    const NpzReader reader(content_of(path));
    constexpr std::int64_t largest = 128 + 20 * 3 * 8;  // member, `matrix`
    EXPECT_EQ(reader.has_zip64(), plain_max < largest) << plain_max;
    expect_numbers(reader, numbers);
  }
}

// Characters of one, two, three and four bytes; one that is none.
TEST(NpzFile, HasTextsOfFourByteCharacters) {
  const NpyTexts texts =
      npy_texts("axes", {"X1", "\xD0\xA6", "\xE2\x82\xAC", "\xF0\x9F\x98\x80\xFF"});
  EXPECT_EQ(texts.array.type, "<U2");
  EXPECT_EQ(texts.array.item_bytes, 8);
  EXPECT_THAT(texts.array.shape, ElementsAre(4));
  EXPECT_EQ(texts.bytes,
            "X\0\0\0"
            "1\0\0\0\x26\x04\0\0\0\0\0\0\xAC\x20\0\0\0\0\0\0\0\xF6\x01\0\xFD\xFF\0\0"s);
  EXPECT_EQ(npy_texts("none", {""}).array.type, "<U1");
}

TEST(NpzFile, SaysThatTheDiskIsFull) {
  auto file = NpzFile::create("/dev/full", {npy_array<double>("x", {2})});
  ASSERT_TRUE(file);
  (*file)->add(0, 1.0);
  (*file)->add(0, 2.0);
  const auto error = (*file)->finish();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->text, "cannot write /dev/full: No space left on device");
  file->reset();
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST(NpzFile, SaysThatAPipeIsNoPlaceForIt) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  auto file = NpzFile::create("/proc/self/fd/" + std::to_string(ends[1]), {});
  ASSERT_TRUE(file);
  const auto error = (*file)->finish();
  ASSERT_TRUE(error);
  EXPECT_THAT(error->text, HasSubstr("give a file, not a pipe"));
  file->reset();
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(NpzFile, SaysWhyItCannotBeMade) {
  const auto none = NpzFile::create(npz_path("no") / "folder.npz", {});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().text, HasSubstr("folder.npz: No such file or directory"));
}

TEST(NpzFile, LeavesNoHalfFile) {
  const auto path = npz_path("npz");
  {
    const auto file = NpzFile::create(path, {npy_array<double>("x", {1000})});
    ASSERT_TRUE(file);
    (*file)->add(0, 1.0);
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace stanok::jobs
