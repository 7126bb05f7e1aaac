// Straight moves from rest to rest: a punch's stroke, core rods, a gate that opens, a shoe that is lifted;
// over one distance or from station to station.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/motions/straight_move.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// Parameters of a move from the scene. SI units.
struct MoveSpec {
  std::vector<std::string> tools;
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  ///< unit vector
  std::vector<double> stations;  ///< m along `direction` from where the step finds the tools, in turn
  double velocity = 0.02;        ///< m/s, once accelerated
  double acceleration = 10;      ///< m/s^2, also of braking
  double pause = 0;              ///< s at rest at each station but the last
};

class Move final : public Step {
 public:
  /// Throws std::invalid_argument when a station equals the one before, or there is none.
  explicit Move(MoveSpec spec);

  std::vector<std::string> tools() const override { return spec_.tools; }
  std::optional<double> duration() const override;
  ToolMotion motion(double time) const override;
  double stopping_time(double stop) const override;
  std::string description() const override;

 private:
  MoveSpec spec_;
  std::vector<StraightMove> legs_;
};

/// Reads a step of kind "move".
std::shared_ptr<Step> read_move(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
