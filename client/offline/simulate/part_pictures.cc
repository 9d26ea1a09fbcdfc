#include "client/offline/simulate/part_pictures.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "client/offline/library/whole_file.h"
#include "client/offline/workpiece/simulated_parts.h"

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

Diagnostic complaint(const std::string& code, std::string text) {
  Diagnostic made;
  made.code = code;
  made.severity = code.front() == 'W' ? Severity::warning : Severity::error;
  made.message = std::move(text);
  return made;
}

// A folder of its own that goes with it; nothing: none can be made.
class PassingFolder {
 public:
  PassingFolder() {
    std::string name = (fs::temp_directory_path() / "stanok-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~PassingFolder() {
    std::error_code ignored;
    if (path_) fs::remove_all(*path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  [[nodiscard]] const std::optional<fs::path>& path() const { return path_; }

 private:
  std::optional<fs::path> path_;
};

}  // namespace

PartPictures::PartPictures(const config::MachineFile& file, std::uint64_t memory_mib)
    : simulated_(std::make_shared<runtime::SimulatedWorkpieces>(
          file, memory_mib << 20U,
          [this](int channel, const std::string& code, const std::string& text) {
            complaints_.push_back(
                complaint(code, "channel " + std::to_string(channel) + ": " + text));
          })) {}

std::vector<std::string> PartPictures::drawn(const std::vector<channels::RunReport>& runs) {
  const FileNames names = names_of(runs);
  const std::vector<NamedWorkpiece> workpieces = finished_workpieces(*simulated_, names);
  if (workpieces.empty()) return {};
  const PassingFolder folder;
  if (!folder.path()) {
    complaints_.push_back(complaint("E9204", "no folder can be made in $TMPDIR"));
    return {};
  }
  const std::string file = (*folder.path() / "part.png").string();
  for (const std::string& failure :
       write_files(workpieces, {.stl = "", .picture = file, .report = ""}, names))
    complaints_.push_back(complaint("E9204", failure));
  std::vector<std::string> pictures;
  pictures.reserve(workpieces.size());
  for (std::size_t k = 0; k < workpieces.size(); ++k)
    pictures.push_back(bytes_in(numbered(file, k + 1)));
  return pictures;
}

fs::path picture_of(const Candidate& program, const fs::path& folder) {
  const fs::path path(program.path);
  const fs::path name =
      program.folder.empty()
          ? path.filename()
          : path.lexically_normal().lexically_relative(program.folder.lexically_normal());
  return folder / (name.string() + ".png");
}

void check_pictures(const Candidates& candidates, const fs::path& folder) {
  std::map<fs::path, std::string> known;
  for (const Candidate& program : candidates.programs) {
    const auto [picture, is_new] = known.emplace(picture_of(program, folder), program.path);
    if (is_new) continue;
    throw CLI::ValidationError(
        "--pictures", picture->second + " and " + program.path + " would both have the picture " +
                          picture->first.string() + "; name a folder above both");
  }
}

}  // namespace stanok::client
