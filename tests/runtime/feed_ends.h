// Where the moves at feed of a program end, as its channel plans them: read, checked and divided,
// but not run.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {

using Point = Eigen::Vector3d;

inline constexpr double deg_of_plane = 180.0 / std::numbers::pi;

class PlaneProgram : public lang::Files {
 public:
  explicit PlaneProgram(std::string text) : text_(std::make_shared<lang::SourceText>()) {
    text_->name = text_->path = "plane.nc";
    text_->text = std::move(text);
  }
  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view, std::string_view) const override {
    return text_;
  }

 private:
  std::shared_ptr<lang::SourceText> text_;
};

inline channels::MachineConfig machine_called(const std::string& name) {
  return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                   "config" / "machines" / name)
      .machine;
}

// Where the axes stand at the ends of the moves at feed, and where the tip is in the base then.
struct FeedEnd {
  std::uint64_t block = 0;
  bool stops = false;
  motion::Point axes_M{};
  motion::Point tip_B{};
  Point tool_B;
  std::array<Point, 8> tools_B;  // on the way from the end before, while all axes move evenly
};

inline std::vector<FeedEnd> feed_ends(const channels::MachineConfig& machine,
                                      const std::string& text, int scheme = -1) {
  const PlaneProgram files(text);
  jobs::DryRun run(machine, 1, scheme, files);
  std::vector<FeedEnd> ends;
  const auto keep = [&](const lang::Command&, const motion::PathBlock* block) {
    if (block == nullptr || block->rapid) return;
    FeedEnd end;
    end.block = block->tag.block;
    end.stops = block->ending == motion::BlockEnding::exact_stop;
    const kinematics::Transform& transform = *block->transform;
    kinematics::inverse(transform, block->end, end.axes_M);
    transform.scheme->forward(kinematics::PointMode::tip, transform.tool, end.axes_M, end.tip_B);
    end.tool_B = transform.scheme->spindle_axes(end.tip_B)[2];
    const motion::Point before = ends.empty() ? end.tip_B : ends.back().tip_B;
    for (std::size_t k = 0; k < end.tools_B.size(); ++k) {
      const double way = static_cast<double>(k + 1) / static_cast<double>(end.tools_B.size());
      motion::Point between = before;
      for (std::size_t axis = 0; axis < between.size(); ++axis)
        between[axis] += way * (end.tip_B[axis] - before[axis]);
      end.tools_B[k] = transform.scheme->spindle_axes(between)[2];
    }
    ends.push_back(end);
  };
  const jobs::DryRunResult result =
      run.run("plane.nc", jobs::Reachability::checked, keep,
              [](const lang::ProgramRequest&, const lang::Command&) {});
  // Where the tool leaves a pole the axis that is free there turns first: the feed is out of reach.
  for (const Diagnostic& one : result.diagnostics) {
    if (one.code != "W810")
      ADD_FAILURE() << one.code << " line " << one.place.line << ": " << one.message;
  }
  return ends;
}

}  // namespace stanok::runtime
