// A tool that nothing drives: it moves by its weight, the powder's forces and a constant force, freely or
// along a guide, until a stop holds it. Such as a falling ball, a floating punch, a flap.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/simulation/standard_gravity.h"
#include "engine/walls/free_body.h"
#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// The body as the scene describes it; the number of its body, and what follows from its CAD, are filled in
/// for a run (process/tooling/free_tool.h).
struct FreeMotion {
  engine::FreeBodySpec body;
  double density = 0;    ///< kg/m^3; 0: body.mass is given
  double record = 1e-3;  ///< s, between rows of its way in the results
};

/// Its motion as a function of time, used to see what the tool can reach, is that without powder.
class FreeTool final : public Step {
 public:
  FreeTool(std::string tool, const FreeMotion& free, std::optional<double> duration)
      : tool_(std::move(tool)), free_(free), duration_(duration) {}

  std::vector<std::string> tools() const override { return {tool_}; }
  bool open_ended() const override { return !duration_; }
  std::optional<double> duration() const override { return duration_; }
  std::shared_ptr<const Step> prepared(const MachineContext& context) const override;
  ToolMotion motion(double time) const override;
  double stopping_time(double) const override { return 0; }
  ToolMotion motion_stopped(double time, double stop) const override;
  const FreeMotion& free_motion() const { return free_; }
  std::string description() const override;

 private:
  std::string tool_;
  FreeMotion free_;
  std::optional<double> duration_;
  Eigen::Vector3d gravity_ = {0, 0, -engine::kStandardGravity};  ///< m/s^2
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();             ///< m, of the tool
};

/// Of a step that lets a tool move by the forces on it. Otherwise null.
const FreeMotion* free_motion_of(const Step& step);

/// Reads a step of kind "free motion".
std::shared_ptr<Step> read_free_motion(TableReader& table, const std::vector<ToolSpec>& tools);

/// Throws SceneError where a free tool has another step that moves it.
void refuse_driven_free_tools(const std::vector<std::shared_ptr<const Step>>& steps);

}  // namespace diefill::process
