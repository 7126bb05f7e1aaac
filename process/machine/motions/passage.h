// The shoe passes over the cavity, once or several times back and forth, as in die filling (Bierwisch 2009,
// chapter 6).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/motions/straight_move.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

/// Parameters of a passage from the scene. SI units.
struct PassageSpec {
  std::string tool;
  double velocity = 0.2;                                  ///< m/s, once accelerated
  double acceleration = 10;                               ///< m/s^2, also of braking
  int passages = 1;                                       ///< single crossings; every second one goes back
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitX();  ///< unit vector of the first crossing
  double clearance = 2e-3;       ///< m between the cavity and the tool's box when it stops
  double pause = 0.05;           ///< s at rest between crossings
  std::optional<double> travel;  ///< m of one crossing; otherwise from the boxes of cavity and tool
  std::string where;             ///< place in the scene file, for messages
};

/// Trapezoidal velocity (accelerate, cruise, brake) in each crossing, at rest in between.
class Passage final : public Step {
 public:
  explicit Passage(PassageSpec spec);

  /// Without a given travel, the tool moves until its whole box, trailing wall included, has passed the
  /// cavity by the clearance. The box is used because the thickness of a CAD tool's trailing wall is not
  /// known here; powder inside the tool has then left the cavity by wall thickness plus clearance. Throws
  /// SceneError when the scene has no cavity, or the tool stands beyond it already.
  std::shared_ptr<const Step> prepared(const MachineContext& context) const override;
  bool needs_cavity() const override { return true; }
  std::vector<std::string> tools() const override { return {spec_.tool}; }
  /// s of all crossings and the pauses between them. Throws std::logic_error where the travel is not known:
  /// of a passage without one that is not prepared().
  std::optional<double> duration() const override;
  ToolMotion motion(double time) const override;
  double stopping_time(double) const override { return 2 * spec_.velocity / spec_.acceleration; }
  std::string description() const override;

  const PassageSpec& spec() const { return spec_; }

 private:
  const StraightMove& crossing() const;

  PassageSpec spec_;
  std::optional<StraightMove> crossing_;
};

/// Reads a step of kind "passage". The tool must be one of `tools` and a shoe or a plate.
std::shared_ptr<Step> read_passage(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
