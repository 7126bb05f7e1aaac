// A free tool as the engine has it: mass, centre and moments of inertia from its CAD.
#pragma once

#include "engine/walls/free_body.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Of a step whose free_motion() is not null. Balls (WallKind::ball) are exact; other tools are as their
/// meshes have them, of one density.
engine::FreeBodySpec free_body_of(const Tooling& tooling, const Step& step);

}  // namespace diefill::process
