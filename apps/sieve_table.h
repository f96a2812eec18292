// Reading a gradation: CSV with the header `sieve_mm,passing_percent`, one sieve a row from fine to
// coarse, `#` opening a comment line. The sieve is its opening, the percentage is of the mass.
#pragma once

#include <string>

#include "apps/mistakes.h"
#include "dem/gradation.h"

namespace apps {

// `asked` is where the file was named: that is what a missing file is a mistake of.
// The table is of use only if no mistake was added.
dem::SieveTable read_sieve_table(const std::string& path, const Place& asked, Mistakes& mistakes);

}  // namespace apps
