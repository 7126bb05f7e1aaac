// Bierwisch's law between the parts that any law is made of and the numbers that its tuned loops take. A
// scene names parts only; code that makes a loop checks whether they are Bierwisch's.
#pragma once

#include <optional>

#include "engine/laws/contact_parameters.h"
#include "engine/laws/law_parameters.h"

namespace diefill::engine::laws {

/// Bierwisch's law as the tuned loops take it.
struct BierwischLaw {
  ContactParameters parameters;
  SpringLimit spring_limit = SpringLimit::cut_back;
};

/// The law as parts: Hertz with cohesion, damping, friction, and rolling friction where it is not 0
/// (Bierwisch 2009, section 2.1).
LawParameters bierwisch_law(const ContactParameters& parameters,
                            SpringLimit spring_limit = SpringLimit::cut_back);

/// The way back; nothing where any part is another's.
std::optional<BierwischLaw> as_bierwisch(const LawParameters& law);

}  // namespace diefill::engine::laws
