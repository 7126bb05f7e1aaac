// The parts that [contact] can name: every law of the engine under its name in scenes, with the keys it
// takes. A new part is registered by one entry in contact_parts.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/laws/law_parameters.h"
#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// One part of a kind; `Parameters`: such as AnyNormal::Parameters.
template <class Parameters>
struct ContactPart {
  std::string name;                    ///< what `law` says
  std::vector<std::string> of_powder;  ///< keys of [powder] that give what is left out
  /// Reads all its keys but `law`; linked ones that are missing are not numbers.
  std::function<Parameters(TableReader&, const PowderSpec&)> read;
  std::function<std::string(const Parameters&)> description;  ///< name and values
  /// As a scene may name it, such as { law = "Mindlin", friction = 0.5, shear_modulus = "5 MPa" }: with the
  /// keys that have no value of their own, also those that another part may give.
  std::string example;
};

template <class Parameters>
using ContactParts = std::vector<ContactPart<Parameters>>;

const ContactParts<engine::laws::AnyNormal::Parameters>& normal_parts();
const ContactParts<engine::laws::AnyDamping::Parameters>& damping_parts();
const ContactParts<engine::laws::AnyFriction::Parameters>& friction_parts();
const ContactParts<engine::laws::AnyRolling::Parameters>& rolling_parts();
const ContactParts<engine::laws::AnyAttraction::Parameters>& attraction_parts();

}  // namespace diefill::process
