// Every contact law of the sources in one type: the lists of parts, and the law that a pair gets from its
// parameters. A new part is registered by its line here.
#pragma once

#include "engine/laws/absent_parts.h"
#include "engine/laws/any_part.h"
#include "engine/laws/bierwisch_damping.h"
#include "engine/laws/bierwisch_normal.h"
#include "engine/laws/capillary_bridge.h"
#include "engine/laws/composed_law.h"
#include "engine/laws/constant_rolling.h"
#include "engine/laws/cundall_friction.h"
#include "engine/laws/edinburgh_normal.h"
#include "engine/laws/epsd2_rolling.h"
#include "engine/laws/hertz_mindlin_normal.h"
#include "engine/laws/jkr_normal.h"
#include "engine/laws/linear_damping.h"
#include "engine/laws/linear_normal.h"
#include "engine/laws/luding_friction.h"
#include "engine/laws/luding_normal.h"
#include "engine/laws/luding_rolling.h"
#include "engine/laws/mindlin_friction.h"
#include "engine/laws/own_spin_rolling.h"
#include "engine/laws/restitution_damping.h"
#include "engine/laws/van_der_waals.h"

namespace diefill::engine::laws {

using AnyNormal = AnyNormalOf<BierwischNormal,     //
                              HertzMindlinNormal,  //
                              LinearNormal,        //
                              LudingNormal,        //
                              EdinburghNormal,     //
                              JkrNormal>;
using AnyDamping = AnyDampingOf<NoDamping,           //
                                BierwischDamping,    //
                                RestitutionDamping,  //
                                ConstantDamping,     //
                                LinearRestitutionDamping>;
using AnyFriction = AnyFrictionOf<FreeSliding,      //
                                  CundallFriction,  //
                                  MindlinFriction,  //
                                  LudingFriction>;
using AnyRolling = AnyRollingOf<FreeRolling,     //
                                LoadRolling,     //
                                ElasticRolling,  //
                                Epsd2Rolling,    //
                                LudingRolling,   //
                                OwnSpinRolling>;
using AnyAttraction = AnyAttractionOf<NoAttraction,  //
                                      VanDerWaals,   //
                                      CapillaryBridge>;

using GeneralLaw = ComposedLaw<AnyNormal, AnyDamping, AnyFriction, AnyRolling, AnyAttraction>;

}  // namespace diefill::engine::laws
