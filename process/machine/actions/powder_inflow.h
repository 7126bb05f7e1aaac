// Powder that comes in during a scene: a hopper that keeps a shoe full, or a portion poured between passages.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// Where and how powder comes in. SI units.
struct PowderInflow {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = Eigen::Vector3d::Zero();  ///< m, at the start
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s of the grains that come in, besides the tool's
  std::optional<double> mass;                          ///< kg in all; nothing: until the step is stopped
  std::optional<double> rate;  ///< kg/s; nothing: as fast as room comes free, as out of a full hopper
  std::string with;            ///< name of the tool that the box goes along with; empty: it stands
  std::string powder;          ///< name of the powder; empty: the mixture of all by their shares
  std::string where;           ///< place in the scene file, for messages
};

class Inflow final : public Step {
 public:
  explicit Inflow(PowderInflow inflow) : inflow_(std::move(inflow)) {}
  /// With a mass the run ends the step when the powder is in.
  bool open_ended() const override { return !inflow_.mass; }
  std::optional<double> duration() const override { return std::nullopt; }
  const PowderInflow* inflow() const override { return &inflow_; }
  std::string description() const override;

 private:
  PowderInflow inflow_;
};

/// Reads a step of kind "inflow".
std::shared_ptr<Step> read_inflow(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
