// generate_programs: writes the two workloads of the experiment with their paths and limits.
//
//   generate_programs --out DIR [--scale full|small] [--feed-low F --feed-high F] [--decimals N]
//                     [--start X,Y,Z,B,C] [--path-blocks FIRST:LAST]
// DIR gets NAME, NAME.path.csv and NAME.limits.json for each program.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "programs/generators/car_body.h"
#include "programs/generators/impeller_blade.h"
#include "programs/generators/path_files.h"

namespace {

using namespace stanok::programs;

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

void write_workload(const std::filesystem::path& folder, const Workload& workload,
                    const BlockRange& range) {
  write_file(folder / workload.name, workload.program.text());
  write_file(folder / (workload.name + ".path.csv"), path_csv(workload, range));
  write_file(folder / (workload.name + ".limits.json"), limits_json(workload));
  std::cout << workload.name << ": " << workload.program.blocks() << " blocks, "
            << workload.program.text().size() << " bytes, " << workload.program.feed_time_s()
            << " s at its feeds\n";
}

// The exit code; throws what cannot be written.
int run(int argc, char** argv) {
  CLI::App app("Writes the part programs of the two-program workload with their paths and limits.");
  std::string folder;
  WorkloadOptions options;
  std::vector<double> start;
  BlockRange range;
  app.add_option("--out", folder, "folder for the files")->type_name("FOLDER")->required();
  app.add_option("--scale", options.scale, "full: as in the experiment; small: under a minute")
      ->transform(CLI::CheckedTransformer(
                      std::map<std::string, Scale>{{"full", Scale::full}, {"small", Scale::small}})
                      .description(""))
      ->type_name("full|small");
  app.add_option("--feed-low", options.feed_low, "three-axis feed on steep parts, mm/min")
      ->check(CLI::PositiveNumber);
  app.add_option("--feed-high", options.feed_high, "three-axis feed on flat parts, mm/min")
      ->check(CLI::PositiveNumber);
  app.add_option("--decimals", options.decimals, "decimals of the coordinates")
      ->check(CLI::Range(2, 8));
  app.add_option("--start", start, "first point of the path: X,Y,Z or X,Y,Z,B,C")
      ->delimiter(',')
      ->expected(3, 5);
  app.add_option_function<std::string>(
      "--path-blocks",
      [&](const std::string& text) {
        char colon = 0;
        std::istringstream stream(text);
        if (!(stream >> range.first >> colon >> range.last) || colon != ':') {
          throw CLI::ValidationError("--path-blocks", "FIRST:LAST expected");
        }
      },
      "only these blocks in the path files");
  CLI11_PARSE(app, argc, argv);

  std::copy(start.begin(), start.end(), options.start.begin());
  std::filesystem::create_directories(folder);
  write_workload(folder, car_body(options), range);
  write_workload(folder, impeller_blade(options), range);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "generate_programs: " << error.what() << '\n';
    return 1;
  }
}
