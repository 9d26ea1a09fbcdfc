// What code means does not depend on which sources are compiled as one unit
// (cmake/StanokTargets.cmake): where two of them may be joined, no name of an unnamed namespace is
// also one of the other. Joined, two functions of one name would silently become overloads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/layering/repository.h"
#include "tests/support/declared_names.h"
#include "tests/support/source_tree.h"

namespace stanok::testing {
namespace {

using ScopedName = std::pair<std::string, std::string>;  // "stanok::lang", "word_of"
using FilesOfNames = std::map<ScopedName, std::set<std::string>>;

std::string text_of(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) text += line + "\n";
  return text;
}

bool includes(const SourceFile& file, const std::string& header) {
  return std::ranges::find(file.lines, "#include \"" + header + "\"") != file.lines.end();
}

// Each as "name: file, file": names of unnamed namespaces in two files of a library, and those that
// a header of the library declares, too, which their file does not include.
std::vector<std::string> clashes(const std::vector<SourceFile>& library) {
  FilesOfNames in_headers;
  FilesOfNames in_unnamed;
  std::map<std::string, const SourceFile*> files;
  for (const SourceFile& file : library) {
    files[file.path] = &file;
    for (const DeclaredName& declared : declared_names(text_of(file))) {
      const ScopedName name(declared.scope, declared.name);
      if (declared.is_unnamed) in_unnamed[name].insert(file.path);
      if (!declared.is_unnamed && file.is_header()) in_headers[name].insert(file.path);
    }
  }
  std::vector<std::string> found;
  for (const auto& [name, paths] : in_unnamed) {
    for (auto path = paths.begin(); path != paths.end(); ++path) {
      for (auto other = std::next(path); other != paths.end(); ++other)
        found.push_back(name.second + ": " + *path + ", " + *other);
      for (const std::string& header : in_headers[name]) {
        if (*path != header && !includes(*files[*path], header))
          found.push_back(name.second + ": " + *path + ", " + header);
      }
    }
  }
  return found;
}

// What the first group of the expression matches, everywhere in a file.
std::set<std::string> found_in(const std::filesystem::path& file, const std::string& expression) {
  std::ifstream stream(repository / file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::regex wanted(expression);
  std::set<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), wanted);
       match != std::sregex_iterator(); ++match) {
    found.insert((*match)[1].str());
  }
  return found;
}

// The folders whose modules are joined with each other.
std::set<std::string> folders_compiled_whole() {
  std::set<std::string> folders;
  for (const std::string& list :
       found_in("cmake/StanokTargets.cmake", R"(set\(stanok_compiled_whole ([^)]+)\))")) {
    static const std::regex word(R"(\S+)");
    folders.insert(std::sregex_token_iterator(list.begin(), list.end(), word),
                   std::sregex_token_iterator());
  }
  return folders;
}

// The files that may be joined, by their library; the main functions never are.
std::map<std::string, std::vector<SourceFile>> joined_files() {
  const Layers layers = read_layers(layering);
  const std::set<std::string> whole = folders_compiled_whole();
  const std::set<std::string> mains = found_in("CMakeLists.txt", R"(MAIN\s+(\S+))");
  std::map<std::string, std::vector<SourceFile>> libraries;
  for (const SourceFile& file : source_files(repository)) {
    if (leaves.contains(file.folder) || mains.contains(file.path)) continue;
    const std::string library =
        whole.contains(file.folder) ? file.folder : library_of(layers, file.path);
    libraries[library].push_back(file);
  }
  return libraries;
}

TEST(Layering, NamesInUnnamedNamespacesAreUniqueInTheirLibrary) {
  const auto libraries = joined_files();
  ASSERT_TRUE(libraries.contains("lang"));
  ASSERT_TRUE(libraries.contains("gateway/history"));
  for (const auto& [library, files] : libraries) {
    for (const std::string& clash : clashes(files)) ADD_FAILURE() << clash;
  }
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (const DeclaredName& declared : declared_names(text)) {
    const std::string inside = declared.is_unnamed ? "::()" : "";
    names.push_back(declared.scope + inside + "::" + declared.name);
  }
  return names;
}

constexpr std::string_view text_of_all_kinds = R"(#define not_here(x) \
  x
namespace a::b {
namespace {

namespace fs = std::filesystem;
using Vector = std::array<double, 3>;
using std::min;
static_assert(sizeof(int) == 4);

constexpr double step = 0.5;  // not_here(1)
constexpr std::array<Row, 2> rows{Row{1, "not_here("},
                                  Row{2, R"x(
not_here();
)x"}};
const char letters[] = {'{', 'b'};
int (*const made)(int) = nullptr;

struct Move {
  double way_mm() const { return 0.0; }
};
class alignas(64) Slot;
enum class Kind { one, two };
enum Place : std::size_t { first, second = 4 };

template <class Value, class... Others>
Value sum(const Value& value, Others... others) {
  return inner(value);
}

[[noreturn]] void fail(int error) {
  throw error;
}

std::array<std::function<double(int)>, 1U << 4> laws_of(
    const std::map<int, double>& values) RT_SAFE {
  const auto inner = [](int k) { return k; };
}

const std::map<std::string, std::vector<double>>&
name_behind_its_type(int k) {
}

bool operator<(const Move& a, const Move& b) {
}
double Move::far() const {
}

}  // namespace

int named(int x) {
  return x;
}

}  // namespace a::b
)";

TEST(Layering, EveryKindOfNameIsFound) {
  EXPECT_THAT(
      names_in(text_of_all_kinds),
      ::testing::UnorderedElementsAre(
          "a::b::()::Vector", "a::b::()::step", "a::b::()::rows", "a::b::()::letters",
          "a::b::()::made", "a::b::()::Move", "a::b::()::Slot", "a::b::()::Kind", "a::b::()::Place",
          "a::b::()::first", "a::b::()::second", "a::b::()::sum", "a::b::()::fail",
          "a::b::()::laws_of", "a::b::()::name_behind_its_type", "a::b::named"));
}

SourceFile source(const std::string& path, std::vector<std::string> lines) {
  return {.path = path, .folder = "a", .lines = std::move(lines)};
}

TEST(Layering, ANameInTwoUnnamedNamespacesIsFound) {
  const std::vector<std::string> begin{"namespace a {", "namespace {"};
  const auto with = [&](const std::string& line) {
    return std::vector<std::string>{begin[0], begin[1], line, "}  // namespace"};
  };
  EXPECT_THAT(clashes({source("a/x.cc", with("int word_of(int k);")),
                       source("a/y.cc", with("double word_of(double k);"))}),
              ::testing::ElementsAre("word_of: a/x.cc, a/y.cc"));
  EXPECT_THAT(clashes({source("a/x.cc", with("int word_of(int k);")),
                       source("a/y.cc", with("int word_at(int k);"))}),
              ::testing::IsEmpty());
  EXPECT_THAT(clashes({source("a/x.cc", with("int word_of(int k);")),
                       source("a/y.cc", {"namespace a::b {", "namespace {", "int word_of();"})}),
              ::testing::IsEmpty());
  EXPECT_THAT(clashes({source("a/x.cc", with("int word_of(int k);")),
                       source("a/z.h", {"namespace a {", "[[nodiscard]] double word_of();"})}),
              ::testing::ElementsAre("word_of: a/x.cc, a/z.h"));
  EXPECT_THAT(clashes({source("a/x.cc", {"#include \"a/z.h\"", "namespace a {", "namespace {",
                                         "int word_of(int k);"}),
                       source("a/z.h", {"namespace a {", "[[nodiscard]] double word_of();"})}),
              ::testing::IsEmpty());
}

}  // namespace
}  // namespace stanok::testing
