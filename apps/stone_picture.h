// The stones of a run as a ParaView picture.
#pragma once

#include <string>
#include <vector>

#include "dem/particle_store.h"

namespace apps {

// coordination: touching neighbours of each stone, by place in the store.
void draw_stones(const std::string& vtp, const dem::ParticleStore& stones,
                 const std::vector<int>& coordination);

}  // namespace apps
