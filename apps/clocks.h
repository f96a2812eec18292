// What time a program has taken.
#pragma once

namespace apps {

double wall_clock();       // [s] since some fixed moment, never backwards
double processor_clock();  // [s] of all threads of this process, user and system

// By a run, its earlier sessions included.
struct Spent {
  double wall = 0, processor = 0;  // [s]
};

}  // namespace apps
