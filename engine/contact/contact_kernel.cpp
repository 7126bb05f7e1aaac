#include "engine/contact/contact_kernel.h"

namespace diefill::engine {

std::optional<laws::BierwischLaw> tuned_law(const ParticleTypes& types, const ContactLaws& contact,
                                            const std::string& material) {
  if (types.classes().size() > 1 || contact.scaling.scale != 1) return std::nullopt;
  auto law = laws::as_bierwisch(contact.between(types.material(0), material));
  if (law && law->parameters.rolling_friction != 0 && types.clumps()) return std::nullopt;
  return law;
}

}  // namespace diefill::engine
