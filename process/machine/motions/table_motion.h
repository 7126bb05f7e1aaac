// Motion along points of a table, as recorded on a machine: cubic Hermite curves through the points, at rest
// at both ends.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "process/machine/rotation_axis.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// Points in time and where they put the tool, relative to where the step finds it.
struct MotionTable {
  std::vector<double> time;               ///< s, rising, from 0
  std::vector<Eigen::Vector4d> position;  ///< m along x, y, z; rad about the axis
};

/// Reads a CSV file. Its first line names the columns with their units, such as `time s, x mm, angle deg`:
/// time, and one or more of x, y, z, angle, each once. Limits as of other motions (motion_limits.h).
/// `where` begins messages. Throws SceneError with file, line and column.
MotionTable read_motion_table(const std::filesystem::path& file, const std::string& where);

class TableMotion final : public Step {
 public:
  TableMotion(std::vector<std::string> tools, const RotationAxis& axis, MotionTable table);

  std::vector<std::string> tools() const override { return tools_; }
  std::optional<double> duration() const override { return table_.time.back(); }
  ToolMotion motion(double time) const override;
  std::string description() const override;

 private:
  std::vector<std::string> tools_;
  RotationAxis axis_;
  MotionTable table_;
  std::vector<Eigen::Vector4d> slope_;  ///< m/s and rad/s at the points
};

/// Reads a step of kind "table".
std::shared_ptr<Step> read_table_motion(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
