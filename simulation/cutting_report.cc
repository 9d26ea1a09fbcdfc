#include "simulation/cutting_report.h"

#include <algorithm>
#include <iterator>

#include "base/enum_array.h"

namespace stanok::simulation {
namespace {

struct Row {
  std::string_view code;
  std::string_view text;
};

constexpr EnumArray<FindingKind, Row> rows{
    Row{"W921", "a rapid traverse goes through material"},
    Row{"W922", "the shank of the tool is in the material"},
    Row{"W923", "the holder of the tool is in the material"},
    Row{"W924", "the tool cuts while the spindle stands"},
    Row{"W927", "a probe meets the part at rapid traverse"},
};

}  // namespace

std::string_view code_of(FindingKind kind) {
  return rows[kind].code;
}

std::string_view text_of(FindingKind kind) {
  return rows[kind].text;
}

void CuttingReport::add_finding(const Finding& finding) {
  // Those of one block come close behind each other.
  const auto end = findings_.rend();
  for (auto it = findings_.rbegin(); it != end; ++it) {
    if (!(it->origin == finding.origin)) break;
    if (it->kind != finding.kind) continue;
    it->volume_mm3 += finding.volume_mm3;
    return;
  }
  findings_.push_back(finding);
}

// What belongs to a block comes while it is the current one, or a few blocks later.
BlockRemoval& CuttingReport::block_of(const Origin& origin) {
  constexpr std::size_t latest = 128;
  const std::size_t oldest = blocks_.size() > latest ? blocks_.size() - latest : 0;
  for (std::size_t i = blocks_.size(); i-- > oldest;) {
    if (blocks_[i].origin == origin) return blocks_[i];
  }
  blocks_.push_back({.origin = origin});
  return blocks_.back();
}

void CuttingReport::add_removal(const Origin& origin, double volume_mm3) {
  block_of(origin).volume_mm3 += volume_mm3;
  removed_mm3_ += volume_mm3;
}

void CuttingReport::add_time(const Origin& origin, double seconds) {
  block_of(origin).time_s += seconds;
}

std::vector<Finding> CuttingReport::findings() const {
  std::vector<Finding> findings;
  std::ranges::copy_if(findings_, std::back_inserter(findings), [this](const Finding& finding) {
    return finding.volume_mm3 >= finding_min_mm3_;
  });
  return findings;
}

std::vector<BlockRemoval> CuttingReport::blocks() const {
  std::vector<BlockRemoval> removing;
  std::ranges::copy_if(blocks_, std::back_inserter(removing),
                       [](const BlockRemoval& block) { return block.volume_mm3 > 0.0; });
  return removing;
}

}  // namespace stanok::simulation
