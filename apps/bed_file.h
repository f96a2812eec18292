// A bed of stones from a table (CSV): one stone a row, its centre and radius in metres; the header
// x,y,z,radius may stand before the first. A comment line (#) may name the radius of the cylinder
// that holds it, like cylinder_radius=0.05. The axis of the cylinder is z, its floor z = 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/mistakes.h"
#include "dem/vec3.h"

namespace apps {

struct BedFile {
  std::string path;
  std::optional<double> cylinder_radius;  // [m]
  std::vector<dem::Vec3d> position;       // of the centres [m]
  std::vector<double> radius;             // [m]
  std::vector<int> line;                  // on which each stone was written, from 1
};

// Reads the bed; rows that are not four numbers, and a bed without stones, are mistakes.
BedFile read_bed_file(const std::string& path, Mistakes& mistakes);

// Stones that overlap each other or the cylinder by more than `most` of the smaller stone's radius
// are mistakes; of each kind the deepest is named.
void check_overlaps(const BedFile& bed, double cylinder_radius, double most, Mistakes& mistakes);

}  // namespace apps
