// Changes what acts on the powder at one instant: gravity, contact laws, velocities. Takes no time.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/machine/step.h"
#include "process/machine/tool_spec.h"

namespace diefill::process {

struct ContactSpec;
struct PairLawSpec;

/// What is different from the instant on; nothing: as it was.
struct PowderChange {
  std::optional<Eigen::Vector3d> gravity;  ///< m/s^2
  std::optional<double> friction, wall_friction;
  std::optional<double> work_of_adhesion, wall_work_of_adhesion;  ///< J/m^2
  /// [contact] with the parts that the step names in place of the scene's.
  std::shared_ptr<const ContactSpec> contact;
  /// The same of [[other_powder]] and of pairs of powders, where `contact` is there.
  std::vector<std::shared_ptr<const ContactSpec>> contact_of_others;
  std::vector<std::shared_ptr<const PairLawSpec>> contact_of_pairs;
  bool at_rest = false;        ///< every grain comes to rest, before `random_velocity`
  double random_velocity = 0;  ///< m/s, standard deviation along each axis, added once to every grain

  bool changes_laws() const {
    return friction || wall_friction || work_of_adhesion || wall_work_of_adhesion || contact;
  }
};

class Change final : public Step {
 public:
  explicit Change(PowderChange change) : change_(std::move(change)) {}
  std::optional<double> duration() const override { return 0; }
  const PowderChange* change() const override { return &change_; }
  std::string description() const override;

 private:
  PowderChange change_;
};

/// Reads a step of kind "change", but for its [step.contact], which the scene reads (contact_spec.h).
std::shared_ptr<Step> read_change(TableReader& table, const std::vector<ToolSpec>& tools);

}  // namespace diefill::process
